#include "pair_place.hpp"

#include <algorithm>

namespace scree::response {

PairPlace::PairPlace(const Simulation& simulation, const StaticPair& pair, const StaticConfiguration& after,
                     const StaticMotion& motion)
    : separation(after.position[pair.a] - after.position[pair.b] + pair.shift),
      moved(motion.displacement[pair.a] - motion.displacement[pair.b]),
      turned_a(motion.rotation[pair.a]),
      turned_b(motion.rotation[pair.b]) {
  const Particles& p = simulation.particles();
  const bool is_wall = pair.b >= p.size();
  radius_a = p.radius()[pair.a];
  radius_b = is_wall ? 0 : p.radius()[pair.b];
  if (is_wall) {
    const scree_plane& plane = simulation.planes()[pair.b - p.size()];
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

double PairPlace::touched() const {
  const double approach = -dot(moved, normal);
  return overlap() < approach ? std::max(overlap(), 0.0) / approach : 1;
}

PairPlace::Arms PairPlace::arms_at(double at_distance, scree_arms arms) const {
  const double reach = arms == SCREE_ARM_CONTACT_POINT ? at_distance : radius_a + radius_b;
  const double difference = radius_a - radius_b;
  return {0.5 * (reach + difference), radius_b > 0 ? 0.5 * (reach - difference) : 0};
}

Vec3 PairPlace::slip(const Vec3& along, double at_distance, scree_arms arms) const {
  const Arms arm = arms_at(at_distance, arms);
  return moved + cross(along, arm.a * turned_a + arm.b * turned_b);
}

Vec3 PairPlace::tangential_increment(scree_arms arms) const {
  const Vec3 displaced = slip(mid_normal, mid_distance, arms);
  return touched() * (displaced - dot(displaced, mid_normal) * mid_normal);
}

ContactGeometry PairPlace::geometry(int dimension, int spins, scree_arms arms) const {
  const Arms arm = arms_at(distance, arms);
  return {.dimension = dimension,
          .spins = spins,
          .normal = Eigen::Map<const Eigen::Vector3d>(normal.component),
          .arm_a = arm.a,
          .arm_b = arm.b,
          .inverse_distance = radius_b > 0 ? 1 / distance : 0,
          .arms_change = arms == SCREE_ARM_CONTACT_POINT};
}

}  // namespace scree::response
