#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <unordered_set>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

namespace {

bool finite(const Vec3& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

bool unset_or_positive(double value) { return std::isnan(value) || positive(value); }

[[noreturn]] void fail(const Body& body, const std::string& problem, const std::string& cure) {
  throw Error(fmt::format("packing: body {}", body.id), problem, cure);
}

void check_body(const Body& body, int dimension) {
  if (body.id <= 0) fail(body, "the id is not positive", "number the bodies from 1 on");
  if (!positive(body.radius))
    fail(body, fmt::format("the radius {} m is not positive and finite", body.radius),
         "give a radius above 0");
  if (!unset_or_positive(body.density))
    fail(body, "the density is not positive", "give a density above 0, or none");
  if (!unset_or_positive(body.mass)) fail(body, "the mass is not positive", "give a mass above 0, or none");
  if (!std::isnan(body.density) && !std::isnan(body.mass))
    fail(body, "density and mass are both given", "give one of them");
  if (!finite(body.position) || !finite(body.velocity) || !finite(body.spin))
    fail(body, "position, velocity or spin is not finite", "give finite numbers");
  const bool planar =
      body.position[2] == 0.0 && body.velocity[2] == 0.0 && body.spin[0] == 0.0 && body.spin[1] == 0.0;
  if (dimension == 2 && !planar)
    fail(body, "z, vz, spin_x or spin_y is not 0 in two dimensions",
         "set them to 0, or use three dimensions");
}

void check_box(const Packing& packing) {
  if (packing.bounds && !(finite(packing.bounds->lower) && finite(packing.bounds->upper)))
    throw Error("packing", "the bounds are not finite", "give finite numbers");
  for (int k = 0; k < 3; ++k) {
    const double length = packing.bounds ? packing.bounds->upper[k] - packing.bounds->lower[k] : 0.0;
    if (length < 0.0)
      throw Error("packing", fmt::format("the upper bound along {} is below the lower one", "xyz"[k]),
                  "swap them");
    if (packing.periodic[k] && !positive(length))
      throw Error("packing", fmt::format("{} is periodic without a finite period", "xyz"[k]),
                  "give bounds along it");
  }
}

}  // namespace

void check(const Packing& packing) {
  if (packing.dimension != 2 && packing.dimension != 3)
    throw Error("packing", fmt::format("{} dimensions are not supported", packing.dimension), "give 2 or 3");
  if (packing.bodies.empty()) throw Error("packing", "there are no bodies", "add at least one");
  if (packing.dimension == 2 && packing.periodic[2])
    throw Error("packing", "z is periodic in two dimensions", "keep only x and y");
  if (!std::isfinite(packing.time))
    throw Error("packing", "the time is not finite", "give a number of seconds");
  check_box(packing);
  std::unordered_set<std::int64_t> ids;
  for (const Body& body : packing.bodies) {
    check_body(body, packing.dimension);
    if (!ids.insert(body.id).second) fail(body, "the id is used twice", "give every body its own id");
  }
}

Bounds enclosing_bounds(const Packing& packing) {
  const Vec3 first = packing.bodies.front().position;
  Bounds box{first, first};
  for (const Body& body : packing.bodies) {
    for (int k = 0; k < packing.dimension; ++k) {
      box.lower[k] = std::min(box.lower[k], body.position[k] - body.radius);
      box.upper[k] = std::max(box.upper[k], body.position[k] + body.radius);
    }
  }
  return box;
}

void set_periodic(Packing& packing, const Domain& domain) {
  if (!domain.any_periodic()) return;
  packing.periodic = domain.periodic;
  packing.bounds = enclosing_bounds(packing);
  for (int k = 0; k < 3; ++k)
    if (domain.periodic[std::size_t(k)])
      packing.bounds->lower[k] = domain.lower[k], packing.bounds->upper[k] = domain.upper[k];
}

double sphere_density(const Body& body) {
  if (std::isnan(body.mass)) return body.density;
  return body.mass / (4.0 / 3.0 * std::numbers::pi * body.radius * body.radius * body.radius);
}

}  // namespace scree::packing
