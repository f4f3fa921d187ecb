#include <algorithm>
#include <limits>
#include <numeric>

#include <scree/scenario/run_quantities.hpp>

namespace scree::scenario {

std::vector<std::pair<std::string, double>> run_quantities(const Simulation& s) {
  const scree_energy e = s.energy();
  return {{"steps", double(s.steps())},
          {"time", s.time()},
          {"energy_residual", s.energy_residual()},
          {"energy_created", s.energy_created()},
          {"momentum_residual", s.momentum_residual()},
          {"max_overlap_ratio", s.max_overlap_ratio()},
          {"min_steps_per_contact", s.min_steps_per_contact()},
          {"kinetic_energy", kinetic_energy(e)},
          {"elastic_energy", elastic_energy(e)},
          {"dissipated_energy", dissipated_energy(e)},
          {"work", e.work},
          {"neighbour_searches", double(s.rebuilds())}};
}

std::vector<std::string> run_quantity_names() {
  return {"steps",
          "time",
          "energy_residual",
          "energy_created",
          "momentum_residual",
          "max_overlap_ratio",
          "min_steps_per_contact",
          "kinetic_energy",
          "elastic_energy",
          "dissipated_energy",
          "work",
          "neighbour_searches"};
}

double series_statistic(const std::vector<double>& values, const std::string& statistic) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (statistic == "first") return values.front();
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
