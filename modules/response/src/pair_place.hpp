#pragma once

#include "contact_geometry.hpp"
#include "static_configuration.hpp"

#include <cstdint>

#include <scree/plugin/abi.h>

namespace scree::response {

// A pair of bodies, or of a body and a wall.
struct StaticPair {
  std::uint32_t a, b;  // as in ContactList
  Vec3 shift;          // (m) added to x_a − x_b of bodies, for the nearest images
};

// Where a pair is at the end of an increment, and how it came there.
struct PairPlace {
  Vec3 separation, normal, mid_normal;  // (m) as SCREE_SEPARATION; at the end, and in the middle
  double distance, mid_distance;        // (m)
  double radius_a, radius_b;            // (m); of a wall 0
  Vec3 moved, turned_a, turned_b;       // of a's centre relative to b's (m), rotations (rad)

  PairPlace(const Simulation& simulation, const StaticPair& pair, const StaticConfiguration& after,
            const StaticMotion& motion);

  double overlap() const { return radius_a + radius_b - distance; }
  // Share of the increment during which the pair touches.
  double touched() const;
  // Displacement of a's contact point relative to b's (m): with the normal at the end, and across that of the middle.
  Vec3 slip(scree_arms arms) const { return slip(normal, distance, arms); }
  Vec3 tangential_increment(scree_arms arms) const;
  ContactGeometry geometry(int dimension, int spins, scree_arms arms) const;

 private:
  struct Arms {
    double a, b;  // (m)
  };
  Arms arms_at(double at_distance, scree_arms arms) const;
  Vec3 slip(const Vec3& along, double at_distance, scree_arms arms) const;
};

}  // namespace scree::response
