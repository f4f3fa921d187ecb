#include "text_table.hpp"

#include "numbers.hpp"

#include <scree/error.hpp>

namespace scree::report {

TextTable::TextTable(const std::filesystem::path& file) {
  constexpr std::uintmax_t largest = 16u << 20;  // (bytes)
  std::error_code failed;
  if (std::filesystem::file_size(file, failed) > largest || failed) return;
  try {
    files::CsvRows rows(file);
    columns_ = rows.columns();
    for (std::size_t k = 0; k < columns_.size(); ++k) index_.emplace(columns_[k].name, k);
    while (rows.next() && rows.is_whole()) {
      rows_.emplace_back();
      for (const files::Token& cell : rows.row()) rows_.back().emplace_back(cell.text);
    }
  } catch (const Error&) {
    // The line that a study is about to write.
  }
}

const std::string& TextTable::text(std::size_t row, const std::string& column) const {
  static const std::string none;
  const auto found = index_.find(column);
  return found == index_.end() || found->second >= rows_[row].size() ? none : rows_[row][found->second];
}

double TextTable::number(std::size_t row, const std::string& column) const {
  return parsed(text(row, column));
}

}  // namespace scree::report
