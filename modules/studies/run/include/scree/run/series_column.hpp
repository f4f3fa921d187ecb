#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::run {

// A column of the CSV file of a series, by its name without unit, with the bits that were written. Throws Error
// "<file>: <what is wrong>; <cure>" if it is missing, or a line is not as a run wrote it.
std::vector<double> series_column(const std::filesystem::path& file, const std::string& name,
                                  const std::string& cure);

}  // namespace scree::run
