#include "material_types.hpp"
#include "table_columns.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/packing/other_codes.hpp>

namespace scree::packing {

namespace {

using Kind = TableColumn::Kind;

constexpr const char* columns_key =
    "name its columns with the key 'columns' of [particles], such as [\"x\", \"y\", \"z\", \"radius\", \"-\"], "
    "where \"-\" is not read";
constexpr std::int64_t most_ids = 2147483647;  // of YADE
constexpr std::string_view period_mark = "##PERIODIC::", format_mark = "#format";

std::optional<std::int64_t> as_whole_number(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

// Whether the column of each line is a whole number that follows from the number of the line (from 0).
template <class Expected>
bool all_lines(std::string_view text, std::size_t column, const Expected& expected) {
  TextReader reader(text, "");
  std::int64_t lines = 0;
  for (; reader.next_words(); ++lines) {
    if (reader.words().size() <= column) return false;
    const auto number = as_whole_number(reader.words()[column].text);
    if (!number || *number != expected(lines)) return false;
  }
  return lines > 0;
}

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& name, const ImportOptions& options)
      : text_(text), reader_(text, name), options_(options) {}

  Packing read() {
    if (!options_.columns.empty()) columns_ = columns_by_key();
    read_head();
    if (columns_.empty()) columns_ = guessed_columns();
    const bool has_z = has(BodyField::z);
    packing_.dimension = has_z ? options_.dimension.value_or(3) : 2;
    if (packing_.dimension == 2) packing_.periodic[2] = false;
    packing_.own_ids = has(BodyField::id);
    do read_body();
    while (reader_.next_words());
    packing_.format =
        fmt::format("{}: {}{}", kind_, text_of(columns_), packing_.periodic[0] ? ", periodic" : "");
    return std::move(packing_);
  }

 private:
  bool has(BodyField field) const {
    return std::any_of(columns_.begin(), columns_.end(), [&](const TableColumn& column) {
      return column.kind != Kind::unread && column.field == field;
    });
  }
  std::vector<TableColumn> columns_by_key() const;
  void read_head();
  void read_comment();
  void read_period();
  std::vector<TableColumn> guessed_columns();
  void read_body();
  void read_cell(Body& body, const TableColumn& column, const Token& cell) const;

