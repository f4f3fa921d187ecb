#include "step/simulation_parts.hpp"

#include "contacts/kernel/placement.hpp"
#include "contacts/mesh_spots.hpp"
#include "step/health.hpp"
#include "surfaces/sliding_work.hpp"
#include "walls/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state_transfer.hpp>
#include <scree/step_guard.hpp>

namespace scree {

namespace {

constexpr std::uint32_t no_law = ~0u;
constexpr const char* path_of_contact_sums = "sums/contacts";

// Whether a group moves or loads a rotation.
bool turns(const BodyGroup& group) {
  for (const BodyGroup::Programs* programs : {&group.velocity, &group.displacement, &group.load})
    if (std::any_of(programs->begin() + freedom::first_rotation, programs->end(),
                    [](const std::vector<double>& program) { return !program.empty(); }))
      return true;
  return false;
}

bool needs_spin(const Scene& scene, const BodyFacts& bodies) {
  const bool turning = std::any_of(scene.laws.begin(), scene.laws.end(), [&](const Scene::Law& law) {
    return exerts_torque(law.parameters, scene.dimension);
  });
  const bool driven = std::any_of(scene.groups.begin(), scene.groups.end(), turns);
  return scene.spin || scene.orientations || bodies.any_spins || turning || driven;
}

bool needs_orientations(const Scene& scene) {
  return scene.orientations || std::any_of(scene.laws.begin(), scene.laws.end(), [&](const Scene::Law& law) {
           return depends_on_orientations(law.parameters, scene.dimension);
         });
}

double skin_of(const Scene& scene, const BodyFacts& bodies) {
  return scene.skin > 0 ? scene.skin : 0.1 * bodies.mean_radius;
}

// Upper limit of the skin (m); 0 if the scene gives a fixed skin. A periodic length must be at least twice
// the largest reach.
double max_skin_of(const Scene& scene, const BodyFacts& bodies, const Domain& domain) {
  if (scene.skin > 0) return 0;
  double max_skin = 0.5 * bodies.mean_radius;
  for (int k = 0; k < 3; ++k)
    if (domain.periodic[k]) max_skin = std::min(max_skin, 0.5 * domain.length(k) - 2 * bodies.largest_radius);
  return std::max(max_skin, skin_of(scene, bodies));
}

double speed_limit_of(const Scene& scene, const BodyFacts& bodies, const Boundaries& boundaries) {
  if (scene.limits.speed > 0) return scene.limits.speed;
  return bodies.smallest_radius / scene.step + (boundaries.wall_count() == 0 ? norm(bodies.drift) : 0);
}

unsigned threads_of(const Scene& scene, const BodyFacts& bodies) {
  const std::size_t useful = bodies.count / std::max<std::size_t>(1, scene.min_bodies_per_thread);
  return unsigned(std::clamp<std::size_t>(useful, 1, std::max(1u, scene.threads)));
}

// Loads on surfaces have torques, which only records of bodies with spin have room for.
Particles::Features features_of(const Scene& scene, const BodyFacts& bodies, const Boundaries& boundaries) {
  return {.spin = needs_spin(scene, bodies) || boundaries.surfaces().size() > 0,
          .images = boundaries.domain().any_periodic(),
          .orientations = needs_orientations(scene),
          .fixed = bodies.any_fixed,
          .held = bodies.any_held};
}

// Empty pair groups: for each law, pairs of bodies and, in a scene with walls, pairs with planes and
// surfaces.
Contacts make_contacts(const SimulationParts& parts) {
  std::vector<Contacts::Kind> kinds;
  for (std::uint32_t k = 0; k < parts.laws.size(); ++k) {
    const std::uint32_t width = parts.laws[k].interface.history_width;
    kinds.push_back({k, false, width});
    if (!parts.boundaries.planes().empty()) kinds.push_back({k, true, width});
    const WallSurfaces& surfaces = parts.boundaries.surfaces();
    if (surfaces.size() > 0) kinds.push_back({k, true, width, true, surfaces.any_mesh() ? spot_width : 0});
  }
  return Contacts(kinds, BodyTiles(parts.particles.size()));
}

}  // namespace

bool exerts_torque(const Parameters& law, int dimension) {
  return ConfiguredLaw(law, dimension, no_bounds, no_bounds).instance().tangential != 0;
}

bool depends_on_orientations(const Parameters& law, int dimension) {
  return kernel::reads_orientations(ConfiguredLaw(law, dimension, no_bounds, no_bounds).instance());
}

SimulationParts::SimulationParts(Scene given)
    : SimulationParts(std::move(given), facts_of(checked(given).bodies, given.dimension)) {
  particles = Particles(scene.dimension, features_of(scene, facts, boundaries), scene.bodies);
  driven = DrivenBodies(scene, particles);
}

SimulationParts::SimulationParts(Scene&& given, const BodyFacts& bodies)
    : scene(std::move(given)),
      facts(bodies),
      boundaries(scene.boundaries, scene.dimension, facts.bounds),
      body_forces(scene.body_forces, scene.dimension, scene.audit),
      particles(scene.dimension, features_of(scene, facts, boundaries), facts.count),
      driven(scene, particles),
      law_of(scene.law_of),
      neighbours(skin_of(scene, facts), max_skin_of(scene, facts, boundaries.domain()),
                 {.law_of = law_of.data(), .materials = std::uint32_t(scene.materials.size())}),
      forces({.dimension = scene.dimension,
              .spin = particles.has_spin(),
              .periodic = boundaries.domain().any_periodic(),
              .audit = scene.audit,
              .pair_forces = scene.pair_forces,
              .sliding_work = scene.sliding_work}),
      integrator(make_integrator(scene.integration)),
      threads(std::make_unique<ThreadPool>(threads_of(scene, facts))),
      speed_limit(speed_limit_of(scene, facts, boundaries)),
      lengths_at_start(enclosed_lengths(boundaries, scene.dimension)),
      stepper(*this) {
  configure_laws();
  if (scene.sliding_work) forces.keep_sliding_work(boundaries.surfaces());
  contacts = make_contacts(*this);
}

void SimulationParts::transfer(const StateTransfer& state) {
  transfer_all_but_pairs(state);
  transfer_pairs(state);
}

void SimulationParts::transfer_all_but_pairs(const StateTransfer& state) {
  transfer_common(state);
  const bool mid_step = stepper.forces_at() == Stepper::ForcesAt::middle_of_step;
  const StateTransfer of_bodies = state.below("bodies");
  in_scene_order().transfer(of_bodies, mid_step);
  integrator->transfer(state.below("integrator"), particles.order());
  transfer_order(of_bodies);
  const StateTransfer of_surfaces = state.below("surfaces");
  if (scene.sliding_work && of_surfaces.has("sliding_work")) forces.sliding_work()->transfer(of_surfaces);
}

void SimulationParts::transfer_common(const StateTransfer& state) {
  stepper.transfer(state.below("clock"));
  boundaries.transfer(state.below("walls"), stepper.forces_at() == Stepper::ForcesAt::middle_of_step);
  contact_sums.transfer(state.below(path_of_contact_sums));
  body_forces.transfer(state.below("body_forces"));
  body_sums.transfer(state.below("sums/body_forces"));
  audit.transfer(state.below("audit/energy"));
  momentum_audit.transfer(state.below("audit/momentum"));
  state.numbers("start/lengths", "m", lengths_at_start.component, 3, stored::any);  // NaN: not enclosed
}

void SimulationParts::find_and_evaluate_pairs() {
  command(RankCommand::find_and_evaluate_pairs);
  search_neighbours();
  stepper.reevaluate_forces(0);
  if (share) deal_by_pairs();
}

void SimulationParts::search_neighbours() {
  neighbours.rebuild(particles, boundaries, contacts, *threads);
  keep_neighbours_near();
}

void SimulationParts::transfer_pairs(const StateTransfer& state) {
  const StateTransfer of_contacts = state.below("contacts");
  const std::size_t planes = boundaries.wall_count();
  if (state.restoring()) {
    contacts.transfer(of_contacts, particles.order(), planes);
    neighbours.transfer(state.below("neighbours"), particles, boundaries);
    forces.restore(of_contacts, particles, contacts, laws, planes, *threads);
  } else {
    Pairs pairs = all_pairs();
    pairs.contacts.transfer(of_contacts, particles.order(), planes);
    neighbours.transfer(state.below("neighbours"), particles, boundaries);
    forces.save(of_contacts, particles.order(), pairs.contacts, pairs.forces);
  }
}

ContactSums SimulationParts::contact_sums_in(const State& state) {
  ContactSums sums;
  sums.transfer(StateTransfer::restoring_from(state).below(path_of_contact_sums));
  return sums;
}

void SimulationParts::check_returning_walls(const std::string& name, const Parameters& parameters,
                                            const std::vector<std::string>& going_on) {
  const bool mid_step = stepper.forces_at() == Stepper::ForcesAt::middle_of_step;
  State present;
  boundaries.transfer(StateTransfer::saving_to(present), mid_step);
  in_scene_order();  // brings the bodies of other ranks
  Boundaries changed(scene.boundaries, scene.dimension, facts.bounds);
  changed.transfer(StateTransfer::restoring_from(present), mid_step);
  changed.reconfigure(name, parameters, stepper.time(), going_on);
  check_appeared(particles, changed, boundaries.absent());
}

void SimulationParts::check_appeared_walls() {
  const std::vector<std::uint8_t>& absent = neighbours.absent_at_search();
  if (share && !share->is_first()) return;
  if (absent != boundaries.absent()) in_scene_order();  // which brings the bodies of other ranks
  check_appeared(particles, boundaries, absent);
}

void SimulationParts::come_to_rest(const RestingPacking& packing) {
  if (particles.order().rearranged()) rearrange(std::vector<std::uint32_t>(particles.order().back()));
  stepper.set_time(packing.time);
  particles.come_to_rest(packing.bodies, boundaries.domain());
  if (particles.orientations) particles.orientations = packing.orientations;
  boundaries.come_to_rest(packing);
  search_neighbours();
  forces.update_pairs(particles, contacts, reads_of(laws), boundaries.wall_count(), *threads);
  contacts.clear_histories();
  for (const ContactHistory& contact : packing.contacts) {
    const std::size_t bodies = particles.size();
    const bool plane = contact.b >= bodies;
    const auto [group, row] =
        contacts.find(plane, contact.a, plane ? std::uint32_t(contact.b - bodies) : contact.b,
                      particles.order(), contact.spot_number);
    if (!group)
      throw Error(
          fmt::format("bodies {} and {} do not touch where they are at rest; list only pairs that touch",
                      contact.a, contact.b));
    for (std::uint32_t k = 0; k < group->history_width; ++k)
      group->history.column(k)[row] = contact.numbers[k];
    if (contact.spot) keep_spot(*group, row, contact.spot->point, contact.spot->normal);
  }
}

void SimulationParts::configure_laws() {
  configured_laws.clear();
  laws.clear();
  for (std::size_t pair = 0; pair < law_of.size(); ++pair)
    law_of[pair] = scene.laws[scene.law_of[pair]].parameters.absent() ? no_law : scene.law_of[pair];
  for (const Scene::Law& law : scene.laws) {
    configured_laws.emplace_back(law.parameters, scene.dimension, no_bounds, no_bounds);
    const scree_contact_instance& instance = configured_laws.back().instance();
    if (instance.tangential && !particles.has_spin())
      throw Error(
          fmt::format("contact law '{}' now exerts torques, but the scene carries no spins; "
                      "set its spin from the start",
                      law.name));
    if (kernel::reads_orientations(instance) && !particles.orientations)
      throw Error(
          fmt::format("contact law '{}' now reads orientations, but the scene does not carry them; "
                      "set the parameters that need them from the start",
                      law.name));
    if (boundaries.surfaces().size() > 0 && kernel::reads_paths(instance) && !instance.follows_surfaces)
      throw Error(fmt::format(
          "contact law '{}' follows bodies along their paths, which it cannot on surface {}; choose a law with "
          "springs, such as {}, or a plane",
          law.name, boundaries.surfaces().names[0],
          scene.dimension == 2 ? "disc_corrected" : "sphere_path_independent"));
    laws.push_back({.interface = instance,
                    .storage = configured_laws.back().storage(),
                    .touching = OnsetWeights::of_power(instance.onset_power),
                    .parting = OnsetWeights::of_power(instance.parting_power)});
  }
}

}  // namespace scree
