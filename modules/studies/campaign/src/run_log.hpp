#pragma once

#include <filesystem>
#include <string>

namespace scree::campaign {

// Reason why a run has not finished: the last line "scree: ..." of its log without that prefix, else its last
// line; then `how` its process ended, in brackets.
std::string problem_of(const std::filesystem::path& log, const std::string& how);

// Progress of a run, 0 to 1, from the last progress line of its log, " 42 %  ..."; 0 if there is none.
double share_in(const std::filesystem::path& log);

}  // namespace scree::campaign
