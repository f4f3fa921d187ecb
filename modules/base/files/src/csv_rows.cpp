#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/files/text.hpp>
#include <scree/nearest.hpp>

namespace scree::files {

namespace {

CsvRows::Column column_of(std::string_view header) {
  const std::size_t bracket = header.find('[');
  if (bracket == header.npos || !header.ends_with(']')) return {std::string(header), ""};
  const std::string_view before = header.substr(0, bracket);
  const std::size_t end = before.find_last_not_of(" \t") + 1;
  return {std::string(before.substr(0, end)),
          std::string(header.substr(bracket + 1, header.size() - bracket - 2))};
}

bool is_number(std::string_view text) {
  double value = 0;
  const auto [rest, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failed == std::errc() && rest == text.data() + text.size();
}

}  // namespace

CsvRows::CsvRows(const std::filesystem::path& path) : TextReader(path) { read_header("time [s],strain", {}); }

CsvRows::CsvRows(std::string_view text, std::string name, std::string_view example,
                 const std::function<void(const TextReader&)>& on_comment)
    : TextReader(text, std::move(name)) {
  read_header(example, on_comment);
}

void CsvRows::read_header(std::string_view example,
                          const std::function<void(const TextReader&)>& on_comment) {
  bool found = false;
  while (!found && TextReader::next()) {
    found = !is_comment();
    if (!found && on_comment) on_comment(*this);
  }
  if (!found)
    fail(1, "there is no header", fmt::format("name the columns in the first line, such as '{}'", example));
  for (const auto& [separator, name] : {std::pair(';', "semicolons"), std::pair('\t', "tabs")})
    if (line().find(separator) != line().npos && line().find(',') == line().npos)
      fail(1, fmt::format("the columns are separated by {}", name),
           "separate them by commas, with decimal points");
  row_ = &cells();
  if (std::all_of(row_->begin(), row_->end(), [](const Token& cell) { return is_number(cell.text); }))
    fail(1, "there is no header, but numbers",
         fmt::format("name the columns in the first line, such as '{}'", example));
  for (const Token& cell : *row_) {
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
    if (!TextReader::next()) return false;
  } while (is_comment());
  row_ = &cells();
  if (row_->size() != columns_.size())
    fail(1, fmt::format("{} under {}", counted(row_->size(), "cell"), counted(columns_.size(), "column")),
         "give one cell for each column; decimal commas are not supported");
  return true;
}

double CsvRows::number(std::size_t column) const {
  return TextReader::number((*row_)[column], labels_[column]);
}

double CsvRows::any_number(std::size_t column) const {
  return TextReader::any_number((*row_)[column], labels_[column]);
}

std::string CsvRows::text(std::size_t column) const {
  std::string text((*row_)[column].text);
  for (std::size_t at = 0; (at = text.find("\"\"", at)) != text.npos; ++at) text.erase(at, 1);
  return text;
}

}  // namespace scree::files
