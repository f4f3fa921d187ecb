#include "scree/cycles/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include <scree/signals/time_series.hpp>

namespace scree::cycles {

namespace {

// Warns of a period that is a multiple of the load's: half of the load's cycles or more are not seen then.
std::string warning_of_multiple(const CyclesSource& source) {
  const double of_stage = source.stage_period > 0 ? std::round(source.period / source.stage_period) : 0;
  const bool is_multiple =
      of_stage > 0 && std::abs(source.period - of_stage * source.stage_period) < 1e-6 * source.period;
  // The stage may have another load than the given one; its period counts.
  const double count = is_multiple ? of_stage : double(source.series.load_periods);
  if (!(count > 1)) return "";
  return fmt::format(
      "in each {:.10g} s the load has {} periods; give --period {:.10g} to see each of its cycles",
      source.period, count, source.period / count);
}

double range_of(std::span<const double> values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

}  // namespace

std::vector<std::string> warnings_of_source(const CyclesSource& source) {
  std::vector<std::string> warnings;
  if (!source.status.empty())
    warnings.push_back(fmt::format("the run is {}: these are its cycles so far", source.status));
  if (const std::string warning = warning_of_multiple(source); !warning.empty()) warnings.push_back(warning);
  if (const std::string warning = signals::cut_line_warning(source.cut_line); !warning.empty())
    warnings.push_back(warning);
  return warnings;
}

std::string warning_of_loads(const CyclesSource& source, const Classification& found, std::size_t drop) {
  // Over the range of the load in a cycle. The area of a ratcheting sample changes a stress by 1e-8 of it.
  constexpr double same_load = 1e-4;
  constexpr double counts = 0.1;  // over the range of the strain
  const CycleSeries& series = source.series;
  if (series.load.empty()) return "";
  const auto [least, most] = std::minmax_element(series.load.begin(), series.load.end());
  const double stiffness = std::abs(series.loops.back().stiffness);
  const double differences = range_of(std::span(series.load).subspan(drop));
  // With fewer than three samples in a cycle its range is not known.
  const double range =
      std::isnan(stiffness) ? std::max(std::abs(*least), std::abs(*most)) : series.loops.back().load_range;
  if (!(differences > same_load * range) || differences < counts * stiffness * found.range) return "";
  return fmt::format(
      "the load at the minima differs by up to {:.2g} from cycle to cycle, and the strain with it; give the "
      "exact --period and --start, or more samples, unless the load is meant to change",
      differences);
}

}  // namespace scree::cycles
