#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <scree/files/text_reader.hpp>

namespace scree::files {

// The rows of a CSV file. The first line that is neither blank nor a comment ('#') is the header: it names
// the columns, with units if it likes, as in "time [s]". Every failure throws Error with file, line, column
// and cure.
class CsvRows : public TextReader {
 public:
  struct Column {
    std::string name, unit;  // the unit is empty if the header has none
  };

  // Opens a regular file, of which one row is in memory at a time, and reads its header.
  explicit CsvRows(const std::filesystem::path& path);
  // Reads the header of a text, which must outlive the rows. example: of a header, for the cure of a text
  // without one. on_comment is called at each comment before the header.
  CsvRows(std::string_view text, std::string name, std::string_view example,
          const std::function<void(const TextReader&)>& on_comment);

  const std::vector<Column>& columns() const { return columns_; }
  // Number of the column with this name, given with its unit or without.
  std::size_t column(std::string_view name) const;

  // Goes to the next row, past blank lines and comments; false at the end of the text.
  bool next();
  // The cells of the row; of the header before the first row.
  const std::vector<Token>& row() const { return *row_; }
  // The finite number in a column of the row.
  double number(std::size_t column) const;
  // The same, which may be infinite or NaN too.
  double any_number(std::size_t column) const;
  // The text in a column of the row.
  std::string text(std::size_t column) const;

 private:
  void read_header(std::string_view example, const std::function<void(const TextReader&)>& on_comment);

  const std::vector<Token>* row_ = nullptr;
  std::vector<Column> columns_;
  std::vector<std::string> labels_;  // names for messages
};

}  // namespace scree::files
