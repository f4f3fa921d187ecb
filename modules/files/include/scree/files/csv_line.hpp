#pragma once

#include <string>
#include <vector>

namespace scree::files {

// One line of a CSV file; what holds a comma, a quote or a line end is quoted.
std::string csv_line(const std::vector<std::string>& cells);

// Shortest form that reads back the same bits; empty where the number is missing or not finite.
std::string csv_number(double number);

}  // namespace scree::files
