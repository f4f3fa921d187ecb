#pragma once

#include "contacts/contact_sums.hpp"

#include <scree/plugin/abi.h>

namespace scree {

// What body forces report in one evaluation.
struct BodySums {
  double potential = 0;               // (J)
  double dissipated_translation = 0;  // (W)
  double dissipated_rotation = 0;     // (W)

  BodySums& operator+=(const BodySums& other) {
    potential += other.potential;
    dissipated_translation += other.dissipated_translation;
    dissipated_rotation += other.dissipated_rotation;
    return *this;
  }
};

// Keeps the books of a run: where energy is, where it went, what was put in.
class EnergyAudit {
 public:
  // Adds one step: powers are integrated by the trapezoidal rule.
  void add_step(double step, const ContactSums& contacts, const BodySums& bodies);
  // Sets what is stored in contacts and potentials without passing time: at the start, or when a stage
  // changes parameters; a jump then counts as work.
  void restate(const ContactSums& contacts, const BodySums& bodies);

  // Fixes the start against which the residual is taken.
  void start(double kinetic_translation, double kinetic_rotation, const scree_boundary_energy& boundaries);
  // What a residual is measured against: the work put in, or all energy that went and the most that moved or
  // was stored in springs and by height, if that is more (J).
  double turnover(const scree_energy& now) const;
  // The books at this moment.
  scree_energy balance(double kinetic_translation, double kinetic_rotation,
                       const scree_boundary_energy& boundaries) const;

 private:
  void store(const ContactSums& contacts, const BodySums& bodies);

  scree_energy totals_ = {};
  ContactSums contacts_;
  BodySums bodies_;
  double stored_at_start_ = 0, kinetic_at_start_ = 0, potential_at_start_ = 0;
  double most_stored_ = 0;  // in springs and by height since the start (J)
  bool started_ = false;
};

}  // namespace scree
