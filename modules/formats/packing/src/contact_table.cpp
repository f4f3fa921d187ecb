#include <algorithm>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include <scree/packing/contact_table.hpp>
#include <scree/packing/csv.hpp>

namespace scree::packing {

namespace {

// Subtracted from 0, so that no component becomes -0.
Vec3 opposite(const Vec3& v) { return Vec3{} - v; }

Contact from_smaller_id(Contact contact) {
  if (contact.wall >= 0 || contact.a < contact.b) return contact;
  std::swap(contact.a, contact.b);
  contact.normal = opposite(contact.normal);
  contact.force = opposite(contact.force);
  return contact;
}

std::string header(int dimension) {
  const std::string_view axes = std::string_view("xyz").substr(0, std::size_t(dimension));
  std::string names = "a,b,wall";
  for (const char axis : axes) names += fmt::format(",normal_{}", axis);
  for (const char axis : axes) names += fmt::format(",force_{} [N]", axis);
  names += ",overlap [m],sliding";
  for (const char axis : axes) names += fmt::format(",{} [m]", axis);
  return names + '\n';
}

// A name that cannot be written as a cell is that of the number of the wall.
std::string wall_cell(const ContactTable& table, std::int32_t wall) {
  if (wall < 0) return "";
  const bool named = std::size_t(wall) < table.walls.size() && fits_csv_cell(table.walls[std::size_t(wall)]);
  return named ? table.walls[std::size_t(wall)] : fmt::format("wall {}", wall + 1);
}

void write_row(std::string& out, const ContactTable& table, const Contact& contact) {
  const auto end = std::back_inserter(out);
  const auto components = [&](const Vec3& v) {
    for (int k = 0; k < table.dimension; ++k) fmt::format_to(end, ",{}", v[k]);
  };
  fmt::format_to(end, "{},{},{}", contact.a, contact.wall < 0 ? fmt::format("{}", contact.b) : "",
                 wall_cell(table, contact.wall));
  components(contact.normal);
  components(contact.force);
  fmt::format_to(end, ",{},{}", contact.overlap, int(contact.sliding));
  components(contact.point);
  out += '\n';
}

}  // namespace

std::string format_contacts_csv(const ContactTable& table) {
  std::vector<Contact> rows;
  for (const Contact& contact : table.contacts) rows.push_back(from_smaller_id(contact));
  std::stable_sort(rows.begin(), rows.end(), [](const Contact& p, const Contact& q) {
    return std::tuple(p.a, p.wall, p.b) < std::tuple(q.a, q.wall, q.b);
  });
  std::string out = fmt::format("# dimension: {}\n# time [s]: {}\n", table.dimension, table.time);
  if (table.evaluated)
    out += "# forces: evaluated from positions, velocities and springs, since the state has none\n";
  out += header(table.dimension);
  for (const Contact& contact : rows) write_row(out, table, contact);
  return out;
}

}  // namespace scree::packing
