#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <scree/files/csv_rows.hpp>

namespace scree::report {

// A small table of results with its words, as peaks.csv; empty if there is none, and without what is behind
// the first line that cannot be read.
class TextTable {
 public:
  explicit TextTable(const std::filesystem::path& file);

  std::size_t rows() const { return rows_.size(); }
  const std::vector<files::CsvRows::Column>& columns() const { return columns_; }
  bool has(const std::string& column) const { return index_.contains(column); }
  // Empty, or NaN, if there is no such column.
  const std::string& text(std::size_t row, const std::string& column) const;
  double number(std::size_t row, const std::string& column) const;

 private:
  std::vector<files::CsvRows::Column> columns_;
  std::map<std::string, std::size_t> index_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace scree::report
