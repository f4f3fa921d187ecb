#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/files/text_reader.hpp>
#include <scree/packing/csv.hpp>

namespace scree::packing {

namespace {

// Columns that are written only if some body needs them.
struct OptionalColumns {
  bool material;
  bool density;
  bool mass;
};

OptionalColumns needed_columns(const Packing& packing) {
  const auto any = [&](auto condition) {
    return std::any_of(packing.bodies.begin(), packing.bodies.end(), condition);
  };
  return {any([](const Body& b) { return !b.material.empty(); }),
          any([](const Body& b) { return !std::isnan(b.density); }),
          any([](const Body& b) { return !std::isnan(b.mass); })};
}

void write_preamble(std::string& out, const Packing& packing) {
  const auto end = std::back_inserter(out);
  fmt::format_to(end, "# dimension: {}\n# time [s]: {}\n", packing.dimension, packing.time);
  if (packing.bounds) {
    const auto& [lower, upper] = *packing.bounds;
    fmt::format_to(end, "# lower [m]: {} {} {}\n", lower[0], lower[1], lower[2]);
    fmt::format_to(end, "# upper [m]: {} {} {}\n", upper[0], upper[1], upper[2]);
  }
  out += "# periodic:";
  for (int k = 0; k < 3; ++k)
    if (packing.periodic[k]) fmt::format_to(end, " {}", "xyz"[k]);
  out += '\n';
}

void write_header(std::string& out, const OptionalColumns& columns, int dimension) {
  out += "id";
  if (columns.material) out += ",material";
  out += dimension == 3 ? ",x [m],y [m],z [m],radius [m]" : ",x [m],y [m],radius [m]";
  if (columns.density) out += ",density [kg/m^3]";
  if (columns.mass) out += ",mass [kg]";
  out += dimension == 3 ? ",vx [m/s],vy [m/s],vz [m/s],spin_x [rad/s],spin_y [rad/s],spin_z [rad/s]\n"
                        : ",vx [m/s],vy [m/s],spin_z [rad/s]\n";
}

void require_plain(const Body& body) {
  if (fits_csv_cell(body.material)) return;
  throw Error(fmt::format("packing: body {}", body.id),
              fmt::format("material {} cannot be written as a CSV cell", files::quote_token(body.material)),
              "rename it without commas, quotes, control characters and leading or trailing blanks");
}

void write_optional(std::string& out, double value) {
  out += ',';
  if (!std::isnan(value)) fmt::format_to(std::back_inserter(out), "{}", value);
}

void write_body(std::string& out, const Body& body, const OptionalColumns& columns, int dimension) {
  const auto end = std::back_inserter(out);
  fmt::format_to(end, "{}", body.id);
  if (columns.material) fmt::format_to(end, ",{}", body.material);
  for (int k = 0; k < dimension; ++k) fmt::format_to(end, ",{}", body.position[k]);
  fmt::format_to(end, ",{}", body.radius);
  if (columns.density) write_optional(out, body.density);
  if (columns.mass) write_optional(out, body.mass);
  for (int k = 0; k < dimension; ++k) fmt::format_to(end, ",{}", body.velocity[k]);
  for (int k = dimension == 3 ? 0 : 2; k < 3; ++k) fmt::format_to(end, ",{}", body.spin[k]);
  out += '\n';
}

}  // namespace

bool fits_csv_cell(std::string_view text) {
  const auto breaks = [](unsigned char c) { return c < 0x20 || c == 0x7F || c == ',' || c == '"'; };
  const bool padded = !text.empty() && (text.front() == ' ' || text.back() == ' ');
  return !padded && std::none_of(text.begin(), text.end(), breaks);
}

std::string format_csv(const Packing& packing) {
  check(packing);
  const OptionalColumns columns = needed_columns(packing);
  std::string out;
  write_preamble(out, packing);
  write_header(out, columns, packing.dimension);
  for (const Body& body : packing.bodies) {
    require_plain(body);
    write_body(out, body, columns, packing.dimension);
  }
  return out;
}

void write_csv(const Packing& packing, const std::filesystem::path& path) {
  files::write_atomically(path, format_csv(packing));
}

}  // namespace scree::packing
