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
                     const StaticMotion& all, const MeshContact* on_mesh)
    : PairAtRest(simulation.particles(), pair.a, pair.b),
      motion{all.displacement[pair.a] - all.displacement[pair.b], all.rotation[pair.a],
             all.rotation[pair.b]} {
  separation = after.position[pair.a] - after.position[pair.b] + pair.shift;
  const std::size_t wall = pair.b - simulation.particles().size(), planes = simulation.planes().size();
  if (!to_wall())
    set_between();
  else if (wall < planes)
    set_at_plane(simulation.planes()[wall]);
  else if (on_mesh)
    set_on_mesh(*pair.spot, *on_mesh, rotation_of(simulation.surfaces().frames[wall - planes]));
  else
    set_at_surface(simulation.surfaces(), wall - planes, simulation.dimension());
  if (to_wall()) crossed = -pair.shift;
}

void PairPlace::set_between() {
  set_between_bodies(separation);
  middle = mid_step_direction<false>(direction(), separation, motion.velocity, 1);
  middle_change = PairVariation::of_bodies(middle.normal, middle.distance).normal;
  middle_distance_change = 0.5 * middle.normal;
}

void PairPlace::set_at_plane(const scree_plane& plane) {
  for (int k = 0; k < 3; ++k) normal[k] = plane.normal[k];
  distance = distance_from_plane(separation, normal);
  middle = mid_step_direction<true>(direction(), separation, motion.velocity, 1);
  middle_change = {};
  middle_distance_change = 0.5 * normal;
}

void PairPlace::set_at_surface(const WallSurfaces& all, std::size_t surface, int dimension) {
  const BodyAtSurface end = {surface, dimension, separation, radius_a};
  BodyAtSurface half_way = end;
  half_way.from_origin -= 0.5 * motion.velocity;
  PairAtRest::set_at_surface(nearest_place(all, end), separation);
  const SurfacePlace there = nearest_place(all, half_way);
  middle_change = there.change.normal;
  set_middle(there.direction.normal);
}

void PairPlace::set_middle(const Vec3& middle_normal) {
  // As the kernel has it: the distance at the end less the way since the middle.
  const Vec3 half = 0.5 * motion.velocity;
  middle = mid_step_direction<true>({middle_normal, distance}, separation, motion.velocity, 1);
  middle_distance_change = normal - 0.5 * middle.normal;
  for (int k = 0; k < 3; ++k) middle_distance_change -= 0.5 * half[k] * middle_change[std::size_t(k)];
}

// As the kernel has it, the normal in the middle is between those of the spots before and now.
void PairPlace::set_on_mesh(const SurfaceSpot& before, const MeshContact& contact, const Rotation& to_scene) {
  constexpr double apart = 2;  // distance of a body that has no spot, in radii
  if (!contact.place) {
    normal = to_scene(before.normal), distance = apart * radius_a;
    change = {}, middle_change = {};
    return set_middle(normal);
  }
  PairAtRest::set_at_surface(*contact.place, separation);
  spot = contact.place->spot;
  const Vec3 sum = (contact.touched ? to_scene(before.normal) : normal) + normal,
             between = 1 / norm(sum) * sum;
  // By half of the displacement, of which the end is the whole.
  const double share = contact.touched ? 1 : 2;
  const Eigen::Matrix3d turned = 2 * share / norm(sum) * across(vector(between)) * matrix_of(change.normal);
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) middle_change[std::size_t(k)][l] = turned(k, l);
  set_middle(between);
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
// are taken in the middle of the increment, by which the centres have moved half as far: n changes by half of
// its derivative times u, and l by half of the change of the distance, n·u/2 of bodies. A pair that begins to
// touch, and approaches by a, touches for the share τ = δ/a.
SlipDerivative PairPlace::slip_derivative(scree_arms arms) const {
  const Eigen::Vector3d n = vector(middle.normal), end = vector(normal), s = vector(slip(middle, arms));
  const Levers arm = lever_arms(arms, middle.distance);
  const double share = touched(), arm_change = arms == SCREE_ARM_CONTACT_POINT ? 0.5 : 0;
  const Eigen::Vector3d rotation_a = vector(motion.spin_a),
                        rotation_b = to_wall() ? Eigen::Vector3d(0, 0, 0) : vector(motion.spin_b);
  const Eigen::Matrix3d project = across(n);
  const Eigen::Matrix3d turn = 0.5 * matrix_of(middle_change);
  Eigen::Matrix3d displaced =
      Eigen::Matrix3d::Identity() - crossing(arm.a * rotation_a + arm.b * rotation_b) * turn +
      arm_change * n.cross(rotation_a + rotation_b) * vector(middle_distance_change).transpose();
  Eigen::Matrix3d by_displacement =
      share * (project * displaced - (n.dot(s) * Eigen::Matrix3d::Identity() + n * s.transpose()) * turn);
  if (share < 1) {
    const Eigen::Vector3d moves = vector(motion.velocity);
    const Eigen::Vector3d approaching = end + matrix_of(change.normal) * moves;
    by_displacement += project * s * (share * approaching - end).transpose() / approach();
  }
  const Eigen::Matrix3d by_turning = share * project * crossing(n);
  return {by_displacement, arm.a * by_turning, arm.b * by_turning};
}

}  // namespace scree::response
