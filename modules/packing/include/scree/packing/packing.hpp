#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <scree/plugin/vec.hpp>

namespace scree::packing {

// "Not given": the value that a body leaves to its material.
inline constexpr double unset = std::numeric_limits<double>::quiet_NaN();

// One sphere (or disc). Plain data; check() below says what is allowed.
struct Body {
  std::int64_t id = 0;     // positive, unique in its packing
  std::string material;    // name, or type number of a foreign file; empty: the scene's only material
  double radius = 0.0;     // (m) positive
  double density = unset;  // (kg/m³) positive, or unset: the material's
  double mass = unset;     // (kg) positive, or unset: from the density. Not together with density
  Vec3 position{};         // (m) in two dimensions z = 0
  Vec3 velocity{};         // (m/s) in two dimensions vz = 0
  Vec3 spin{};             // (rad/s) in two dimensions only z may differ from 0
};

// Axis-parallel box.
struct Bounds {
  Vec3 lower{};  // (m)
  Vec3 upper{};  // (m) at least lower
};

// Bodies and the box they came in.
struct Packing {
  int dimension = 3;  // 2 or 3
  std::vector<Body> bodies;
  std::optional<Bounds> bounds;    // absent: the source named no box
  std::array<bool, 3> periodic{};  // along x, y, z; a periodic axis needs bounds of positive length
  double time = 0.0;               // (s) at which the bodies were recorded
};

// Throws Error naming the body and the field unless the packing keeps the rules above and holds a body.
void check(const Packing& packing);

// Box around all bodies, surface included. (m) The packing must hold a body.
Bounds enclosing_bounds(const Packing& packing);

// Density that gives a sphere of this body's radius its mass. (kg/m³) unset if the body has neither.
double sphere_density(const Body& body);

}  // namespace scree::packing
