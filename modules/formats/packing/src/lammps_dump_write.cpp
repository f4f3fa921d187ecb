#include "material_types.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/lammps.hpp>

namespace scree::packing {

namespace {

// Whether the value becomes a column. A dump has no empty cells, so either all bodies have the value or none.
bool is_column(const Packing& packing, double Body::*value, std::string_view name) {
  const auto given = std::count_if(packing.bodies.begin(), packing.bodies.end(),
                                   [&](const Body& body) { return !std::isnan(body.*value); });
  if (given == 0) return false;
  if (given == std::ssize(packing.bodies)) return true;
  throw Error("packing",
              fmt::format("{} of {} bodies have a {}, but a dump needs it for all or none", given,
                          packing.bodies.size(), name),
              "complete it, or write CSV");
}

void write_box(std::string& out, const Packing& packing) {
  const Bounds box = packing.bounds ? *packing.bounds : enclosing_bounds(packing);
  out += "ITEM: BOX BOUNDS";
  for (int k = 0; k < 3; ++k) out += packing.periodic[k] || k >= packing.dimension ? " pp" : " ff";
  for (int k = 0; k < 3; ++k) {
    const bool flat = k >= packing.dimension && !(box.lower[k] < box.upper[k]);
    const double half = flat ? 0.5 : 0.0;
    fmt::format_to(std::back_inserter(out), "\n{} {}", box.lower[k] - half, box.upper[k] + half);
  }
  out += '\n';
}

void write_vector(std::string& out, const Vec3& v) {
  fmt::format_to(std::back_inserter(out), " {} {} {}", v[0], v[1], v[2]);
}

}  // namespace

std::string format_lammps_dump(const Packing& packing, const ExportOptions& options) {
  check(packing);
  const MaterialTypes types(packing, options.materials);
  const bool density = is_column(packing, &Body::density, "density");
  const bool mass = is_column(packing, &Body::mass, "mass");
  std::string out;
  const auto end = std::back_inserter(out);
  if (options.dialect == Dialect::lammps)
    fmt::format_to(end, "ITEM: UNITS\nsi\nITEM: TIME\n{}\n", packing.time);
  fmt::format_to(end, "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", options.timestep,
                 packing.bodies.size());
  write_box(out, packing);
  fmt::format_to(end, "ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius{}{}\n",
                 density ? " density" : "", mass ? " mass" : "");
  for (const Body& body : packing.bodies) {
    fmt::format_to(end, "{} {}", body.id, types.type(body));
    write_vector(out, body.position);
    write_vector(out, body.velocity);
    write_vector(out, body.spin);
    fmt::format_to(end, " {}", body.radius);
    if (density) fmt::format_to(end, " {}", body.density);
    if (mass) fmt::format_to(end, " {}", body.mass);
    out += '\n';
  }
  return out;
}

void write_lammps_dump(const Packing& packing, const std::filesystem::path& path,
                       const ExportOptions& options) {
  files::write_atomically(path, format_lammps_dump(packing, options));
}

}  // namespace scree::packing
