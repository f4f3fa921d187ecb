#pragma once

#include <cstddef>
#include <string>

namespace scree::tool {

// "<name> [<unit>]" in one line; the name alone without a unit.
std::string with_unit(const std::string& name, const std::string& unit);

// That the last line of the file of a series has no line break: "line 7 ...; <cure>"; empty if it has one (cut_line 0).
std::string warning_of_cut_line(std::size_t cut_line);

}  // namespace scree::tool
