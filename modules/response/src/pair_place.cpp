#include "pair_place.hpp"

namespace scree::response {

PairPlace::PairPlace(const Simulation& simulation, const StaticPair& pair, const StaticConfiguration& after,
                     const StaticMotion& motion)
    : PairAtRest(simulation.particles(), pair.a, pair.b),
      moved(motion.displacement[pair.a] - motion.displacement[pair.b]),
      turned_a(motion.rotation[pair.a]),
      turned_b(motion.rotation[pair.b]) {
  separation = after.position[pair.a] - after.position[pair.b] + pair.shift;
  if (to_wall()) {
    const scree_plane& plane = simulation.planes()[pair.b - simulation.particles().size()];
    for (int k = 0; k < 3; ++k) normal[k] = plane.normal[k];
    mid_normal = normal;
    distance = dot(separation, normal);
    mid_distance = distance - 0.5 * dot(moved, normal);
    return;
  }
  const Vec3 middle = separation - 0.5 * moved;
  distance = norm(separation), mid_distance = norm(middle);
  normal = 1 / distance * separation;
  mid_normal = 1 / mid_distance * middle;
}

Onset PairPlace::onset(scree_arms arms) const {
  Onset at = {.touched = touched()};
  if (!at.within_increment()) return at;
  at.slip = Eigen::Map<const Eigen::Vector3d>(slip_across(arms).component);
  at.touched_by_displacement =
      -(1 - at.touched) / approach() * Eigen::Map<const Eigen::Vector3d>(normal.component);
  return at;
}

Vec3 PairPlace::slip(const Vec3& along, double at_distance, scree_arms arms) const {
  const LeverArms arm = lever_arms(arms, at_distance);
  return moved + cross(along, arm.a * turned_a + arm.b * turned_b);
}

Vec3 PairPlace::slip_across(scree_arms arms) const {
  const Vec3 displaced = slip(mid_normal, mid_distance, arms);
  return displaced - dot(displaced, mid_normal) * mid_normal;
}

Vec3 PairPlace::tangential_increment(scree_arms arms) const { return touched() * slip_across(arms); }

}  // namespace scree::response
