#include "assembly/body_force_terms.hpp"
#include "assembly/contact_terms.hpp"
#include "assembly/entries.hpp"
#include "assembly/group_terms.hpp"
#include "assembly/turn_terms.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/response/linear_system.hpp>

namespace scree::response {

namespace {

// Whether a contact is with a wall, or between held bodies.
bool counts(const ContactTerms& c, const std::vector<bool>& held) {
  return held[c.a] && (c.b >= held.size() || held[c.b]);
}

// Whether each body is fixed in place, or held by at least `fewest_contacts` (AssemblyOptions) contacts with
// walls or held bodies.
std::vector<bool> held_bodies(const std::vector<ContactTerms>& contacts, const Particles& p, int dimension,
                              int fewest_contacts) {
  const std::size_t bodies = p.size();
  std::vector<bool> held(bodies, true), tangential(bodies, false);
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<int> number(bodies, 0);
    tangential.assign(bodies, false);
    for (const ContactTerms& c : contacts) {
      if (!counts(c, held)) continue;
      for (const std::uint32_t end : {c.a, c.b}) {
        if (end >= bodies) continue;
        ++number[end];
        if (c.tangential) tangential[end] = true;
      }
    }
    for (std::size_t i = 0; i < bodies; ++i) {
      int free = 0;
      for (int k = 0; k < dimension; ++k) free += !p.is_held(i, k);
      const int needed = free == 0             ? 0
                         : fewest_contacts > 0 ? fewest_contacts
                         : tangential[i]       ? std::min(2, free + 1)
                                               : free + 1;
      if (!held[i] || number[i] >= needed) continue;
      held[i] = false;
      changed = true;
    }
  }
  return held;
}

WallEquations equations_of_walls(const Simulation& simulation, const AssemblyOptions& options) {
  WallEquations equations = simulation.linear_walls();
  if (options.hold_walls)
    for (scree_linear_wall& wall : equations.walls) wall.free = SCREE_PRESCRIBED, wall.turns = 0;
  check_equations(simulation, equations, "\"fixed\" or \"torque\"");
  return equations;
}

// Held bodies move unless they are fixed, and rotate if a contact between held bodies can turn them; walls
// move and turn if a held body touches them.
DegreesOfFreedom number_motions(const std::vector<ContactTerms>& contacts, const std::vector<bool>& held,
                                const Particles& p, const WallEquations& equations, int spins) {
  std::vector<bool> translates = held;
  for (std::size_t i = 0; i < held.size(); ++i) translates[i] = held[i] && !p.is_fixed(i);
  std::vector<bool> rotates(held.size(), false), moved(equations.walls.size(), false), turned = moved;
  for (const ContactTerms& c : contacts) {
    if (!counts(c, held)) continue;
    const std::size_t wall = c.b - held.size();
    if (c.b >= held.size()) {
      moved[wall] = equations.walls[wall].free == SCREE_FREE;
      turned[wall] = equations.walls[wall].turns;
    }
    if (!c.tangential) continue;
    rotates[c.a] = true;
    if (c.b < held.size()) rotates[c.b] = true;
  }
  return DegreesOfFreedom(p.dimension(), spins, translates, rotates, moved, held_components(p), turned);
}

Eigen::VectorXd masses(const DegreesOfFreedom& freedom, const Particles& p, const WallEquations& equations) {
  Eigen::VectorXd mass(freedom.size());
  for (std::size_t i = 0; i < freedom.bodies(); ++i) {
    if (const auto [first, count] = freedom.translations(i); count > 0)
      mass.segment(first, count).setConstant(p.mass[i]);
    if (const auto [first, count] = freedom.rotations(i); count > 0)
      mass.segment(first, count).setConstant(p.inertia[i]);
  }
  for (std::size_t w = 0; w < freedom.walls(); ++w) {
    if (freedom.wall(w) != DegreesOfFreedom::none) mass[freedom.wall(w)] = equations.walls[w].mass;
    if (freedom.turn(w) != DegreesOfFreedom::none) mass[freedom.turn(w)] = equations.walls[w].inertia;
  }
  return mass;
}

void check_integrated_spins(const std::vector<ContactTerms>& contacts) {
  if (std::any_of(contacts.begin(), contacts.end(), [](const ContactTerms& c) { return c.integrates_spin; }))
    throw Error(
        "a contact law integrates spins over time steps, whose motion with the time step of the run is not known; leave the linear "
        "response in the limit of short steps");
}

Eigen::VectorXd viscosities(const DegreesOfFreedom& freedom, const WallEquations& equations) {
  Eigen::VectorXd viscosity = Eigen::VectorXd::Zero(freedom.size());
  for (std::size_t w = 0; w < freedom.walls(); ++w) {
    const scree_linear_wall& wall = equations.walls[w];
    if (freedom.wall(w) != DegreesOfFreedom::none) viscosity[freedom.wall(w)] = wall.viscosity;
    if (freedom.turn(w) != DegreesOfFreedom::none) viscosity[freedom.turn(w)] = wall.spin_viscosity;
  }
  return viscosity;
}

// Adds pressing forces, viscosity and inertia of walls; the latter two act on q − w.
void add_walls(const WallEquations& equations, const DegreesOfFreedom& freedom, Entries& stiffness,
               Entries& damping, Entries& mass) {
  for (std::size_t w = 0; w < freedom.walls(); ++w) {
    if (freedom.turn(w) != DegreesOfFreedom::none) damping.add_own_turn(w, equations.walls[w].spin_viscosity);
    if (freedom.wall(w) == DegreesOfFreedom::none) continue;
    for (std::size_t other = 0; other < freedom.walls(); ++other)
      stiffness.add_along(w, other, equations.stiffness_of(w, other));
    damping.add_inertial(w, equations.walls[w].viscosity);
    mass.add_inertial(w, equations.walls[w].mass);
  }
}

// Adds what the turns of walls add to a contact.
void add_turn(const ContactTerms& contact, const WallEquations& equations, const DegreesOfFreedom& freedom,
              Entries& stiffness, Entries& damping) {
  const std::size_t wall = contact.b - freedom.bodies();
  if (contact.b < freedom.bodies() || freedom.turn(wall) == DegreesOfFreedom::none) return;
  TurnedContact turned = turned_contact(contact, equations.walls[wall], freedom.dimension(), freedom.spins());
  const int own = freedom.dimension() + freedom.spins();
  stiffness.add_turn(contact.a, wall, turn_terms(contact.stiffness.topLeftCorner(own, own), turned));
  turned.force.setZero(), turned.torque.setZero();
  damping.add_turn(contact.a, wall, turn_terms(contact.damping.topLeftCorner(own, own), turned));
}

}  // namespace

