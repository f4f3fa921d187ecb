#include "collected.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <scree/scenario/quantities.hpp>

namespace scree::campaign {

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

// A column by its name without unit; empty if it does not exist.
std::vector<double> column_of(const std::filesystem::path& series, const std::string& name) {
  std::ifstream file(series, std::ios::binary);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = cells_of(line);
  const auto found = std::find_if(header.begin(), header.end(), [&](const std::string& cell) {
    return cell.substr(0, cell.find(" [")) == name;
  });
  const auto at = std::size_t(found - header.begin());
  std::vector<double> values;
  while (std::getline(file, line))
    if (const std::vector<std::string> cells = cells_of(line); at < cells.size())
      values.push_back(std::strtod(cells[at].c_str(), nullptr));
  return values;
}

}  // namespace

std::vector<std::pair<std::string, double>> collected(const std::filesystem::path& directory,
                                                      const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, double>> numbers;
  for (const std::string& name : names) {
    const scenario::SeriesQuantity of = scenario::series_quantity(name);
    const std::vector<double> values = column_of(directory / "series" / (of.probe + ".csv"), of.column);
    if (!values.empty()) numbers.emplace_back(name, scenario::series_statistic(values, of.statistic));
  }
  return numbers;
}

}  // namespace scree::campaign
