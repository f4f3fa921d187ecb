#pragma once

#include <cstddef>
#include <vector>

#include <scree/cycles/result_files.hpp>

namespace scree::tool {

// Prints the summary of one series.
void print_summary(const cycles::CyclesResult& result);

// Prints a line of the table of several. width: characters of the name.
void print_line(const cycles::CyclesResult& result, std::size_t width);

// Prints how many are of each class, and the mean slope of those that ratchet.
void print_counts(const std::vector<cycles::CyclesResult>& results);

}  // namespace scree::tool
