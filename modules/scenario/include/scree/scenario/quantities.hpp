#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <scree/simulation.hpp>

namespace scree::scenario {

// Statistics of a series, for use in expectations.
inline constexpr std::array<const char*, 6> series_statistics = {"last", "last_number", "first",
                                                                 "min",  "max",         "mean"};

// NaN for an empty series.
double series_statistic(const std::vector<double>& values, const std::string& statistic);

// The parts of a quantity "<probe>.<column>.<statistic>".
struct SeriesQuantity {
  std::string probe, column, statistic;
};
SeriesQuantity series_quantity(const std::string& name);

// Quantities that every run reports in run.json, by name. NaN for quantities of the energy audit, in a scene
// without it.
std::vector<std::pair<std::string, double>> run_quantities(const Simulation& simulation);
std::vector<std::string> run_quantity_names();
bool needs_energy_audit(const std::string& quantity);

}  // namespace scree::scenario
