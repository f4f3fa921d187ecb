#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <scree/domain.hpp>
#include <scree/plugin/vec.hpp>

namespace scree::packing {

// "Not given": the value of the body's material applies.
inline constexpr double unset = std::numeric_limits<double>::quiet_NaN();

// One sphere (or disc). check() below enforces the ranges.
struct Body {
  std::int64_t id = 0;     // positive, unique in its packing; in files at most SCREE_MAX_ID
  std::string material;    // name, or type number from a LAMMPS file; empty: the only material of the scene
  double radius = 0.0;     // (m) positive
  double density = unset;  // (kg/m³) positive, or unset: from the material
  double mass = unset;     // (kg) positive, or unset: from the density. Not allowed together with density
  Vec3 position{};         // (m) in two dimensions z = 0
  Vec3 velocity{};         // (m/s) in two dimensions vz = 0
  Vec3 spin{};             // (rad/s) in two dimensions only z may differ from 0
};

// Axis-parallel box.
struct Bounds {
  Vec3 lower{};  // (m)
  Vec3 upper{};  // (m) at least lower
};

// Bodies and their box.
struct Packing {
  int dimension = 3;  // 2 or 3
  std::vector<Body> bodies;
  std::optional<Bounds> bounds;            // absent: the source has no box
  std::array<bool, 3> periodic{};          // along x, y, z; a periodic axis needs bounds of positive length
  double time = 0.0;                       // (s) of the recorded state
  std::optional<std::int64_t> timestep{};  // of the frame of a dump
  bool own_ids = false;                    // the source has ids; else they number its bodies
  std::string format;                      // of a file, as a noun: "CSV"
};

// Throws Error naming the body and the field unless the packing obeys the rules above and has a body.
void check(const Packing& packing);

// Bounding box of all bodies, including their surfaces (m). The packing must have a body.
Bounds enclosing_bounds(const Packing& packing);

// Gives a packing the periodic axes of a scene, around the bodies along the others; leaves it without a box
// if there are none.
void set_periodic(Packing& packing, const Domain& domain);

// Density (kg/m³) of a sphere with the radius and mass of this body; unset if it has neither.
double sphere_density(const Body& body);

}  // namespace scree::packing