  std::string_view text_;
  TextReader reader_;
  const ImportOptions& options_;
  Packing packing_;
  std::vector<TableColumn> columns_;
  std::string kind_ = "a table";
  IdRegister ids_;
};

std::vector<TableColumn> TableReader::columns_by_key() const {
  std::vector<Token> names;
  for (const std::string& column : options_.columns) names.push_back({column, 1});
  std::vector<TableColumn> columns = columns_of_names(names, reader_);
  for (const TableColumn& column : columns)
    if (column.kind == Kind::unread && column.name != "-")
      reader_.fail(
          1, fmt::format("there is no column {} to read", quote_token(column.name)),
          "give x, y, z, radius, diameter, id, material, matId, density, mass, vx, spin_x, ... or \"-\"");
  if (!are_complete(columns)) reader_.fail(1, "the key 'columns' lacks x, y, radius or diameter", "add it");
  return columns;
}

// Reads up to the first body, which is then the current line.
void TableReader::read_head() {
  while (reader_.next()) {
    if (reader_.words().empty()) {
      read_comment();
      continue;
    }
    if (!names_columns(reader_.line())) return;
    if (options_.columns.empty()) columns_ = columns_of_names(reader_.words(), reader_);
  }
  reader_.fail(1, "the table has no body", "add a line for each body");
}

void TableReader::read_comment() {
  const std::string_view line = reader_.line();
  if (line.starts_with(period_mark)) return read_period();
  if (!options_.columns.empty() || !columns_.empty()) return;
  const std::size_t hash = line.find('#');
  if (hash == std::string_view::npos) return;
  if (line.starts_with(format_mark)) {
    const std::vector<Token> words = words_after(reader_, format_mark.size());
    if (words.size() != 1) reader_.fail(1, "'#format' has no columns", "write '#format x_y_z_r'");
    columns_ = columns_of_yade(words[0], reader_);
    if (!are_complete(columns_)) reader_.fail(words[0].column, "x, y or r is missing", columns_key);
    kind_ = "a table of YADE";
  } else if (names_columns(line.substr(hash + 1))) {
    columns_ = columns_of_names(words_after(reader_, hash + 1), reader_);
  }
}

void TableReader::read_period() {
  const std::vector<Token> words = words_after(reader_, period_mark.size());
  if (words.size() != 3)
    reader_.fail(1, fmt::format("{} instead of three lengths", counted(words.size(), "word")),
                 "write '##PERIODIC:: Lx Ly Lz'");
  packing_.bounds = Bounds{};
  for (int k = 0; k < 3; ++k)
    packing_.bounds->upper[k] = reader_.positive_number(words[std::size_t(k)], "length");
  packing_.periodic = options_.periodic.value_or(std::array{true, true, true});
  kind_ = "a SpherePack of YADE";
}

// Of a table of numbers alone, by the width of the current line.
std::vector<TableColumn> TableReader::guessed_columns() {
  const std::size_t width = reader_.words().size();
  std::vector<TableColumn> columns = {{"x", BodyField::x}, {"y", BodyField::y}};
  if (width == 4 || width == 5) columns.push_back({"z", BodyField::z});
  columns.push_back({"r", BodyField::radius});
  if (width == 3) return columns;
  if (width == 4) {
    const auto counts = [&](std::int64_t from) {
      return all_lines(text_, 0, [&](std::int64_t line) { return line + from; });
    };
    if (counts(0) || counts(1))
      reader_.fail(1, "the table may have the columns x y z r or id x y r", columns_key);
    return columns;
  }
  if (width == 5 && all_lines(text_, 4, [](std::int64_t) { return -1; })) {
    columns.push_back({"clump", BodyField::x, Kind::unread});
    kind_ = "a SpherePack of YADE";
    return columns;
  }
  if (width == 5)
    reader_.fail(1, "the fifth column may be the clump of a SpherePack of YADE or a material", columns_key);
  reader_.fail(1, fmt::format("nothing says what the {} are", counted(width, "column")), columns_key);
}

void TableReader::read_body() {
  const auto& words = reader_.words();
  if (words.size() != columns_.size())
    reader_.fail(
        1, fmt::format("{} under {}", counted(words.size(), "word"), counted(columns_.size(), "column")),
        "complete the line, or " + std::string(columns_key));
  Body body;
  body.id = std::int64_t(packing_.bodies.size()) + 1;
  Token id = words[0];
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (columns_[k].kind == Kind::unread) continue;
    read_cell(body, columns_[k], words[k]);
    if (columns_[k].field == BodyField::id) id = words[k];
  }
  if (body.density == body.density && body.mass == body.mass)
    reader_.fail(1, "density and mass are both given", "leave one of the columns out");
  ids_.add(body.id, id, reader_);
  packing_.bodies.push_back(std::move(body));
}

void TableReader::read_cell(Body& body, const TableColumn& column, const Token& cell) const {
  if (column.kind == Kind::from_0) {
    body.material = material_of_number(cell, column.name, options_.materials, reader_);
  } else if (column.kind == Kind::type) {
    body.material = material_of_type(cell, options_.materials, reader_);
  } else if (column.kind == Kind::id_from_0) {
    body.id = reader_.integer(cell, "id") + 1;
    if (body.id < 1 || body.id > most_ids)
      reader_.fail(cell.column, fmt::format("id {} is not 0 to {}", quote_token(cell.text), most_ids - 1),
                   "number the bodies anew");
  } else {
    set_field(body, column.field, cell, reader_);
    if (packing_.dimension == 2) require_planar(body, column.field, cell, reader_);
  }
}

}  // namespace

bool names_columns(std::string_view line) {
  TextReader reader(line, "");
  if (!reader.next_words()) return false;
  try {
    return are_complete(columns_of_names(reader.words(), reader));
  } catch (const Error&) {
    return true;  // they are names, and wrong ones, of which the reader says more
  }
}

Packing parse_table(std::string_view text, const std::string& name, const ImportOptions& options) {
  return checked_import(TableReader(text, name, options).read(), name);
}

}  // namespace scree::packing
