#include "studies/cycles_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

using cycles::Class, cycles::Classification, cycles::CyclesResult, cycles::LatestTouch, cycles::Rattler;

// At most twelve numbers.
std::string outliers_of(const Classification& c) {
  constexpr std::size_t most = 12;
  if (c.outliers.empty()) return "none";
  const auto end = c.outliers.begin() + std::ptrdiff_t(std::min(most, c.outliers.size()));
  return fmt::format("cycles {}{}", fmt::join(c.outliers.begin(), end, ", "),
                     c.outliers.size() > most ? fmt::format(", ... ({})", c.outliers.size()) : "");
}

// Means over the cycles that count.
void print_loops(const CyclesResult& r) {
  const auto& loops = r.source.series.loops;
  if (loops.empty()) return;
  double area = 0, stiffness = 0;
  for (std::size_t n = r.drop; n < loops.size(); ++n) {
    area += loops[n].area / double(loops.size() - r.drop);
    stiffness += loops[n].stiffness / double(loops.size() - r.drop);
  }
  if (std::isnan(area))
    fmt::print("{:<14}no area: fewer than three samples in a cycle\n", "loops");
  else
    fmt::print("{:<14}mean area {:.6g}, stiffness {:.6g}; of the first cycle {:.6g}, {:.6g}\n", "loops", area,
               stiffness, loops[0].area, loops[0].stiffness);
}

// How long before its minimum a rattler last touched: of the outliers, or of the other cycles that count.
std::string touches_of(const CyclesResult& r, bool of_outliers) {
  std::vector<double> before;
  for (std::size_t n = r.drop; n < r.rattlers->touches.size(); ++n)
    if (std::binary_search(r.found.outliers.begin(), r.found.outliers.end(), n) == of_outliers)
      before.push_back(r.rattlers->touches[n].before);
  if (before.empty()) return "none";
  std::sort(before.begin(), before.end());
  return fmt::format("{:.3g} s before the minimum (median of {}; {:.3g} to {:.3g} s)",
                     before[before.size() / 2], before.size(), before.front(), before.back());
}

void print_rattlers(const CyclesResult& r) {
  constexpr std::size_t most = 12;
  std::string names;
  for (const Rattler& body : r.rattlers->bodies)
    names += fmt::format("{}body {} (touches in {:.2g} % of the observations)", names.empty() ? "" : ", ",
                         body.id, 100 * body.share);
  fmt::print("{:<14}{}\n", "rattlers", names.empty() ? "none" : names);
  if (r.rattlers->touches.empty()) return;
  fmt::print("{:<14}outliers: {}\n", "last touch", touches_of(r, true));
  fmt::print("{:<14}other cycles: {}\n", "", touches_of(r, false));
  for (std::size_t k = 0; k < std::min(most, r.found.outliers.size()); ++k) {
    const LatestTouch& touch = r.rattlers->touches[r.found.outliers[k]];
    fmt::print("{:<14}cycle {}: body {} {:.3g} s before its minimum\n", "", r.found.outliers[k], touch.body,
               touch.before);
  }
}

}  // namespace

void print_summary(const CyclesResult& r) {
  const Classification& c = r.found;
  const std::string period = r.source.period > 0 ? fmt::format("of {:.10g} s ", r.source.period) : "";
  fmt::print("{}: {}, {} {}from {:.10g} s, {} dropped\n", files::escaped(r.source.file.string()),
             files::one_line(r.source.strain), counted(r.source.series.strain.size() - 1, "cycle"), period,
             r.source.minimum_times.front(), r.drop);
  fmt::print("{:<14}{:.4e} ± {:.1e} per cycle; of the median {:.4e}\n", "slope", c.line.slope,
             c.line.slope_error, c.robust.slope);
  fmt::print("{:<14}{:.3e} rms from the straight line, {} the slope per cycle\n", "deviation", c.line.rms,
             c.line.ratchets() ? "below" : "not below");
  fmt::print("{:<14}{:.3e}\n", "range", c.range);
  fmt::print("{:<14}{}\n", "outliers", outliers_of(c));
  print_loops(r);
  if (r.rattlers) print_rattlers(r);
  fmt::print("{:<14}{}: {}\n", "class", class_name(c.kind), c.reason);
}

void print_line(const CyclesResult& r, std::size_t width) {
  fmt::print("{:<{}}  {:<15}  slope {:>11.3e}  rms {:>9.2e}  range {:>9.2e}  outliers {}\n",
             files::escaped(r.name), width, class_name(r.found.kind), r.found.line.slope, r.found.line.rms,
             r.found.range, r.found.outliers.size());
}

void print_counts(const std::vector<CyclesResult>& results) {
  std::array<std::size_t, cycles::classes> counts{};
  std::size_t up = 0;
  double logarithms = 0;
  for (const CyclesResult& r : results) {
    ++counts[std::size_t(r.found.kind)];
    if (r.found.kind != Class::ratcheting) continue;
    up += r.found.line.slope > 0;
    logarithms += std::log(std::abs(r.found.line.slope));
  }
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k)
    text += fmt::format("{}{} {}", k > 0 ? ", " : "", counts[k], class_name(Class(k)));
  fmt::print("{}: {}\n", counted(results.size(), "run"), text);
  const std::size_t ratcheting = counts[std::size_t(Class::ratcheting)];
  if (ratcheting > 0)
    fmt::print("ratcheting: geometric mean of |slope| {:.4e} per cycle; {} with slopes above 0, {} below\n",
               std::exp(logarithms / double(ratcheting)), up, ratcheting - up);
}

}  // namespace scree::tool
