#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <scree/files/text_line.hpp>

namespace scree::files {

// The rows of a CSV file, of which one is in memory at a time. The first line that is neither blank nor a comment
// ('#') names the columns, with units if it likes: "time [s]". Every failure throws Error with file, line and cure.
class CsvRows : public TextLine {
 public:
  struct Column {
    std::string name, unit;  // the unit is empty if the header has none
  };

  // Opens a regular file and reads its header.
  explicit CsvRows(const std::filesystem::path& path);

  const std::vector<Column>& columns() const { return columns_; }
  // Number of the column with this name, given with its unit or without.
  std::size_t column(std::string_view name) const;

  // Goes to the next row, past blank lines and comments; false at the end of the file.
  bool next();
  // The finite number in a column of the row.
  double number(std::size_t column) const;
  // The same, which may be infinite or NaN too.
  double any_number(std::size_t column) const;
  // The text in a column of the row.
  std::string text(std::size_t column) const;
  // Whether the row, or the header before the first, ends with a line break; the last of a file that was cut off does not.
  bool is_whole() const { return whole_; }

 private:
  bool next_line();
  void read_header();

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::string text_;
  bool whole_ = false;
  const std::vector<Token>* row_ = nullptr;
  std::vector<Column> columns_;
  std::vector<std::string> labels_;  // names for messages
};

}  // namespace scree::files
