#include "steps.hpp"

#include <algorithm>
#include <cmath>

namespace scree::accuracy {

namespace {
constexpr double rounding = 1e-9;
}

bool divides_durations(const scenario::Plan& plan, double step) {
  return std::all_of(plan.stages.begin(), plan.stages.end(), [step](const Stage& stage) {
    const double steps = stage.duration.value_or(0) / step;
    return std::abs(steps - std::round(steps)) <= rounding * std::max(1.0, steps);
  });
}

double fitting_step(const scenario::Plan& plan, double step) {
  double shortest = 0;
  for (const Stage& stage : plan.stages)
    if (stage.duration && (shortest == 0 || *stage.duration < shortest)) shortest = *stage.duration;
  if (shortest == 0) return step;
  const double fitting = shortest / std::max(1.0, std::ceil(shortest / step * (1 - rounding)));
  return divides_durations(plan, fitting) ? fitting : step;
}

}  // namespace scree::accuracy
