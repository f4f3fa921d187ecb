#pragma once

#include <vector>

#include <scree/run/verdict.hpp>

namespace scree::tool {

// Prints a line for each expectation; quiet: only for those that are not met. Returns whether all are met.
bool report_verdicts(const std::vector<run::Verdict>& verdicts, bool quiet);

}  // namespace scree::tool
