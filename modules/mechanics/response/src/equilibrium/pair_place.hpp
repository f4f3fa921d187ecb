#pragma once

#include "assembly/pair_at_rest.hpp"
#include "assembly/slip_derivative.hpp"
#include "equilibrium/static_configuration.hpp"
#include "equilibrium/static_pair.hpp"

#include <algorithm>

namespace scree::response {

// Where a pair is at the end of an increment, and how it came there.
struct PairPlace : PairAtRest {
  Vec3 mid_normal;                 // in the middle of the increment
  double mid_distance;             // (m)
  Vec3 moved, turned_a, turned_b;  // of a's centre relative to b's (m), rotations (rad)

  PairPlace(const Simulation& simulation, const StaticPair& pair, const StaticConfiguration& after,
            const StaticMotion& motion);

  // Displacement of a's contact point relative to b's (m): with the normal at the end, and across that of the middle.
  Vec3 slip(scree_arms arms) const { return slip(normal, distance, arms); }
  Vec3 tangential_increment(scree_arms arms) const;
  SlipDerivative slip_derivative(scree_arms arms) const;

 private:
  double approach() const { return -dot(moved, normal); }
  // Share of the increment during which the pair touches.
  double touched() const { return overlap() < approach() ? std::max(overlap(), 0.0) / approach() : 1; }
  Vec3 slip(const Vec3& along, double at_distance, scree_arms arms) const;
  // Of the whole increment, across the normal in its middle.
  Vec3 slip_across(scree_arms arms) const;
};

}  // namespace scree::response
