#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <scree/error.hpp>
#include <scree/packing/lammps.hpp>
#include <scree/packing/packing.hpp>
#include <scree/packing/random.hpp>

namespace scree::packing {

// Message of the Error that the call throws; empty if it throws none.
template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

inline Packing parse_dump(const std::string& text, const ImportOptions& options = {}) {
  return parse_lammps_dump(text, "d", options);
}

inline bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a[0], b[0]) && same_bits(a[1], b[1]) && same_bits(a[2], b[2]);
}

inline bool same_bits(const Body& a, const Body& b) {
  return a.id == b.id && a.material == b.material && same_bits(a.radius, b.radius) &&
         same_bits(a.density, b.density) && same_bits(a.mass, b.mass) && same_bits(a.position, b.position) &&
         same_bits(a.velocity, b.velocity) && same_bits(a.spin, b.spin);
}

inline bool same_bits(const Packing& a, const Packing& b) {
  if (a.dimension != b.dimension || a.bodies.size() != b.bodies.size() || a.periodic != b.periodic)
    return false;
  if (!same_bits(a.time, b.time) || a.bounds.has_value() != b.bounds.has_value()) return false;
  if (a.bounds &&
      !(same_bits(a.bounds->lower, b.bounds->lower) && same_bits(a.bounds->upper, b.bounds->upper))) {
    return false;
  }
  for (std::size_t k = 0; k < a.bodies.size(); ++k) {
    if (!same_bits(a.bodies[k], b.bodies[k])) return false;
  }
  return true;
}

// Bodies with awkward numbers in every field, inside the box from -1 to 1.
inline Packing awkward_packing(int dimension, std::size_t count = 50) {
  Random random(7);
  Packing packing;
  packing.dimension = dimension;
  packing.bounds = Bounds{{{-1.0, -1.0 / 3.0 - 1.0, dimension == 3 ? -1.1 : -0.1}},
                          {{1.0, std::nextafter(1.0, 2.0), dimension == 3 ? 1.1 : 0.1}}};
  packing.periodic = {true, false, dimension == 3};
  packing.time = 1.0 / 3.0;
  for (std::size_t k = 0; k < count; ++k) {
    Body body;
    body.id = std::int64_t(3 * (count - k));
    body.material = k % 3 == 0 ? '2' : '1';
    body.radius = std::ldexp(1.0 + random.uniform(), -int(k) - 3);
    body.density = 2500.0 + random.uniform();
    for (int axis = 0; axis < dimension; ++axis) {
      body.position[axis] = random.uniform(-1.0, 1.0);
      body.velocity[axis] = random.normal() * 1e-7;
    }
    for (int axis = dimension == 3 ? 0 : 2; axis < 3; ++axis) body.spin[axis] = random.normal() * 1e9;
    packing.bodies.push_back(body);
  }
  packing.bodies[0].velocity[0] = -0.0;
  packing.bodies[1].velocity[1] = 4.9406564584124654e-324;
  packing.bodies[2].spin[2] = 1.7976931348623157e308;
  return packing;
}

// Two bodies of radius 1, so far apart.
inline Packing two(double distance) {
  Packing packing;
  packing.bodies.resize(2);
  packing.bodies[0].id = 8;
  packing.bodies[1].id = 3;
  packing.bodies[0].radius = packing.bodies[1].radius = 1.0;
  packing.bodies[1].position[0] = distance;
  return packing;
}

// 300 bodies with radii of equal probability per logarithm, anywhere in a box.
inline Packing scattered(int dimension, std::array<bool, 3> periodic, double smallest, double largest,
                         std::uint64_t seed) {
  Random random(seed);
  Packing packing;
  packing.dimension = dimension;
  packing.bounds = Bounds{{{-1.0, 2.0, 0.0}}, {{1.5, 4.0, 1.0}}};
  packing.periodic = periodic;
  for (int n = 0; n < 300; ++n) {
    Body body;
    body.id = n + 1;
    body.radius = smallest * std::pow(largest / smallest, random.uniform());
    for (int k = 0; k < dimension; ++k) {
      body.position[k] = random.uniform(packing.bounds->lower[k], packing.bounds->upper[k]);
    }
    packing.bodies.push_back(body);
  }
  return packing;
}

}  // namespace scree::packing
