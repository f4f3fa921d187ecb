#include "table_columns.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scree::packing {

namespace {

using Kind = TableColumn::Kind;

// Names of columns in small letters, as programs write them, and units that they may have.
struct KnownColumn {
  std::vector<std::string_view> names;
  std::vector<std::string_view> units;
  BodyField field;
  Kind kind = Kind::value;
};

const std::vector<KnownColumn>& known_columns() {
  static const std::vector<KnownColumn> all = {
      {{"x", "posx", "pos_x", "position_x", "positionx"}, {"m"}, BodyField::x},
      {{"y", "posy", "pos_y", "position_y", "positiony"}, {"m"}, BodyField::y},
      {{"z", "posz", "pos_z", "position_z", "positionz"}, {"m"}, BodyField::z},
      {{"r", "radius", "rad"}, {"m"}, BodyField::radius},
      {{"d", "diameter", "diam"}, {"m"}, BodyField::diameter},
      {{"vx", "velx", "vel_x", "velocity_x", "velocityx"}, {"m/s"}, BodyField::vx},
      {{"vy", "vely", "vel_y", "velocity_y", "velocityy"}, {"m/s"}, BodyField::vy},
      {{"vz", "velz", "vel_z", "velocity_z", "velocityz"}, {"m/s"}, BodyField::vz},
      {{"wx", "spin_x", "omegax", "omega_x", "angvelx", "angvel_x"}, {"rad/s", "1/s"}, BodyField::wx},
      {{"wy", "spin_y", "omegay", "omega_y", "angvely", "angvel_y"}, {"rad/s", "1/s"}, BodyField::wy},
      {{"wz", "spin_z", "omegaz", "omega_z", "angvelz", "angvel_z"}, {"rad/s", "1/s"}, BodyField::wz},
      {{"m", "mass"}, {"kg"}, BodyField::mass},
      {{"rho", "density"}, {"kg/m3", "kg/m^3"}, BodyField::density},
      {{"id"}, {}, BodyField::id},
      {{"material"}, {}, BodyField::material},
      {{"matid"}, {}, BodyField::material, Kind::from_0},
      {{"type"}, {}, BodyField::material, Kind::type}};
  return all;
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char letter) { return char(std::tolower(letter)); });
  return small;
}

void check_unit(const KnownColumn& column, std::string_view unit, const Token& cell,
                const TextReader& reader) {
  if (unit.empty() || std::any_of(column.units.begin(), column.units.end(),
                                  [&](std::string_view known) { return unit == fmt::format("[{}]", known); }))
    return;
  reader.fail(cell.column, fmt::format("column {} has the unit {}", column.names[0], quote_token(unit)),
              column.units.empty() ? "leave the brackets out"
                                   : fmt::format("convert its numbers and write [{}]", column.units[0]));
}

TableColumn column_of(const Token& cell, const TextReader& reader) {
  const std::size_t bracket = std::min(cell.text.find('['), cell.text.size());
  const std::string name = in_small_letters(cell.text.substr(0, bracket));
  for (const KnownColumn& known : known_columns()) {
    if (std::find(known.names.begin(), known.names.end(), name) == known.names.end()) continue;
    check_unit(known, cell.text.substr(bracket), cell, reader);
    return {std::string(cell.text.substr(0, bracket)), known.field, known.kind};
  }
  return {std::string(cell.text), BodyField::x, Kind::unread};
}

bool is_same_quantity(BodyField a, BodyField b) {
  const auto size = [](BodyField field) {
    return field == BodyField::radius || field == BodyField::diameter;
  };
  return a == b || (size(a) && size(b));
}

}  // namespace

std::vector<TableColumn> columns_of_names(const std::vector<Token>& names, const TextReader& reader) {
  std::vector<TableColumn> columns;
  for (const Token& cell : names) {
    TableColumn column = column_of(cell, reader);
    const auto same = std::find_if(columns.begin(), columns.end(), [&](const TableColumn& before) {
      return before.kind != Kind::unread && column.kind != Kind::unread &&
             is_same_quantity(before.field, column.field);
    });
    if (same != columns.end())
      reader.fail(cell.column,
                  fmt::format("columns {} and {} are the same quantity", same->name, column.name),
                  "leave one of them out");
    columns.push_back(std::move(column));
  }
  return columns;
}

bool are_complete(const std::vector<TableColumn>& columns) {
  const auto has = [&](BodyField field) {
    return std::any_of(columns.begin(), columns.end(), [&](const TableColumn& column) {
      return column.kind != Kind::unread && is_same_quantity(column.field, field);
    });
  };
  return has(BodyField::x) && has(BodyField::y) && has(BodyField::radius);
}

std::vector<TableColumn> columns_of_yade(const Token& format, const TextReader& reader) {
  std::vector<Token> names;
  for (std::size_t begin = 0; begin <= format.text.size();) {
    const std::size_t end = std::min(format.text.find('_', begin), format.text.size());
    names.push_back({format.text.substr(begin, end - begin), format.column + begin});
    begin = end + 1;
  }
  std::vector<TableColumn> columns = columns_of_names(names, reader);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].kind == Kind::unread)
      reader.fail(names[k].column, fmt::format("column {} of YADE is not known", quote_token(names[k].text)),
                  "name the columns with the key 'columns' of [particles], \"-\" for one not to be read");
    if (columns[k].field == BodyField::id) columns[k].kind = Kind::id_from_0;
  }
  return columns;
}

std::string text_of(const std::vector<TableColumn>& columns) {
  std::vector<std::string> read, unread;
  for (const TableColumn& column : columns)
    if (column.kind == Kind::unread)
      unread.push_back(column.name);
    else
      read.push_back(column.kind == Kind::id_from_0 ? column.name + " + 1" : column.name);
  std::string text = fmt::format("{}", fmt::join(read, " "));
  if (!unread.empty()) text += fmt::format(" (without {})", fmt::join(unread, ", "));
  return text;
}

}  // namespace scree::packing
