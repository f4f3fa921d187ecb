#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include <scree/energy.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::scenario {

namespace {

struct RunQuantity {
  const char* name;
  double (*value)(const Simulation&, const scree_energy&);
  bool audited = false;  // by the energy audit alone
};

constexpr RunQuantity quantities_of_run[] = {
    {"steps", [](const Simulation& s, const scree_energy&) { return double(s.steps()); }},
    {"time", [](const Simulation& s, const scree_energy&) { return s.time(); }},
    {"energy_residual", [](const Simulation& s, const scree_energy&) { return s.energy_residual(); }, true},
    {"energy_created", [](const Simulation& s, const scree_energy&) { return s.energy_created(); }, true},
    {"momentum_residual", [](const Simulation& s, const scree_energy&) { return s.momentum_residual(); }},
    {"max_overlap_ratio", [](const Simulation& s, const scree_energy&) { return s.max_overlap_ratio(); }},
    {"min_steps_per_contact",
     [](const Simulation& s, const scree_energy&) { return s.min_steps_per_contact(); }},
    {"kinetic_energy", [](const Simulation&, const scree_energy& e) { return kinetic_energy(e); }},
    {"elastic_energy", [](const Simulation&, const scree_energy& e) { return elastic_energy(e); }, true},
    {"dissipated_energy", [](const Simulation&, const scree_energy& e) { return dissipated_energy(e); },
     true},
    {"work", [](const Simulation&, const scree_energy& e) { return e.work; }, true},
    {"neighbour_searches", [](const Simulation& s, const scree_energy&) { return double(s.rebuilds()); }},
};

}  // namespace

std::vector<std::pair<std::string, double>> run_quantities(const Simulation& simulation) {
  const scree_energy energy = simulation.energy();
  std::vector<std::pair<std::string, double>> values;
  for (const RunQuantity& q : quantities_of_run) {
    const bool known = simulation.scene().audit || !q.audited;
    values.emplace_back(q.name,
                        known ? q.value(simulation, energy) : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

std::vector<std::string> run_quantity_names() {
  std::vector<std::string> names;
  for (const RunQuantity& q : quantities_of_run) names.push_back(q.name);
  return names;
}

bool needs_energy_audit(const std::string& quantity) {
  return std::any_of(std::begin(quantities_of_run), std::end(quantities_of_run),
                     [&](const RunQuantity& q) { return q.audited && q.name == quantity; });
}

double series_statistic(const std::vector<double>& values, const std::string& statistic) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return nan;
  if (statistic == "first") return values.front();
  if (statistic == "last_number") {
    const auto number = std::find_if(values.rbegin(), values.rend(), [](double x) { return !std::isnan(x); });
    return number == values.rend() ? nan : *number;
  }
  const bool ordered = statistic == "min" || statistic == "max";
  // Comparisons pass over NaN.
  if (ordered && std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }))
    return nan;
  if (statistic == "min") return *std::min_element(values.begin(), values.end());
  if (statistic == "max") return *std::max_element(values.begin(), values.end());
  if (statistic == "mean") return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  return values.back();
}

SeriesQuantity series_quantity(const std::string& name) {
  const auto first = name.find('.'), last = name.rfind('.');
  return {name.substr(0, first), name.substr(first + 1, last - first - 1), name.substr(last + 1)};
}

}  // namespace scree::scenario
