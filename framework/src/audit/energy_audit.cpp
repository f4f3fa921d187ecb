#include "audit/energy_audit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <scree/energy.hpp>
#include <scree/plugin/energies.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// What balance() sets; the others are kept from step to step.
constexpr double scree_energy::*computed[] = {
    &scree_energy::kinetic_translation, &scree_energy::kinetic_rotation, &scree_energy::kinetic_boundary,
    &scree_energy::dissipated_boundary, &scree_energy::residual};

// The larger number; NaN if one of them is, which std::max passes over.
double larger(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

}  // namespace

void EnergyAudit::set_stored(const ContactSums& contacts, const BodySums& bodies) {
  const double before = totals_.elastic_normal + totals_.elastic_tangential + totals_.potential;
  store(contacts, bodies);
  if (started_)
    totals_.work += totals_.elastic_normal + totals_.elastic_tangential + totals_.potential - before;
}

void EnergyAudit::store(const ContactSums& contacts, const BodySums& bodies) {
  contacts_ = contacts;
  bodies_ = bodies;
  totals_.elastic_normal = contacts.elastic_normal;
  totals_.elastic_tangential = contacts.elastic_tangential;
  totals_.potential = bodies.potential;
  const double height = started_ ? std::abs(totals_.potential - potential_at_start_) : 0;
  max_stored_ = larger(max_stored_, totals_.elastic_normal + totals_.elastic_tangential + height);
}

void EnergyAudit::add_step(double step, const ContactSums& contacts, const BodySums& bodies) {
  const auto trapezoid = [step](double before, double after) { return 0.5 * step * (before + after); };
  totals_.dissipated_normal += trapezoid(contacts_.dissipation_rate_normal, contacts.dissipation_rate_normal);
  totals_.dissipated_tangential +=
      trapezoid(contacts_.dissipation_rate_tangential, contacts.dissipation_rate_tangential);
  totals_.dissipated_rolling +=
      trapezoid(contacts_.dissipation_rate_rolling, contacts.dissipation_rate_rolling);
  totals_.dissipated_friction += contacts.dissipated_friction;
  totals_.dissipated_release += contacts.dissipated_release;
  totals_.created += trapezoid(contacts_.created_power, contacts.created_power) + contacts.created;
  totals_.dissipated_translation +=
      trapezoid(bodies_.dissipation_rate_translation, bodies.dissipation_rate_translation);
  totals_.dissipated_rotation +=
      trapezoid(bodies_.dissipation_rate_rotation, bodies.dissipation_rate_rotation);
  totals_.work += bodies.work;
  store(contacts, bodies);
}

void EnergyAudit::add_lost(const ContactSums& contacts) {
  totals_.dissipated_friction += contacts.dissipated_friction;
  totals_.created += contacts.created;
  if (started_) totals_.work += contacts.dissipated_friction - contacts.created;
  add_released(contacts.dissipated_release);
}

void EnergyAudit::add_released(double energy) {
  totals_.dissipated_release += energy;
  if (started_) totals_.work += energy;
}

void EnergyAudit::add_turned_over(double kinetic_boundary) {
  max_stored_ = larger(max_stored_, kinetic_boundary);
}

void EnergyAudit::start(double kinetic_translation, double kinetic_rotation,
                        const scree_boundary_energy& boundaries) {
  kinetic_at_start_ = kinetic_translation + kinetic_rotation;
  potential_at_start_ = totals_.potential;
  stored_at_start_ = balance(kinetic_translation, kinetic_rotation, boundaries).residual;
  started_ = true;
}

scree_energy EnergyAudit::balance(double kinetic_translation, double kinetic_rotation,
                                  const scree_boundary_energy& boundaries) const {
  scree_energy e = totals_;
  e.kinetic_translation = kinetic_translation;
  e.kinetic_rotation = kinetic_rotation;
  e.kinetic_boundary = boundaries.kinetic;
  e.dissipated_boundary = boundaries.dissipated;
  e.work = totals_.work + boundaries.work;
  e.residual = kinetic_energy(e) + elastic_energy(e) + e.potential - stored_at_start_ + dissipated_energy(e) -
               e.created - e.work;
  return e;
}

double kinetic_energy(const scree_energy& e) {
  return e.kinetic_translation + e.kinetic_rotation + e.kinetic_boundary;
}

double elastic_energy(const scree_energy& e) { return e.elastic_normal + e.elastic_tangential; }

double dissipated_energy(const scree_energy& e) {
  return e.dissipated_normal + e.dissipated_tangential + e.dissipated_rolling + e.dissipated_friction +
         e.dissipated_release + e.dissipated_translation + e.dissipated_rotation + e.dissipated_boundary;
}

double EnergyAudit::turnover(const scree_energy& e) const {
  const double peak = larger(larger(kinetic_energy(e) + elastic_energy(e), kinetic_at_start_), max_stored_);
  return larger(std::abs(e.work), peak + dissipated_energy(e));
}

double EnergyAudit::share(double energy, const scree_energy& now) const {
  const double all = turnover(now);
  if (!std::isfinite(energy) || !std::isfinite(all)) return std::numeric_limits<double>::quiet_NaN();
  return all > 0 ? energy / all : 0;
}

void EnergyAudit::transfer(const StateTransfer& state) {
  for (const NamedEnergy& energy : energies)
    if (std::find(std::begin(computed), std::end(computed), energy.member) == std::end(computed))
      state.value(energy.name, "J", totals_.*energy.member, stored::any);
  contacts_.transfer(state.below("contacts"));
  bodies_.transfer(state.below("body_forces"));
  state.value("stored_at_start", "J", stored_at_start_, stored::any);
  state.value("kinetic_at_start", "J", kinetic_at_start_, stored::any);
  state.value("potential_at_start", "J", potential_at_start_, stored::any);
  state.value("max_stored", "J", max_stored_, stored::any);
  state.value("started", "", started_);
}

}  // namespace scree
