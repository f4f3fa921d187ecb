#include "assembly/body_force_terms.hpp"
#include "assembly/contact_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

// Rest::unbalance of the bodies where they are, at rest.
double unbalance_of(const Simulation& simulation, const DegreesOfFreedom& freedom, AtLimit at_limit) {
  std::vector<Eigen::Vector3d> net(freedom.bodies(), Eigen::Vector3d::Zero());
  const std::vector<BodyForceTerms> forces = linearise_body_forces(simulation, freedom.spins());
  for (std::size_t i = 0; i < forces.size(); ++i)
    net[i].head(simulation.dimension()) = forces[i].load.head(simulation.dimension());
  double sum = 0;
  const std::vector<ContactTerms> contacts = linearise_contacts(simulation, freedom.spins(), at_limit);
  for (const ContactTerms& contact : contacts) {
    sum += contact.force.norm();
    net[contact.a] += contact.force;
    if (contact.b < net.size()) net[contact.b] -= contact.force;
  }
  double largest = 0;
  for (std::size_t i = 0; i < freedom.bodies(); ++i)
    if (freedom.moves(i)) {
      for (int k = 0; k < freedom.dimension(); ++k)
        if (freedom.translation(i, k) == DegreesOfFreedom::none) net[i][k] = 0;
      largest = std::max(largest, net[i].norm());
    }
  return sum > 0 ? largest / (sum / double(contacts.size())) : 0;
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

std::string warning_of(const Rest& rest) {
  const std::string what =
      fmt::format("the packing is not at rest: net forces are up to {:.2g} of the mean force of its contacts",
                  rest.unbalance);
  const char* const cure = "let it come to rest (until.kinetic_over_elastic)";
  if (!rest.equilibrium)
    return rest.unbalance > noticed
               ? fmt::format(
                     "{}, and no equilibrium nearby was found, so that the linear response is that of a packing that moves; {}",
                     what, cure)
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
  rest.warning = warning_of(rest);
  return rest;
}

}  // namespace scree::response
