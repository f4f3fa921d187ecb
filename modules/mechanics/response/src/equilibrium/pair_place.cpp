#include "equilibrium/pair_place.hpp"

#include <Eigen/Geometry>

namespace scree::response {

namespace {

Eigen::Vector3d vector(const Vec3& v) { return Eigen::Map<const Eigen::Vector3d>(v.component); }

// Matrix of x ↦ v × x.
Eigen::Matrix3d crossing(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return matrix;
}

Eigen::Matrix3d across(const Eigen::Vector3d& n) { return Eigen::Matrix3d::Identity() - n * n.transpose(); }

}  // namespace

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

Vec3 PairPlace::slip(const Vec3& along, double at_distance, scree_arms arms) const {
  const LeverArms arm = lever_arms(arms, at_distance);
  return moved + cross(along, arm.a * turned_a + arm.b * turned_b);
}

Vec3 PairPlace::slip_across(scree_arms arms) const {
  const Vec3 displaced = slip(mid_normal, mid_distance, arms);
  return displaced - dot(displaced, mid_normal) * mid_normal;
}

Vec3 PairPlace::tangential_increment(scree_arms arms) const { return touched() * slip_across(arms); }

// Of t = τ (1 − n nᵀ) s, s = u + n × w, w = l_a θ_a + l_b θ_b, with n and l of the middle, and the share τ = δ/a of a pair that begins to touch, which
// approaches by a. The centres move half as far by the middle: n changes by (1 − n nᵀ) u/(2d), l by n·u/4.
SlipDerivative PairPlace::slip_derivative(scree_arms arms) const {
  const Eigen::Vector3d n = vector(mid_normal), end = vector(normal),
                        s = vector(slip(mid_normal, mid_distance, arms));
  const LeverArms arm = lever_arms(arms, mid_distance);
  const double share = touched(), arm_change = arms == SCREE_ARM_CONTACT_POINT ? 0.25 : 0;
  const Eigen::Vector3d rotation_a = vector(turned_a),
                        rotation_b = to_wall() ? Eigen::Vector3d(0, 0, 0) : vector(turned_b);
  const Eigen::Matrix3d project = across(n);
  const Eigen::Matrix3d turn =
      to_wall() ? Eigen::Matrix3d::Zero() : Eigen::Matrix3d(project / (2 * mid_distance));
  Eigen::Matrix3d displaced = Eigen::Matrix3d::Identity() -
                              crossing(arm.a * rotation_a + arm.b * rotation_b) * turn +
                              arm_change * n.cross(rotation_a + rotation_b) * n.transpose();
  Eigen::Matrix3d by_displacement =
      share * (project * displaced - (n.dot(s) * Eigen::Matrix3d::Identity() + n * s.transpose()) * turn);
  if (share < 1) {
    const Eigen::Vector3d moves = vector(moved);
    const Eigen::Vector3d approaching =
        to_wall() ? end : Eigen::Vector3d(end + across(end) * moves / distance);
    by_displacement += project * s * (share * approaching - end).transpose() / approach();
  }
  const Eigen::Matrix3d by_turning = share * project * crossing(n);
  return {by_displacement, arm.a * by_turning, arm.b * by_turning};
}

}  // namespace scree::response
