#include "body_field.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/csv.hpp>

namespace scree::packing {

namespace {

struct ColumnName {
  std::string_view name;
  std::string_view unit;  // empty: dimensionless or text
  BodyField field;
  std::string_view other_name = {}, other_unit = {};  // read too, as in older files; empty: none
};

constexpr std::array columns = {
    ColumnName{"id", "", BodyField::id},
    ColumnName{"material", "", BodyField::material},
    ColumnName{"x", "m", BodyField::x},
    ColumnName{"y", "m", BodyField::y},
    ColumnName{"z", "m", BodyField::z},
    ColumnName{"radius", "m", BodyField::radius},
    ColumnName{"diameter", "m", BodyField::diameter},
    ColumnName{"density", "kg/m^3", BodyField::density, "", "kg/m3"},
    ColumnName{"mass", "kg", BodyField::mass},
    ColumnName{"vx", "m/s", BodyField::vx},
    ColumnName{"vy", "m/s", BodyField::vy},
    ColumnName{"vz", "m/s", BodyField::vz},
    ColumnName{"spin_x", "rad/s", BodyField::wx, "wx"},
    ColumnName{"spin_y", "rad/s", BodyField::wy, "wy"},
    ColumnName{"spin_z", "rad/s", BodyField::wz, "wz"},
};

// Values from the comment lines before the header.
struct Preamble {
  std::optional<int> dimension;
  std::optional<std::array<bool, 3>> periodic;
  std::optional<Vec3> lower;
  std::optional<Vec3> upper;
  double time = 0.0;
};

Vec3 read_corner(const std::vector<Token>& words, const TextReader& reader, std::string_view key) {
  if (words.size() != 3)
    reader.fail(1, fmt::format("'{}' has {}", key, counted(words.size(), "number")), "give three");
  return {{reader.number(words[0], key), reader.number(words[1], key), reader.number(words[2], key)}};
}

std::array<bool, 3> read_axes(const std::vector<Token>& words, const TextReader& reader) {
  std::array<bool, 3> periodic{};
  for (const Token& word : words) {
    const std::size_t axis = std::string_view("xyz").find(word.text);
    if (word.text.size() != 1 || axis == std::string_view::npos)
      reader.fail(word.column, fmt::format("{} is not an axis", quote_token(word.text)), "list x, y and z");
    periodic[axis] = true;
  }
  return periodic;
}

int read_dimension(const std::vector<Token>& words, const TextReader& reader) {
  if (words.size() == 1 && (words[0].text == "2" || words[0].text == "3"))
    return words[0].text == "2" ? 2 : 3;
  reader.fail(1, "the dimension is neither 2 nor 3", "write '# dimension: 2' or '# dimension: 3'");
}

// Other comments are ignored.
void read_comment(Preamble& preamble, const TextReader& reader) {
  const std::size_t hash = reader.line().find('#');
  const std::size_t colon = reader.line().find(':');
  if (colon == std::string_view::npos || colon < hash) return;
  const std::string_view key = reader.trimmed(hash + 1, colon).text;
  const std::vector<Token> words = words_after(reader, colon + 1);
  if (key == "dimension") preamble.dimension = read_dimension(words, reader);
  if (key == "lower [m]") preamble.lower = read_corner(words, reader, key);
  if (key == "upper [m]") preamble.upper = read_corner(words, reader, key);
  if (key == "periodic") preamble.periodic = read_axes(words, reader);
  if (key == "time [s]") {
    if (words.size() != 1) reader.fail(1, "the time is not one number", "write '# time [s]: 0'");
    preamble.time = reader.number(words[0], key);
  }
}

// Names that papers and other programs use for columns.
constexpr std::pair<std::string_view, std::string_view> symbols[] = {
    {"r", "radius"},      {"d", "diameter"},    {"m", "mass"},       {"rho", "density"},
    {"velocity_x", "vx"}, {"velocity_y", "vy"}, {"velocity_z", "vz"}};

std::string column_cure(std::string_view name) {
  std::string word(name);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char letter) { return char(std::tolower(letter)); });
  for (const auto& [symbol, column] : symbols)
    if (symbol == word) return fmt::format("did you mean '{}'?", column);
  std::array<std::string_view, columns.size()> known;
  std::transform(columns.begin(), columns.end(), known.begin(), [](const ColumnName& c) { return c.name; });
  return files::suggest_name(name, known);
}

const ColumnName& find_column(std::string_view name, const Token& cell, const TextReader& reader) {
  for (const ColumnName& column : columns)
    if (column.name == name || (!name.empty() && column.other_name == name)) return column;
  reader.fail(cell.column, fmt::format("unknown column {}", quote_token(name)), column_cure(name));
}

