#include "support/verdict_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

void print_unmet(const run::Verdict& v) {
  const scenario::Expectation& e = v.expectation;
  std::string wanted;
  if (e.reference)
    wanted += fmt::format(", expected {} ± {:g}, off by {:.3g}", *e.reference, *e.tolerance,
                          v.value - *e.reference);
  if (e.at_most) wanted += fmt::format(", expected at most {}", *e.at_most);
  if (e.at_least) wanted += fmt::format(", expected at least {}", *e.at_least);
  fmt::print("NOT MET  {} ({} = {}{})\n", files::escaped(e.requirement), e.quantity, v.value, wanted);
}

}  // namespace

bool report_verdicts(const std::vector<run::Verdict>& verdicts, bool quiet) {
  for (const run::Verdict& v : verdicts)
    if (v.met && !quiet)
      fmt::print("met      {} ({} = {:.6g})\n", files::escaped(v.expectation.requirement),
                 v.expectation.quantity, v.value);
  // What is not met is told even to those who asked for quiet.
  for (const run::Verdict& v : verdicts)
    if (!v.met) print_unmet(v);
  return std::all_of(verdicts.begin(), verdicts.end(), [](const auto& v) { return v.met; });
}

}  // namespace scree::tool
