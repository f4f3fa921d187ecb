#pragma once

#include <filesystem>
#include <string>

namespace scree::campaign {

// Why a run has not finished, from its log and how its process ended: its line "scree: ..." without that
// word, else the last line, and `how` in brackets.
std::string problem_of(const std::filesystem::path& log, const std::string& how);

// How far a run is, 0 to 1, from the last progress line of its log, " 42 %  ..."; 0 if it has none.
double share_in(const std::filesystem::path& log);

}  // namespace scree::campaign
