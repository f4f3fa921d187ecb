#pragma once

#include <string>
#include <vector>

namespace scree::files {

// One line of a CSV file; cells with a comma, a quote or a line end are quoted.
std::string csv_line(const std::vector<std::string>& cells);

// Shortest form that reads back to the same bits; empty if the number is not finite (missing: NaN).
std::string csv_number(double number);

}  // namespace scree::files
