#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace scree::report {

// The page of results, in their directory.
inline constexpr const char* file_name = "report.html";

// One HTML page, which needs no other file, of the results in a directory: those of a run, a study or a
// campaign, as they are by now. What is missing or damaged is left out. Throws Error (bad_input) if the
// directory has no record of results.
std::string page_of(const std::filesystem::path& directory);

// Whether a text is such a page, so that it may be replaced.
bool is_page(std::string_view text);

}  // namespace scree::report
