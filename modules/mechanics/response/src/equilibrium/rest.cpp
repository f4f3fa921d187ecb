#include "assembly/body_force_terms.hpp"
#include "assembly/contact_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/response/quasi_static.hpp>
#include <scree/response/rest.hpp>

namespace scree::response {

namespace {

// Net force over mean force that is round-off of positions and springs.
constexpr double balanced_to_round_off = 1e-9;
// Change of K, or unbalance where there is no equilibrium, above which a warning is given.
constexpr double noticed = 1e-4;
// Above this number sparse factors take longer than the linear response itself.
constexpr Eigen::Index most_degrees_of_freedom = 12000;

// Net forces on bodies, then walls (N), and torques (N m); on walls about the centres of their turns.
struct NetLoads {
  std::vector<Eigen::Vector3d> force, torque;
  std::vector<double> lever;  // (m) largest distance of a contact from the centre of a turn

  explicit NetLoads(std::size_t ends)
      : force(ends, Eigen::Vector3d::Zero()), torque(ends, Eigen::Vector3d::Zero()), lever(ends, 0) {}
  void add(const ContactTerms& contact, std::size_t bodies, const WallEquations& walls) {
    force[contact.a] += contact.force, torque[contact.a] += contact.torque;
    force[contact.b] -= contact.force;
    if (contact.b < bodies) {
      torque[contact.b] += contact.torque_b;
    } else {
      const Eigen::Vector3d arm = contact.place - Eigen::Vector3d(walls.walls[contact.b - bodies].centre);
      torque[contact.b] -= contact.torque + arm.cross(contact.force);
      lever[contact.b] = std::max(lever[contact.b], arm.norm());
    }
  }
};

// Largest net load along a degree of freedom (N); torques are divided by a radius or lever.
double largest_of(const NetLoads& net, const DegreesOfFreedom& freedom, const WallEquations& walls,
                  const Particles& p) {
  constexpr auto none = DegreesOfFreedom::none;
  double largest = 0;
  for (std::size_t i = 0; i < freedom.bodies(); ++i) {
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = force;
    for (int k = 0; k < freedom.dimension(); ++k)
      if (freedom.translation(i, k) != none) force[k] = net.force[i][k];
    for (int k = 0; k < freedom.spins(); ++k)
      if (freedom.rotation(i, k) != none) torque[k] = net.torque[i][freedom.dimension() == 2 ? 2 : k];
    largest = std::max({largest, force.norm(), torque.norm() / p.radius()[i]});
  }
  for (std::size_t w = 0; w < freedom.walls(); ++w) {
    const std::size_t end = freedom.bodies() + w;
    const scree_linear_wall& wall = walls.walls[w];
    if (freedom.wall(w) != none)
      largest = std::max(largest,
                         std::abs(wall.pressing_force + Eigen::Vector3d(wall.direction).dot(net.force[end])));
    if (freedom.turn(w) != none && net.lever[end] > 0)
      largest =
          std::max(largest, std::abs(wall.pressing_torque + Eigen::Vector3d(wall.axis).dot(net.torque[end])) /
                                net.lever[end]);
  }
  return largest;
}

// Rest::unbalance of bodies and walls where they are, at rest.
double unbalance_of(const Simulation& simulation, const DegreesOfFreedom& freedom, AtLimit at_limit) {
  const WallEquations walls = simulation.linear_walls();
  NetLoads net(freedom.bodies() + freedom.walls());
  const std::vector<BodyForceTerms> forces = linearise_body_forces(simulation, freedom.spins());
  const int dimension = simulation.dimension();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    net.force[i].head(dimension) = forces[i].load.head(dimension);
    for (int k = 0; k < freedom.spins(); ++k)
      net.torque[i][dimension == 2 ? 2 : k] = forces[i].load[dimension + k];
  }
  double sum = 0;
  const std::vector<ContactTerms> contacts = linearise_contacts(simulation, freedom.spins(), at_limit);
  for (const ContactTerms& contact : contacts) {
    sum += contact.force.norm();
    net.add(contact, freedom.bodies(), walls);
  }
  const double largest = largest_of(net, freedom, walls, simulation.particles());
  return sum > 0 ? largest / (sum / double(contacts.size())) : 0;
}

// Name of a surface that torques turn, for which no equilibrium is searched; "" without one.
std::string turned_surface(const Simulation& simulation) {
  const WallEquations equations = simulation.linear_walls();
  for (std::size_t w = 0; w < equations.walls.size(); ++w)
    if (equations.walls[w].turns) return simulation.wall_name(w);
  return "";
}

std::unique_ptr<Simulation> equilibrium_of(const Simulation& simulation,
                                           const std::function<bool()>& proceed) {
  try {
    QuasiStatic packing(simulation, {.longest_increment = simulation.step_length(), .proceed = proceed});
    if (!packing.advance(simulation.time())) return nullptr;
    return std::make_unique<Simulation>(simulation.scene(), packing.state());
  } catch (const Error&) {  // for example, walls are moved by speeds
    return nullptr;
  }
}

double change_of(const LinearSystem& from, const LinearSystem& to) {
  if (from.freedom.size() != to.freedom.size() || from.rattlers != to.rattlers)
    return std::numeric_limits<double>::infinity();
  return Eigen::SparseMatrix<double>(from.stiffness - to.stiffness).norm() / to.stiffness.norm();
}

std::string warning_of(const Rest& rest, const std::string& turned) {
  const std::string what = fmt::format(
      "the packing is not at rest: net forces, or torques over radii, on bodies and walls are up to {:.2g} of the mean force of its contacts",
      rest.unbalance);
  const char* const cure = "let it come to rest (until.kinetic_over_elastic)";
  if (!rest.equilibrium)
    return rest.unbalance > noticed
               ? fmt::format(
                     "{}, and no equilibrium nearby was {}, so that the linear response is that of a packing that moves; {}",
                     what,
                     turned.empty() ? "found" : fmt::format("searched for, since torques turn {}", turned),
                     cure)
               : "";
  if (std::isinf(rest.stiffness_change))
    return fmt::format(
        "{}; the linear response is that of the equilibrium nearby, in which other bodies are held; {}", what,
        cure);
  return rest.stiffness_change > noticed
             ? fmt::format(
                   "{}, and its stiffness differs by {:.2g} from the equilibrium nearby, whose linear response this is; {} to "
                   "compare it with a sweep",
                   what, rest.stiffness_change, cure)
             : "";
}

}  // namespace

Rest rest_of(const Simulation& simulation, const AssemblyOptions& options,
             const std::function<bool()>& proceed) {
  const LinearSystem present = assemble(simulation, options);
  Rest rest;
  rest.unbalance = unbalance_of(simulation, present.freedom, options.at_limit);
  if (rest.unbalance <= balanced_to_round_off) return rest;
  if (present.freedom.size() <= most_degrees_of_freedom)
    rest.equilibrium = equilibrium_of(simulation, proceed);
  if (rest.equilibrium) rest.stiffness_change = change_of(present, assemble(*rest.equilibrium, options));
  rest.warning = warning_of(rest, turned_surface(simulation));
  return rest;
}

}  // namespace scree::response
