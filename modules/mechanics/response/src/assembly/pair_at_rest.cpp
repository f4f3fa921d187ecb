#include "assembly/pair_at_rest.hpp"

namespace scree::response {

Eigen::Matrix3d matrix_of(const Matrix3& rows) {
  Eigen::Matrix3d matrix;
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) matrix(k, l) = rows[std::size_t(k)][l];
  return matrix;
}

PairAtRest::PairAtRest(const Particles& particles, std::uint32_t first, std::uint32_t second)
    : a(first),
      b(second),
      radius_a(particles.radius()[first]),
      radius_b(second < particles.size() ? particles.radius()[second] : 0),
      effective_radius(scree::effective_radius(radius_a, radius_b, to_wall())) {}

void PairAtRest::set_between_bodies(const Vec3& between) {
  separation = between;
  const PairDirection<3> direction = direction_between(between);
  normal = direction.normal, distance = direction.distance;
  change = PairVariation::of_bodies(normal, distance);
}

void PairAtRest::set_at_surface(const SurfacePlace& place, const Vec3& from_origin) {
  separation = from_origin;
  normal = place.direction.normal, distance = place.direction.distance;
  effective_radius = place.effective_radius;
  change = place.change;
  wall_orientation = place.orientation;
}

Levers PairAtRest::lever_arms(scree_arms arms, double at_distance) const {
  return with_kind([&](auto plane) -> Levers {
    const auto levers = LeverArms<plane.value>::of(arms == SCREE_ARM_CONTACT_POINT, at_distance, radius_sum(),
                                                   radius_difference());
    return {levers.a, levers.b};
  });
}

ContactGeometry PairAtRest::geometry(int dimension, int spins, scree_arms arms) const {
  const Levers levers = lever_arms(arms);
  return {.dimension = dimension,
          .spins = spins,
          .normal = Eigen::Map<const Eigen::Vector3d>(normal.component),
          .arm_a = levers.a,
          .arm_b = levers.b,
          .normal_change = matrix_of(change.normal),
          .arms_change = arms == SCREE_ARM_CONTACT_POINT};
}

void PairAtRest::set_inputs(const Particles& particles, const Orientations& orientations, std::uint32_t reads,
                            ContactColumns& columns, std::size_t i) const {
  columns.set(SCREE_NORMAL, normal, i);
  columns.input(SCREE_OVERLAP, 0, i) = overlap();
  columns.input(SCREE_REDUCED_MASS, 0, i) =
      to_wall() ? reduced_mass(particles.inverse_mass_at_wall(a), 0)
                : reduced_mass(particles.inverse_mass()[a], particles.inverse_mass()[b]);
  columns.input(SCREE_EFFECTIVE_RADIUS, 0, i) = effective_radius;
  columns.input(SCREE_RADII, 0, i) = radius_a;
  columns.input(SCREE_RADII, 1, i) = radius_b;
  columns.set(SCREE_SEPARATION, separation + crossed, i);
  const auto turning = symmetric_components(change.normal);
  for (int k = 0; k < 6; ++k) columns.input(SCREE_NORMAL_CHANGE, k, i) = turning[std::size_t(k)];
  if (reads & (1u << SCREE_ORIENTATION_A)) set_orientations(orientations, columns, i);
}

void PairAtRest::set_orientations(const Orientations& orientations, ContactColumns& columns,
                                  std::size_t i) const {
  for (int k = 0; k < orientations.components(); ++k) {
    const double of_wall = orientations.components() > 1 ? wall_orientation[k] : 0;
    columns.input(SCREE_ORIENTATION_A, k, i) = orientations[k][a];
    columns.input(SCREE_ORIENTATION_B, k, i) = to_wall() ? of_wall : orientations[k][b];
  }
}

}  // namespace scree::response
