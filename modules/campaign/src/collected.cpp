#include "collected.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::campaign {

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

Error damage(const std::filesystem::path& series, const std::string& what) {
  return Error(fmt::format("{}: {}; run the campaign with --overwrite", series.string(), what));
}

double number_in(const std::string& cell, const std::filesystem::path& series, std::size_t line) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end)
    throw damage(series, fmt::format("line {} is damaged at '{}'", line, files::one_line(cell, 40)));
  return value;
}

// A column by its name without unit. Throws Error if it is missing, or a line is not as the run wrote it.
std::vector<double> column_of(const std::filesystem::path& series, const std::string& name) {
  const std::string text = files::read_text(series);
  if (!text.ends_with('\n')) throw damage(series, "is cut off");
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = cells_of(line);
  const auto found = std::find_if(header.begin(), header.end(), [&](const std::string& cell) {
    return cell.substr(0, cell.find(" [")) == name;
  });
  if (found == header.end()) throw damage(series, fmt::format("has no column {}", name));
  std::vector<double> values;
  for (std::size_t number = 2; std::getline(lines, line); ++number) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != header.size())
      throw damage(series,
                   fmt::format("line {} has {} cells instead of {}", number, cells.size(), header.size()));
    values.push_back(number_in(cells[std::size_t(found - header.begin())], series, number));
  }
  return values;
}

}  // namespace

std::vector<std::pair<std::string, double>> collected(const std::filesystem::path& directory,
                                                      const std::vector<std::string>& names,
                                                      std::vector<std::string>& damaged) {
  std::vector<std::pair<std::string, double>> numbers;
  for (const std::string& name : names) {
    const scenario::SeriesQuantity of = scenario::series_quantity(name);
    try {
      const std::vector<double> values = column_of(directory / "series" / (of.probe + ".csv"), of.column);
      if (!values.empty()) numbers.emplace_back(name, scenario::series_statistic(values, of.statistic));
    } catch (const Error& error) {
      if (std::find(damaged.begin(), damaged.end(), error.what()) == damaged.end())
        damaged.push_back(error.what());
    }
  }
  return numbers;
}

}  // namespace scree::campaign
