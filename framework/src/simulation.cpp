#include "health.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scree/body_bounds.hpp>
#include <scree/error.hpp>
#include <scree/simulation.hpp>
#include <scree/state_hash.hpp>
#include <scree/step_guard.hpp>

namespace scree {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double nowhere[3] = {0, 0, 0};

bool needs_spin(const Scene& scene) {
  const bool spinning = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                    [](const Body& b) { return !(b.spin == Vec3{}); });
  const bool turning = std::any_of(scene.laws.begin(), scene.laws.end(), [&](const Scene::Law& law) {
    return turns_bodies(law.parameters, scene.dimension);
  });
  return scene.spin || spinning || turning;
}

double mean_radius(const Scene& scene) {
  double sum = 0;
  for (const Body& body : scene.bodies) sum += body.radius;
  return sum / std::max(1.0, double(scene.bodies.size()));
}

double skin_of(const Scene& scene) { return scene.skin > 0 ? scene.skin : 0.1 * mean_radius(scene); }

// 0 for a skin that the scene states. A periodic length must hold two of the largest reach.
double thickest_skin_of(const Scene& scene, const Domain& domain) {
  if (scene.skin > 0) return 0;
  double thickest = 0.5 * mean_radius(scene), largest = 0;
  for (const Body& body : scene.bodies) largest = std::max(largest, body.radius);
  for (int k = 0; k < 3; ++k)
    if (domain.periodic[k]) thickest = std::min(thickest, 0.5 * domain.length(k) - 2 * largest);
  return std::max(thickest, skin_of(scene));
}

double smallest_radius(const Scene& scene) {
  double smallest = infinite;
  for (const Body& body : scene.bodies) smallest = std::min(smallest, body.radius);
  return smallest;
}

unsigned threads_of(const Scene& scene) {
  const std::size_t useful = scene.bodies.size() / std::max<std::size_t>(1, scene.least_bodies_per_thread);
  return unsigned(std::clamp<std::size_t>(useful, 1, std::max(1u, scene.threads)));
}

Boundaries make_boundaries(const Scene& scene) {
  const BodyBounds box = bounds_of(scene.bodies, scene.dimension);
  return Boundaries(scene.boundaries, scene.dimension, box.lower, box.upper);
}

}  // namespace

bool turns_bodies(const Parameters& law, int dimension) {
  return ConfiguredLaw(law, dimension, nowhere, nowhere).instance().tangential != 0;
}

Simulation::Simulation(const Scene& scene)
    : scene_(checked(scene)),
      boundaries_(make_boundaries(scene)),
      body_terms_(scene.body_terms, scene.dimension, scene.audit),
      particles_(scene.dimension, needs_spin(scene), boundaries_.domain().any_periodic(), scene.bodies),
      neighbours_(skin_of(scene), thickest_skin_of(scene, boundaries_.domain()), {}),
      forces_({scene.dimension, particles_.has_spin(), boundaries_.domain().any_periodic(), scene.audit,
               scene.pair_forces, scene.precision}),
      integrator_(make_integrator(scene.integration)),
      threads_(std::make_unique<ThreadPool>(threads_of(scene))),
      smallest_radius_(smallest_radius(scene)),
      speed_limit_(scene.limits.speed > 0 ? scene.limits.speed
                                          : smallest_radius_ / scene.step + norm(drift_velocity(scene))),
      tiles_(particles_.size()),
      part_sums_(tiles_.parts()) {
  configure_laws();
  contacts_ = make_contacts();
  neighbours_.set_lookup(lookup());
  neighbours_.rebuild(particles_, boundaries_, contacts_, *threads_);
  evaluate_forces_afresh(0);
  boundaries_.kick(0, 0);
  audit_.restate(contact_sums_, body_sums_);
  const scree_energy now = energy();
  audit_.start(now.kinetic_translation, now.kinetic_rotation, boundaries_.energy());
  check_health(largest_square_speed());
}

void Simulation::configure_laws() {
  configured_laws_.clear();
  laws_.clear();
  for (const Scene::Law& law : scene_.laws) {
    configured_laws_.emplace_back(law.parameters, scene_.dimension, nowhere, nowhere);
    if (configured_laws_.back().instance().tangential && !particles_.has_spin())
      throw Error(
          fmt::format("contact law '{}' turns bodies now, but the scene carries no spins; set its spin "
                      "from the start",
                      law.name));
    if (scene_.precision == Precision::mixed && !configured_laws_.back().instance().evaluate_single)
      throw Error(fmt::format("contact law '{}' cannot compute in mixed precision; use double", law.name));
    const scree_contact_instance& instance = configured_laws_.back().instance();
    laws_.push_back({.interface = instance,
                     .storage = configured_laws_.back().storage(),
                     .touching = OnsetWeights::of_power(instance.onset_power),
                     .parting = OnsetWeights::of_power(instance.parting_power)});
  }
}

