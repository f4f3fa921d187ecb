#include <cmath>

#include <fmt/format.h>

#include <scree/files/csv_line.hpp>

namespace scree::files {

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (!line.empty() || &cell != &cells.front()) line += ',';
    if (cell.find_first_of(",\"\r\n") == std::string::npos) {
      line += cell;
      continue;
    }
    line += '"';
    for (const char c : cell) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\n";
}

std::string csv_number(double number) { return std::isfinite(number) ? fmt::format("{}", number) : ""; }

}  // namespace scree::files
