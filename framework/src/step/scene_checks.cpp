#include "plugins/body_forces.hpp"
#include "walls/boundaries.hpp"

#include <scree/error.hpp>
#include <scree/plugin/program.hpp>
#include <scree/scene_checks.hpp>

namespace scree {

std::size_t wall_count(const Scene& scene) { return boundaries_of(scene).wall_count(); }

std::vector<std::string> plane_names(const Scene& scene) { return boundaries_of(scene).plane_names(); }

std::vector<std::string> surface_names(const Scene& scene) { return boundaries_of(scene).surfaces().names; }

Domain periodic_domain(const Scene& scene) { return boundaries_of(scene).domain(); }

namespace {

// Points and velocities of the walls of a boundary after the first step, in which they meet a spring where
// they try displacements.
std::vector<double> after_step(const Scene& scene, const Parameters& boundary) {
  Boundaries alone({{"alone", 0, boundary}}, scene.dimension, bounds_of(scene.bodies, scene.dimension));
  const double length = alone.displacement_speed() * scene.step;
  alone.begin_step(0, scene.step, [length](std::size_t, const double* displacement) {
    scree_load load = {};
    for (int k = 0; k < 3; ++k) load.force[k] = -displacement[k] / length;  // 1 N at the largest displacement
    return load;
  });
  alone.finish_step(0, scene.step);
  std::vector<double> all;
  for (const scree_plane& plane : alone.planes()) {
    all.insert(all.end(), plane.point, plane.point + 3);
    all.insert(all.end(), plane.velocity, plane.velocity + 3);
  }
  return all;
}

}  // namespace

bool has_effect(const Scene& scene, const Parameters& boundary, const std::string& program) {
  try {
    Parameters constant = boundary, rising = boundary;
    constant.set(program, {Program::constant, 0});
    rising.set(program, {Program::ramp, 0, 1, scene.step});
    return after_step(scene, constant) != after_step(scene, rising);
  } catch (const Error&) {
    return true;  // one that takes no such values may have one
  }
}

std::optional<std::string> varying_body_force(const Scene& scene) {
  for (const Scene::BodyForce& force : scene.body_forces) {
    const Parameters& parameters = force.parameters;
    const std::vector<scree_value> values = parameters.values();
    for (std::uint32_t k = 0; k < parameters.plugin().parameter_count && !parameters.absent(); ++k)
      if (const scree_parameter& p = parameters.plugin().parameters[k];
          p.type == SCREE_PROGRAM && values[k].count > 0 && Program(values[k]).kind() != Program::constant)
        return force.name + '.' + p.key;
  }
  return {};
}

void check_body_force(const Scene::BodyForce& force, const Scene& scene) {
  BodyForces({force}, scene.dimension, scene.audit);
}

}  // namespace scree