LinearSystem assemble(const Simulation& simulation, const AssemblyOptions& options) {
  check_groups(simulation);
  const Particles& p = simulation.particles();
  const int spins = p.spin_axes().last - p.spin_axes().first;
  const std::vector<ContactTerms> contacts =
      linearise_contacts(simulation, spins, options.at_limit, options.time_step);
  if (options.time_step == TimeStep::of_run) {
    check_integration(simulation.scene());
    check_integrated_spins(contacts);
  }
  const std::vector<bool> held = held_bodies(contacts, p, simulation.dimension(), options.fewest_contacts);
  const WallEquations equations = equations_of_walls(simulation, options);
  const DegreesOfFreedom freedom = number_motions(contacts, held, p, equations, spins);
  if (freedom.size() == 0)
    throw Error(fmt::format("no body is held at t = {:g} s, of {} with {}; compress the packing{}",
                            simulation.time(), p.size(), counted(contacts.size(), "contact"),
                            options.fewest_contacts > 1
                                ? fmt::format(", or give a fewest_contacts below {}", options.fewest_contacts)
                                : ", or count bodies with one contact as held (fewest_contacts = 1)"));

  Entries stiffness(freedom, equations), damping(freedom, equations), mass(freedom, equations);
  std::size_t sliding_contacts = 0, one_way_contacts = 0;
  for (const ContactTerms& contact : contacts) {
    if (!counts(contact, held)) continue;
    sliding_contacts += contact.sliding;
    one_way_contacts += contact.one_way;
    stiffness.add({contact.a, contact.b}, contact.stiffness);
    damping.add({contact.a, contact.b}, contact.damping);
    add_turn(contact, equations, freedom, stiffness, damping);
  }
  const std::vector<BodyForceTerms> forces = linearise_body_forces(simulation, spins);
  for (std::uint32_t i = 0; i < forces.size(); ++i) {
    stiffness.add({i}, forces[i].stiffness);
    damping.add({i}, forces[i].damping);
  }
  add_walls(equations, freedom, stiffness, damping, mass);

  std::vector<std::uint32_t> rattlers;
  for (std::uint32_t i = 0; i < p.size(); ++i)
    if (!held[i]) rattlers.push_back(i);
  return {.freedom = freedom,
          .stiffness = stiffness.of_motions(),
          .damping = damping.of_motions(),
          .mass = masses(freedom, p, equations),
          .wall_stiffness = stiffness.of_walls(),
          .wall_damping = damping.of_walls(),
          .wall_mass = mass.of_walls(),
          .rattlers = rattlers,
          .sliding_contacts = sliding_contacts,
          .one_way_contacts = one_way_contacts,
          .time_step = options.time_step == TimeStep::of_run ? simulation.step_length() : 0,
          .wall_viscosity = viscosities(freedom, equations)};
}

void check_integration(const Scene& scene) {
  if (scene.integration != Integration::velocity_verlet)
    throw Error(fmt::format(
        "the linear response with the time step of the run is that of velocity_verlet, not of {}; leave it in the limit of short steps",
        traits_of(scene.integration).name));
}

std::string one_way_warning(std::size_t contacts) {
  return fmt::format(
      "{} different stiffnesses in loading and unloading, so that small motions are "
      "not linear: their mean is taken; set history = \"potential\" (hertz_mindlin), or a law whose forces have a derivative",
      counted(contacts, "contact that bears a tangential load has",
              "contacts that bear a tangential load have"));
}

}  // namespace scree::response
