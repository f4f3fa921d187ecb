#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <scree/packing/packing.hpp>
#include <scree/packing/radius_distribution.hpp>
#include <scree/packing/random.hpp>

namespace scree::packing {

// Every lattice has count[0]·count[1]·count[2] sites. d: distance between nearest sites.
enum class LatticeKind {
  simple_cubic,        // rows d apart along x, y and z
  face_centred_cubic,  // square layers, d/√2 apart in z, alternate ones shifted by (d/2, d/2)
  hexagonal_close,     // triangular layers, d√(2/3) apart in z, stacked ABAB
  square,              // two dimensions: rows d apart along x and y
  triangular,          // two dimensions: rows d√3/2 apart in y, alternate ones shifted by d/2 in x
};

// Maximum number of bodies in a lattice.
inline constexpr std::int64_t max_lattice_sites = 100'000'000;

// Kind by name ("simple_cubic", ...). Throws Error for an unknown name, with the nearest known one.
LatticeKind lattice_kind(std::string_view name);
std::string_view lattice_name(LatticeKind kind);
int lattice_dimension(LatticeKind kind);

struct LatticeOptions {
  LatticeKind kind = LatticeKind::simple_cubic;
  // Give either `count`, the number of sites along x, y, z (positive; 1 along z in two dimensions), or
  // `total`, the number of bodies. For `total` the box is as near to a cube or square as possible, and its
  // last row or layer may be incomplete.
  std::optional<std::array<std::int64_t, 3>> count;
  std::optional<std::int64_t> total;
  // Distance between nearest sites (m). Absent: 2·(largest drawn radius)·(1 + gap) + 2·displacement.
  std::optional<double> spacing;
  double gap = 0.0;           // not negative; used only if spacing is absent
  double displacement = 0.0;  // (m) each body is moved at random within a ball of this radius
  Vec3 origin{};              // (m) lower corner of the box; its centre if `centred`
  bool centred = false;
  std::array<bool, 3> periodic{};  // staggered axes need an even count to be periodic
  std::string material;
  double density = unset;  // (kg/m³)
  std::int64_t first_id = 1;
};

// Bodies on a lattice, x index fastest, in a box that holds them (along periodic axes: one lattice period).
// Radii are drawn first, then displacements. Throws Error for invalid options, and if bodies overlap by more
// than rounding error: the message names the two bodies, their overlap and a sufficient spacing.
Packing fill_lattice(const LatticeOptions& options, const RadiusDistribution& radii, Random& random);

}  // namespace scree::packing
