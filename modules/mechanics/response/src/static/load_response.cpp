#include "static/static_packing.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include <scree/error.hpp>
#include <scree/response/load_response.hpp>

namespace scree::response {

namespace {

using Eigen::Vector3d;

Vector3d in_space(const Eigen::VectorXd& v) {
  Vector3d all = Vector3d::Zero();
  all.head(v.size()) = v;
  return all;
}

Vector3d normal_of(const StaticPacking& packing, const ContactTerms& c) {
  return Vector3d(packing.list().normal.data() + 3 * c.contact);
}

// Derivatives of n·f and of the tangential force by the load; both n and f change.
LoadedContact loaded(const StaticPacking& packing, const PackingMotion& motion, const ContactTerms& c,
                     const Particles& p) {
  const bool flat = p.dimension() == 2;
  const Vector3d normal = normal_of(packing, c), turn = packing.normal_change(motion, c);
  const Vector3d change = in_space(packing.force_change(motion, c));
  const double normal_force = c.force.dot(normal);
  const Vector3d along = c.force - normal_force * normal;
  const Vector3d along_change = change - change.dot(normal) * normal - normal_force * turn;
  const double length = along.norm();
  return {.a = c.a,
          .b = c.b,
          .sliding = c.sliding,
          .normal_force = normal_force,
          .tangential_force = flat ? normal.cross(c.force).z() : length,
          .normal_change = change.dot(normal) + c.force.dot(turn),
          .tangential_change = flat         ? (normal.cross(change) + turn.cross(c.force)).z()
                               : length > 0 ? along_change.dot(along) / length
                                            : along_change.norm()};
}

LoadResponse response_to(const StaticPacking& packing, const Particles& particles, std::size_t wall) {
  const DegreesOfFreedom& freedom = packing.system().freedom;
  const PackingMotion motion = packing.load(wall);
  LoadResponse response{.wall = wall,
                        .walls = {},
                        .bodies = {},
                        .displacement = {},
                        .contacts = {},
                        .residual = motion.residual};
  for (std::size_t w = 0; w < freedom.walls(); ++w)
    response.walls.push_back(freedom.wall(w) == DegreesOfFreedom::none ? 0 : motion.motion[freedom.wall(w)]);
  for (std::uint32_t i = 0; i < freedom.bodies(); ++i) {
    if (!packing.is_held(i)) continue;
    response.bodies.push_back(i);
    for (int k = 0; k < freedom.dimension() + freedom.spins(); ++k)
      response.displacement.push_back(packing.component(motion, i, k));
  }
  for (const ContactTerms& c : packing.contacts())
    if (packing.is_held(c.a) && packing.is_held(c.b))
      response.contacts.push_back(loaded(packing, motion, c, particles));
  return response;
}

Error no_loaded_wall() {
  return Error(
      "no wall is moved by forces, on which a load could grow; give a wall a stress or a force, or leave --loads out");
}

}  // namespace

std::vector<LoadResponse> load_responses(const Simulation& simulation, const AssemblyOptions& options,
                                         const std::function<bool()>& proceed) {
  const StaticPacking packing(simulation, options, proceed);
  std::vector<LoadResponse> all;
  for (std::size_t w = 0; w < packing.system().freedom.walls(); ++w) {
    if (packing.system().freedom.wall(w) == DegreesOfFreedom::none) continue;
    if (!proceed())
      throw Error("interrupted before all responses to loads were known", ExitStatus::interrupted);
    all.push_back(response_to(packing, simulation.particles(), w));
  }
  if (all.empty()) throw no_loaded_wall();
  return all;
}

void check_loaded_walls(const Simulation& simulation) {
  const WallEquations equations = simulation.linear_walls();
  if (std::none_of(equations.walls.begin(), equations.walls.end(),
                   [](const auto& wall) { return wall.free; }))
    throw no_loaded_wall();
}

}  // namespace scree::response
