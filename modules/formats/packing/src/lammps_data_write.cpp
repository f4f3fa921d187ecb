#include "material_types.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/lammps.hpp>

namespace scree::packing {

namespace {

// In two dimensions bodies are discs of unit thickness here, and spheres there.
double density_of(const Body& body, int dimension, const ExportOptions& options) {
  double density = sphere_density(body);
  if (std::isnan(density)) density = options.density;
  if (dimension == 2 && std::isnan(body.mass)) density *= 0.75 / body.radius;
  if (std::isfinite(density) && density > 0.0) return density;
  throw Error("packing", fmt::format("body {} has no density", body.id),
              "give one for the export, such as the density of its material");
}

// LAMMPS and LIGGGHTS accept an atom only below the upper bound of the box, and in two dimensions only a box
// around z = 0.
Bounds export_box(const Packing& packing) {
  Bounds box = packing.bounds ? *packing.bounds : enclosing_bounds(packing);
  if (packing.dimension == 2 && !(box.lower[2] < 0.0 && box.upper[2] > 0.0)) {
    const double largest =
        std::max_element(packing.bodies.begin(), packing.bodies.end(), [](const Body& a, const Body& b) {
          return a.radius < b.radius;
        })->radius;
    box.lower[2] = -largest;
    box.upper[2] = largest;
  }
  for (const Body& body : packing.bodies) {
    for (int k = 0; k < packing.dimension; ++k) {
      const double x = body.position[k];
      if (packing.periodic[k] || (x >= box.lower[k] && x < box.upper[k])) continue;
      throw Error("packing",
                  fmt::format("body {} lies at {} = {} m, outside the box from {} to {} m", body.id, "xyz"[k],
                              x, box.lower[k], box.upper[k]),
                  "widen the bounds");
    }
  }
  return box;
}

void write_header(std::string& out, const Packing& packing, std::int64_t types) {
  const Bounds box = export_box(packing);
  const auto end = std::back_inserter(out);
  fmt::format_to(end, "scree packing, SI units, atom style sphere\n\n{} atoms\n{} atom types\n\n",
                 packing.bodies.size(), types);
  for (int k = 0; k < 3; ++k)
    fmt::format_to(end, "{} {} {}lo {}hi\n", box.lower[k], box.upper[k], "xyz"[k], "xyz"[k]);
}

}  // namespace

std::string format_lammps_data(const Packing& packing, const ExportOptions& options) {
  check(packing);
  const MaterialTypes types(packing, options.materials);
  std::string out;
  write_header(out, packing, types.count());
  const auto end = std::back_inserter(out);
  out += "\nAtoms # sphere\n\n";
  for (const Body& body : packing.bodies) {
    const Vec3& x = body.position;
    fmt::format_to(end, "{} {} {} {} {} {} {}\n", body.id, types.type(body), 2.0 * body.radius,
                   density_of(body, packing.dimension, options), x[0], x[1], x[2]);
  }
  out += "\nVelocities\n\n";
  for (const Body& body : packing.bodies) {
    const Vec3& v = body.velocity;
    const Vec3& w = body.spin;
    fmt::format_to(end, "{} {} {} {} {} {} {}\n", body.id, v[0], v[1], v[2], w[0], w[1], w[2]);
  }
  return out;
}

void write_lammps_data(const Packing& packing, const std::filesystem::path& path,
                       const ExportOptions& options) {
  files::write_atomically(path, format_lammps_data(packing, options));
}

}  // namespace scree::packing
