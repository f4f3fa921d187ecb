#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/accuracy/study.hpp>

namespace scree::accuracy {

double Quantity::scale() const {
  if (chosen_scale > 0) return chosen_scale;
  return reference != 0 ? std::abs(reference) : 1;
}

std::size_t SettingResult::worst_quantity() const {
  return std::size_t(std::max_element(errors.begin(), errors.end()) - errors.begin());
}

double SettingResult::worst() const { return errors.empty() ? 0 : errors[worst_quantity()]; }

const SettingResult* cheapest(const Convergence& study) {
  const SettingResult* best = nullptr;
  for (const SettingResult& o : study.outcomes)
    if (o.problem.empty() && o.worst() <= study.tolerance && (!best || o.wall_time < best->wall_time))
      best = &o;
  return best;
}

std::vector<const SettingResult*> pareto_front(const Convergence& study,
                                               std::optional<std::size_t> quantity) {
  constexpr double gain = 1.05;
  std::vector<const SettingResult*> front;
  for (const SettingResult& o : study.outcomes)
    if (o.problem.empty()) front.push_back(&o);
  std::sort(front.begin(), front.end(), [&](const SettingResult* a, const SettingResult* b) {
    return a->wall_time != b->wall_time ? a->wall_time < b->wall_time
                                        : a->error(quantity) < b->error(quantity);
  });
  double best = std::numeric_limits<double>::infinity();
  std::erase_if(front, [&](const SettingResult* o) {
    if (o->error(quantity) * gain >= best) return true;
    best = o->error(quantity);
    return false;
  });
  return front;
}

}  // namespace scree::accuracy
