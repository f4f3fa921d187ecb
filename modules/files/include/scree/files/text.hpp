#pragma once

#include <string>
#include <string_view>

namespace scree::files {

// Text fit for one line of a message: control characters escaped, cut at `longest` bytes with "..." behind.
std::string one_line(std::string_view text, std::size_t longest = 80);

}  // namespace scree::files
