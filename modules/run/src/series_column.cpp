#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/run/series_column.hpp>

namespace scree::run {

namespace {

// Cell of a line, from 0; empty if there are fewer.
std::string_view cell_of(std::string_view line, std::size_t number) {
  for (; number > 0; --number) {
    const std::size_t comma = line.find(',');
    if (comma == line.npos) return "";
    line.remove_prefix(comma + 1);
  }
  return line.substr(0, line.find(','));
}

std::size_t cells_in(std::string_view line) {
  return 1 + std::size_t(std::count(line.begin(), line.end(), ','));
}

// Number of the column in the header, without units.
std::optional<std::size_t> find_column(std::string_view header, const std::string& name) {
  for (std::size_t k = 0; k < cells_in(header); ++k)
    if (const std::string_view cell = cell_of(header, k); cell.substr(0, cell.find(" [")) == name) return k;
  return std::nullopt;
}

std::optional<double> number_of(std::string_view cell) {
  double value = 0;
  const char* end = cell.data() + cell.size();
  const auto [read_to, code] = std::from_chars(cell.data(), end, value);
  return code == std::errc() && read_to == end ? std::optional(value) : std::nullopt;
}

}  // namespace

std::vector<double> series_column(const std::filesystem::path& file, const std::string& name,
                                  const std::string& cure) {
  const auto damage = [&](const std::string& what) {
    return Error(fmt::format("{}: {}; {}", file.string(), what, cure), ExitStatus::failure);
  };
  std::error_code failed;
  const bool regular = std::filesystem::is_regular_file(file, failed);
  std::ifstream stream(file, std::ios::binary);
  if (!regular || !stream) throw damage("cannot be read");
  std::string line;
  const auto next = [&] {
    if (!std::getline(stream, line)) return false;
    if (stream.eof()) throw damage("is cut off");
    return true;
  };
  if (!next()) throw damage("is empty");
  const std::size_t width = cells_in(line);
  const auto column = find_column(line, name);
  if (!column) throw damage(fmt::format("has no column {}", name));
  std::vector<double> values;
  for (std::size_t number = 2; next(); ++number) {
    if (cells_in(line) != width)
      throw damage(fmt::format("line {} has {} cells instead of {}", number, cells_in(line), width));
    const std::string_view cell = cell_of(line, *column);
    const auto value = number_of(cell);
    if (!value) throw damage(fmt::format("line {} is damaged at '{}'", number, files::one_line(cell, 40)));
    values.push_back(*value);
  }
  return values;
}

}  // namespace scree::run