BodyField read_column(const Token& cell, const TextReader& reader) {
  const std::size_t bracket = std::min(cell.text.find('['), cell.text.size());
  const Token name = reader.trimmed(cell.column - 1, cell.column - 1 + bracket);
  const ColumnName& column = find_column(name.text, cell, reader);
  if (bracket == cell.text.size()) return column.field;
  const std::string_view unit = cell.text.substr(bracket);
  const bool is_other = !column.other_unit.empty() && unit == fmt::format("[{}]", column.other_unit);
  if (!is_other && unit != fmt::format("[{}]", column.unit))
    reader.fail(cell.column, fmt::format("column {} has unit {}", column.name, quote_token(unit)),
                column.unit.empty() ? "leave the brackets out"
                                    : fmt::format("convert its numbers and write [{}]", column.unit));
  return column.field;
}

bool has(const std::vector<BodyField>& fields, BodyField field) {
  return std::find(fields.begin(), fields.end(), field) != fields.end();
}

void require_columns(const std::vector<BodyField>& fields, const TextReader& reader) {
  if (!has(fields, BodyField::x) || !has(fields, BodyField::y))
    reader.fail(1, "column x or y is missing", "add it; the header names the columns, separated by commas");
  if (has(fields, BodyField::radius) == has(fields, BodyField::diameter))
    reader.fail(1, "there must be either a column radius or a column diameter", "give one of the two");
}

std::vector<BodyField> fields_of(const files::CsvRows& rows) {
  std::vector<BodyField> fields;
  for (const Token& cell : rows.row()) {
    const BodyField field = read_column(cell, rows);
    if (has(fields, field))
      rows.fail(cell.column, fmt::format("column {} appears twice", quote_token(cell.text)),
                "leave one of them out");
    fields.push_back(field);
  }
  require_columns(fields, rows);
  return fields;
}

bool may_be_empty(BodyField field) {
  return field == BodyField::material || field == BodyField::density || field == BodyField::mass ||
         field >= BodyField::vx;
}

class BodyReader {
 public:
  BodyReader(std::vector<BodyField> fields, int dimension)
      : fields_(std::move(fields)), dimension_(dimension) {}

  // The body in the current row; number: its id if the file has none.
  Body read(const files::CsvRows& rows, std::int64_t number) {
    const std::vector<Token>& cells = rows.row();
    Body body;
    body.id = number;
    Token id = cells[0];
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (cells[k].text.empty() && may_be_empty(fields_[k])) continue;
      set_field(body, fields_[k], cells[k], rows);
      if (dimension_ == 2) require_planar(body, fields_[k], cells[k], rows);
      if (fields_[k] == BodyField::id) id = cells[k];
    }
    if (body.density == body.density && body.mass == body.mass)
      rows.fail(1, "density and mass are both given", "leave one of the two cells empty");
    ids_.add(body.id, id, rows);
    return body;
  }

 private:
  std::vector<BodyField> fields_;
  int dimension_;
  IdRegister ids_;
};

Packing begin_packing(const Preamble& preamble, const ImportOptions& options, int dimension,
                      const TextReader& reader) {
  Packing packing;
  packing.dimension = dimension;
  packing.periodic = options.periodic.value_or(preamble.periodic.value_or(std::array<bool, 3>{}));
  packing.time = preamble.time;
  if (preamble.lower.has_value() != preamble.upper.has_value())
    reader.fail(1, "only one of '# lower [m]' and '# upper [m]' is given", "give both");
  if (preamble.lower) packing.bounds = Bounds{*preamble.lower, *preamble.upper};
  return packing;
}

}  // namespace

Packing parse_csv(std::string_view text, const std::string& name, const ImportOptions& options) {
  Preamble preamble;
  files::CsvRows rows(text, name, "x,y,z,radius",
                      [&](const TextReader& comment) { read_comment(preamble, comment); });
  std::vector<BodyField> fields = fields_of(rows);
  const int dimension_of_columns = has(fields, BodyField::z) ? 3 : 2;
  const int dimension = options.dimension.value_or(preamble.dimension.value_or(dimension_of_columns));
  Packing packing = begin_packing(preamble, options, dimension, rows);
  packing.own_ids = has(fields, BodyField::id);
  BodyReader bodies(std::move(fields), dimension);
  while (rows.next()) packing.bodies.push_back(bodies.read(rows, std::int64_t(packing.bodies.size()) + 1));
  if (packing.bodies.empty()) rows.fail(1, "no body follows the header", "add a line for each body");
  return checked_import(std::move(packing), name);
}

Packing read_csv(const std::filesystem::path& path, const ImportOptions& options) {
  return parse_csv(files::read_text(path), path.string(), options);
}

}  // namespace scree::packing
