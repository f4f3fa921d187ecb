#include <scree/particles.hpp>

namespace scree {

namespace {

void allocate(Column<double> (&columns)[3], Particles::Axes axes, std::size_t count) {
  for (int k = axes.first; k < axes.last; ++k) columns[k].assign(count, 0.0);
}

}  // namespace

Particles::Particles(int dimension, bool with_spin, bool with_images, const std::vector<Body>& bodies)
    : dimension_(dimension), has_spin_(with_spin) {
  const std::size_t n = bodies.size();
  for (auto* columns : {&position, &velocity, &mid_velocity, &force}) allocate(*columns, axes(), n);
  for (auto* columns : {&spin, &mid_spin, &torque}) allocate(*columns, spin_axes(), n);
  if (with_images)
    for (int k = 0; k < dimension; ++k) image[k].assign(n, 0);
  for (auto* column : {&radius, &mass, &inverse_mass}) column->resize(n);
  if (with_spin) inertia.resize(n), inverse_inertia.resize(n);
  id.resize(n);
  material.resize(n);

  for (std::size_t i = 0; i < n; ++i) {
    const Body& body = bodies[i];
    for (int k = 0; k < dimension; ++k) {
      position[k][i] = body.position[k];
      velocity[k][i] = mid_velocity[k][i] = body.velocity[k];
    }
    for (int k = spin_axes().first; k < spin_axes().last; ++k) spin[k][i] = mid_spin[k][i] = body.spin[k];
    radius[i] = body.radius;
    mass[i] = body.mass;
    inverse_mass[i] = 1 / body.mass;
    if (with_spin) inertia[i] = body.inertia, inverse_inertia[i] = 1 / body.inertia;
    id[i] = body.id;
    material[i] = body.material;
  }
}

Body Particles::body(std::size_t i) const {
  Body b = {.id = id[i], .material = material[i], .radius = radius[i], .mass = mass[i]};
  if (has_spin_) b.inertia = inertia[i];
  for (int k = 0; k < dimension_; ++k) b.position[k] = position[k][i], b.velocity[k] = velocity[k][i];
  for (int k = spin_axes().first; k < spin_axes().last; ++k) b.spin[k] = spin[k][i];
  return b;
}

std::size_t Particles::bytes_per_body() const {
  const std::size_t spins = std::size_t(spin_axes().last - spin_axes().first);
  const std::size_t doubles = 4 * std::size_t(dimension_) + 3 * spins + (has_spin_ ? 5 : 3);
  const std::size_t images = image[0].empty() ? 0 : std::size_t(dimension_) * sizeof(std::int32_t);
  return doubles * sizeof(double) + images + sizeof(std::int64_t) + sizeof(std::uint32_t);
}

}  // namespace scree
