#include "cycles_warnings.hpp"

#include <cmath>

#include <fmt/format.h>

namespace scree::tool {

namespace {

// With a multiple of the load's period half of its cycles or more are not seen.
std::string of_multiple(const CyclesSource& source) {
  const double of_stage = source.stage_period > 0 ? std::round(source.period / source.stage_period) : 1;
  const bool is_multiple = std::abs(source.period - of_stage * source.stage_period) < 1e-6 * source.period;
  const double count = is_multiple && of_stage > 1 ? of_stage : double(source.series.load_periods);
  if (!(count > 1)) return "";
  return fmt::format(
      "in each {:.10g} s the load has {} periods; give --period {:.10g} to see each of its cycles",
      source.period, count, source.period / count);
}

// What the load drifts by from cycle to cycle strains an elastic sample too.
std::string of_drift(const CyclesSource& source, const cycles::Classification& found, std::size_t drop) {
  constexpr double counts = 0.1;      // of the strain per cycle
  constexpr double significant = 5;   // standard errors
  constexpr double round_off = 1e-9;  // of the range of the load
  const cycles::CycleSeries& series = source.series;
  if (series.load.empty() || !(std::abs(series.loops.back().stiffness) > 0)) return "";
  const auto load = cycles::fit_line(std::span(series.load).subspan(drop), double(drop));
  const double strain = load.slope / series.loops.back().stiffness;
  if (!(std::abs(load.slope) > significant * load.slope_error) ||
      !(std::abs(strain) > counts * std::abs(found.line.slope)) ||
      !(std::abs(strain) > round_off * found.range))
    return "";
  return fmt::format(
      "the load at its minima changes by {:.3g} per cycle, which strains the sample by {:.3g}, of {:.3g} per cycle in all; give the exact "
      "--period and --start of the load",
      load.slope, strain, found.line.slope);
}

}  // namespace

std::vector<std::string> cycles_warnings(const CyclesSource& source, const cycles::Classification& found,
                                         std::size_t drop) {
  std::vector<std::string> warnings;
  if (!source.status.empty() && source.status != "finished")
    warnings.push_back(fmt::format("the run is {}: these are its cycles so far", source.status));
  for (const std::string& warning : {of_multiple(source), of_drift(source, found, drop)})
    if (!warning.empty()) warnings.push_back(warning);
  return warnings;
}

}  // namespace scree::tool
