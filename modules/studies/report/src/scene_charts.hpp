#pragma once

#include "figures.hpp"
#include "results.hpp"

#include <map>

#include <scree/scenario/charts.hpp>

namespace scree::report {

// Columns of the tables of results, each file read once. Numbers only: other cells are NaN, and what is
// behind the first line that cannot be read, such as the last one of a run that goes on, is left out.
class Columns {
 public:
  explicit Columns(std::map<std::string, std::filesystem::path> tables) : tables_(std::move(tables)) {}

  // Empty if the table has no such column, or no rows. Throws Error for a file of more than 256 MB.
  const std::vector<double>& of(const std::string& table, const std::string& column);
  // Names and units of the tables that have any.
  const std::vector<scenario::ProbeColumns>& tables();

 private:
  using Table = std::map<std::string, std::vector<double>>;
  const Table& read(const std::string& table);

  std::map<std::string, std::filesystem::path> tables_;
  std::map<std::string, Table> read_;
  std::vector<scenario::ProbeColumns> columns_;
};

// Draws the charts that the scenario has. Returns whether it has any.
bool add_scene_charts(const Results& results, Columns& columns, Figures& figures);

// Draws the energies over time, those that matter, where a probe has recorded eight samples or more.
void add_energy_chart(Columns& columns, Figures& figures);

}  // namespace scree::report
