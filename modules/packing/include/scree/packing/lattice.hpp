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

// Every lattice has count[0]·count[1]·count[2] sites. With d the distance of nearest sites:
enum class LatticeKind {
  simple_cubic,        // rows d apart along x, y and z
  face_centred_cubic,  // square layers, d/√2 apart in z, alternate ones shifted by (d/2, d/2)
  hexagonal_close,     // triangular layers, d√(2/3) apart in z, stacked ABAB
  square,              // two dimensions: rows d apart along x and y
  triangular,          // two dimensions: rows d√3/2 apart in y, alternate ones shifted by d/2 in x
};

// Most bodies that a lattice may have.
inline constexpr std::int64_t largest_lattice = 100'000'000;

// Kind of that name ("simple_cubic", ...). An unknown name throws Error with the nearest known one.
LatticeKind lattice_kind(std::string_view name);
std::string_view lattice_name(LatticeKind kind);
int lattice_dimension(LatticeKind kind);

struct LatticeOptions {
  LatticeKind kind = LatticeKind::simple_cubic;
  // Either the sites along x, y, z (positive, along z 1 in two dimensions), or the number of bodies. The
  // latter takes the box nearest to a cube or square that holds them; its last row or layer stays incomplete.
  std::optional<std::array<std::int64_t, 3>> count;
  std::optional<std::int64_t> total;
  // Distance of nearest sites (m). Absent: 2·(largest drawn radius)·(1 + gap) + 2·displacement.
  std::optional<double> spacing;
  double gap = 0.0;           // automatic spacing only, not negative
  double displacement = 0.0;  // (m) each body is moved at random within a ball of that radius
  Vec3 origin{};              // (m) lower corner of the box, or with centred its centre
  bool centred = false;
  std::array<bool, 3> periodic{};  // axes along which the lattice closes; staggered ones need an even count
  std::string material;
  double density = unset;  // (kg/m³)
  std::int64_t first_id = 1;
};

// Bodies on a lattice, x fastest, in a box that holds them (periodic axes: exactly the lattice period).
// Radii are drawn first, then displacements. Throws Error for senseless options and if bodies overlap by more
// than rounding: the message names the two, their overlap and the spacing that would do.
Packing fill_lattice(const LatticeOptions& options, const RadiusDistribution& radii, Random& random);

}  // namespace scree::packing
