#include <algorithm>
#include <cerrno>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/nearest.hpp>

namespace scree::files {

namespace {

// Beyond it a file is no table, and would be read whole before that is seen.
constexpr std::size_t longest_line = 1u << 20;

CsvRows::Column column_of(std::string_view header) {
  const std::size_t bracket = header.find('[');
  if (bracket == header.npos || !header.ends_with(']')) return {std::string(header), ""};
  const std::string_view before = header.substr(0, bracket);
  const std::size_t end = before.find_last_not_of(" \t") + 1;
  return {std::string(before.substr(0, end)),
          std::string(header.substr(bracket + 1, header.size() - bracket - 2))};
}

}  // namespace

CsvRows::CsvRows(const std::filesystem::path& path)
    : TextLine(path.string()), file_(open_text(path), std::fclose) {
  read_header();
}

bool CsvRows::next_line() {
  text_.clear();
  whole_ = true;
  errno = 0;
  for (int byte; (byte = getc_unlocked(file_.get())) != '\n';) {
    if (byte == EOF) {
      if (std::ferror(file_.get()))
        throw ReadError(name() + ": cannot be read to its end; check the disk, and that it is a file", errno);
      if (text_.empty()) return false;
      whole_ = false;
      break;
    }
    text_.push_back(char(byte));
    if (text_.size() > longest_line) break;
  }
  if (line_number() == 0) {
    refuse_compressed(text_, name());
    if (text_.starts_with(byte_order_mark)) text_.erase(0, byte_order_mark.size());
  }
  set(text_);
  if (const std::size_t zero = line().find('\0'); zero != line().npos)
    fail(zero + 1, "not a text file: it contains a zero byte", "give an uncompressed text file");
  if (text_.size() > longest_line)
    fail(1, fmt::format("the line is longer than {} bytes", longest_line),
         "give a table with a line per row");
  return true;
}

void CsvRows::read_header() {
  bool found = false;
  while (!found && next_line()) found = !is_comment();
  if (!found) fail(1, "there is no header", "name the columns in the first line, such as 'time [s],strain'");
  if (line().find(';') != line().npos && line().find(',') == line().npos)
    fail(1, "the columns are separated by semicolons", "separate them by commas, with decimal points");
  if (line().find('\t') != line().npos && line().find(',') == line().npos)
    fail(1, "the columns are separated by tabs", "separate them by commas, with decimal points");
  for (const Token& cell : cells()) {
    columns_.push_back(column_of(cell.text));
    labels_.push_back(one_line(columns_.back().name));
  }
}

std::size_t CsvRows::column(std::string_view wanted) const {
  const Column sought = column_of(wanted);
  const auto fits = [&](const Column& column) {
    return column.name == sought.name && (sought.unit.empty() || column.unit == sought.unit);
  };
  if (const auto found = std::find_if(columns_.begin(), columns_.end(), fits); found != columns_.end()) {
    if (std::count_if(found, columns_.end(), fits) > 1)
      fail(1, fmt::format("there is more than one column {}", quote_token(wanted)),
           "rename all but one, or give its unit too");
    return std::size_t(found - columns_.begin());
  }
  std::vector<std::string> shown;
  for (const Column& column : columns_)
    shown.push_back(
        one_line(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit)));
  const auto near = nearest_word(sought.name, labels_);
  const auto place = std::find(labels_.begin(), labels_.end(), near.value_or("")) - labels_.begin();
  fail(1, fmt::format("there is no column {}", quote_token(wanted)),
       near ? fmt::format("did you mean '{}'?", shown[std::size_t(place)])
            : fmt::format("there are: {}", fmt::join(shown, ", ")));
}

bool CsvRows::next() {
  do {
    if (!next_line()) return false;
  } while (is_comment());
  row_ = &cells();
  if (row_->size() != columns_.size())
    fail(1, fmt::format("{} under {}", counted(row_->size(), "cell"), counted(columns_.size(), "column")),
         "give one cell for each column; decimal commas are not supported");
  return true;
}

double CsvRows::number(std::size_t column) const {
  return TextLine::number((*row_)[column], labels_[column]);
}

double CsvRows::any_number(std::size_t column) const {
  return TextLine::any_number((*row_)[column], labels_[column]);
}

std::string CsvRows::text(std::size_t column) const {
  std::string text((*row_)[column].text);
  for (std::size_t at = 0; (at = text.find("\"\"", at)) != text.npos; ++at) text.erase(at, 1);
  return text;
}

}  // namespace scree::files
