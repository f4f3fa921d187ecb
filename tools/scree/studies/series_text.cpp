#include "studies/series_text.hpp"

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::tool {

std::string with_unit(const std::string& name, const std::string& unit) {
  return files::one_line(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
}

std::string warning_of_cut_line(std::size_t cut_line) {
  if (cut_line == 0) return "";
  return fmt::format(
      "line {}, the last, has no line break, so that its last number may be cut off; check it, and end the line",
      cut_line);
}

}  // namespace scree::tool