Contacts Simulation::make_contacts() const {
  std::vector<Contacts::Kind> kinds;
  for (std::uint32_t k = 0; k < laws_.size(); ++k)
    for (const bool planes : {false, true})
      if (!planes || !boundaries_.planes().empty())
        kinds.push_back({k, planes, laws_[k].interface.history_width});
  return Contacts(kinds, scene_.precision);
}

Contacts::Lookup Simulation::lookup() const {
  return {scene_.law_of.data(), std::uint32_t(scene_.materials.size()), nullptr, nullptr};
}

void Simulation::reconfigure_law(const std::string& name, const Parameters& parameters) {
  catch_up();
  for (Scene::Law& law : scene_.laws)
    if (law.name == name) {
      law.parameters = parameters;
      return;
    }
  throw Error(fmt::format("no contact law '{}'", name));
}

void Simulation::reconfigure_boundary(const std::string& name, const Parameters& parameters) {
  catch_up();
  boundaries_.reconfigure(name, parameters, time_);
}

void Simulation::reconfigure_body_term(const std::string& name, const Parameters& parameters) {
  catch_up();
  body_terms_.reconfigure(name, parameters);
}

void Simulation::apply_reconfiguration() {
  configure_laws();
  for (PairGroup& group : contacts_.groups()) group.history_width = laws_[group.law].interface.history_width;
  neighbours_.rebuild(particles_, boundaries_, contacts_, *threads_);
  evaluate_forces_afresh(0);
  audit_.restate(contact_sums_, body_sums_);
}

ContactList Simulation::contact_list() const {
  return touching_contacts(particles_, contacts_, forces_, laws_, boundaries_.planes(), boundaries_.domain());
}

scree_energy Simulation::energy() const {
  const Particles& p = particles_;
  // At the moment for which the stored energies are known.
  const auto velocity = force_time_ == time_ ? p.velocity() : p.mid_velocity();
  const auto spin = force_time_ == time_ ? p.spin() : p.mid_spin();
  double translation = 0, rotation = 0;
  for (int k = 0; k < scene_.dimension; ++k)
    for (std::size_t i = 0; i < p.size(); ++i) translation += p.mass[i] * velocity[k][i] * velocity[k][i];
  for (int k = p.spin_axes().first; k < p.spin_axes().last; ++k)
    for (std::size_t i = 0; i < p.size(); ++i) rotation += p.inertia[i] * spin[k][i] * spin[k][i];
  return audit_.balance(0.5 * translation, 0.5 * rotation, boundaries_.energy());
}

double Simulation::energy_residual() const {
  if (!scene_.audit) return 0;
  const scree_energy e = energy();
  const double turnover = audit_.turnover(e);
  return turnover > 0 ? std::abs(e.residual) / turnover : 0;
}

double Simulation::energy_created() const {
  const scree_energy e = energy();
  const double turnover = audit_.turnover(e);
  return turnover > 0 ? e.created / turnover : 0;
}

double Simulation::min_steps_per_contact() const {
  const double met = 2 * std::max(0.0, std::sqrt(max_square_speed_) - norm(drift_velocity(scene_)));
  return shortest_contact_time(scene_, std::max(expected_speed(scene_), met)) / scene_.step;
}

std::uint64_t Simulation::state_hash() const {
  StateHash hash;
  hash.add(steps_);
  const Particles& p = particles_;
  for (const auto& vectors : {p.position(), p.velocity(), p.spin()})
    for (int k = 0; k < 3; ++k)
      for (const double component : vectors[k]) hash.add(component);
  for (const PairGroup& group : contacts_.groups())
    for (std::size_t q = group.begin; q < group.end; ++q)
      for (std::uint32_t k = 0; k < group.history_width; ++k)
        if (const double value = group.history_of(q, k); value != 0) {
          hash.add((std::uint64_t(contacts_.a[q]) << 32) | contacts_.b[q]);
          hash.add(std::uint64_t(k));
          hash.add(value);
        }
  boundaries_.add_to_hash(hash);
  return hash.value();
}

Footprint Simulation::footprint() const {
  const Particles& p = particles_;
  std::uint32_t width = 0;
  for (const LawInstance& law : laws_) width = std::max(width, law.interface.history_width);
  const std::size_t history_bytes = PairColumns(scene_.precision).bytes_per_number();
  const std::size_t spins = std::size_t(p.spin_axes().last - p.spin_axes().first);
  return {p.size() * (std::size_t(scene_.dimension) + spins), p.bytes_per_body(),
          forces_.bytes_per_pair() + width * history_bytes, width};
}

}  // namespace scree
