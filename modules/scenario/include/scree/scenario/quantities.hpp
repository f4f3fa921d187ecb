#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <scree/simulation.hpp>

namespace scree::scenario {

// Statistics of a series that an expectation may ask for.
inline constexpr std::array<const char*, 5> series_statistics = {"last", "first", "min", "max", "mean"};

// Not a number where there is no value.
double series_statistic(const std::vector<double>& values, const std::string& statistic);

// A quantity of a series, "<probe>.<column>.<statistic>", taken apart.
struct SeriesQuantity {
  std::string probe, column, statistic;
};
SeriesQuantity series_quantity(const std::string& name);

// Numbers that every run reports about itself, by name, as they stand in run.json.
std::vector<std::pair<std::string, double>> run_quantities(const Simulation& simulation);
std::vector<std::string> run_quantity_names();

}  // namespace scree::scenario
