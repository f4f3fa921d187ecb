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
                     const StaticMotion& all)
    : PairAtRest(simulation.particles(), pair.a, pair.b),
      motion{all.displacement[pair.a] - all.displacement[pair.b], all.rotation[pair.a],
             all.rotation[pair.b]} {
  separation = after.position[pair.a] - after.position[pair.b] + pair.shift;
  if (to_wall()) {
    const scree_plane& plane = simulation.planes()[pair.b - simulation.particles().size()];
    for (int k = 0; k < 3; ++k) normal[k] = plane.normal[k];
    distance = distance_from_plane(separation, normal);
  } else {
    const PairDirection<3> between = direction_between(separation);
    normal = between.normal, distance = between.distance;
  }
  middle = with_kind([&](auto plane) {
    return mid_step_direction<plane.value>(direction(), separation, motion.velocity, 1);
  });
}

Vec3 PairPlace::slip(const PairDirection<3>& at, scree_arms arms) const {
  return with_kind([&](auto plane) {
    return contact_velocity<true, plane.value>(at, motion, arms == SCREE_ARM_CONTACT_POINT, radius_sum(),
                                               radius_difference());
  });
}

Vec3 PairPlace::tangential_increment(scree_arms arms) const {
  return with_kind([&](auto plane) {
    return scree::tangential_increment<true, plane.value>(middle, motion, arms == SCREE_ARM_CONTACT_POINT,
                                                          radius_sum(), radius_difference(), 1, touched());
  });
}

// The derivative of the increment t = τ (1 − n nᵀ) s with s = u + n × w and w = l_a θ_a + l_b θ_b. n and l
// are taken in the middle of the increment, by which the centres have moved half as far: n changes by (1 − n
// nᵀ) u/(2d) and l by n·u/4. A pair that begins to touch, and approaches by a, touches for the share τ = δ/a.
SlipDerivative PairPlace::slip_derivative(scree_arms arms) const {
  const Eigen::Vector3d n = vector(middle.normal), end = vector(normal), s = vector(slip(middle, arms));
  const Levers arm = lever_arms(arms, middle.distance);
  const double share = touched(), arm_change = arms == SCREE_ARM_CONTACT_POINT ? 0.25 : 0;
  const Eigen::Vector3d rotation_a = vector(motion.spin_a),
                        rotation_b = to_wall() ? Eigen::Vector3d(0, 0, 0) : vector(motion.spin_b);
  const Eigen::Matrix3d project = across(n);
  const Eigen::Matrix3d turn =
      to_wall() ? Eigen::Matrix3d::Zero() : Eigen::Matrix3d(project / (2 * middle.distance));
  Eigen::Matrix3d displaced = Eigen::Matrix3d::Identity() -
                              crossing(arm.a * rotation_a + arm.b * rotation_b) * turn +
                              arm_change * n.cross(rotation_a + rotation_b) * n.transpose();
  Eigen::Matrix3d by_displacement =
      share * (project * displaced - (n.dot(s) * Eigen::Matrix3d::Identity() + n * s.transpose()) * turn);
  if (share < 1) {
    const Eigen::Vector3d moves = vector(motion.velocity);
    const Eigen::Vector3d approaching =
        to_wall() ? end : Eigen::Vector3d(end + across(end) * moves / distance);
    by_displacement += project * s * (share * approaching - end).transpose() / approach();
  }
  const Eigen::Matrix3d by_turning = share * project * crossing(n);
  return {by_displacement, arm.a * by_turning, arm.b * by_turning};
}

}  // namespace scree::response
