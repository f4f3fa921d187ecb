#pragma once

#include "bodies/body_sums.hpp"
#include "contacts/contact_sums.hpp"

#include <scree/plugin/abi.h>

namespace scree {

// Energy balance of a run: stored, dissipated, created energy and work.
class EnergyAudit {
 public:
  // Adds one step: powers are integrated by the trapezoidal rule.
  void add_step(double step, const ContactSums& contacts, const BodySums& bodies);
  // Adds work (J) that was done on bodies which are held, or by a load on them.
  void add_work(double work) { totals_.work += work; }
  // Sets the energy stored in contacts and potentials without advancing time: at the start, or when a stage
  // changes parameters; a jump then counts as work.
  void set_stored(const ContactSums& contacts, const BodySums& bodies);
  // After a change of parameters springs may lose energy although nothing moves. Counts this loss as
  // dissipated and adds as much work, so that the residual stays the same. Called after set_stored(), or
  // before start().
  void add_lost(const ContactSums& contacts);
  // The same for the energy (J) of springs that are left out.
  void add_released(double energy);
  // Counts the kinetic energy of walls (J) as turned over. Called before a stage changes them: a wall that is
  // stopped gives all of it back, and the sum of the work is then 0.
  void add_turned_over(double kinetic_boundary);

  // Sets the initial state, the reference of the residual; kinetic energies in J.
  void start(double kinetic_translation, double kinetic_rotation, const scree_boundary_energy& boundaries);
  // Scale of the residual (J): the larger of |work| and the dissipated energy plus the largest energy that
  // was kinetic, or stored in springs and potentials. NaN if one of them has been NaN.
  double turnover(const scree_energy& now) const;
  // An energy (J) over the turnover. 0 without a turnover, NaN if one of the two is not finite.
  double share(double energy, const scree_energy& now) const;
  // The balance at the present time.
  scree_energy balance(double kinetic_translation, double kinetic_rotation,
                       const scree_boundary_energy& boundaries) const;

  void transfer(const class StateTransfer& state);

 private:
  void store(const ContactSums& contacts, const BodySums& bodies);

  scree_energy totals_ = {};
  ContactSums contacts_;
  BodySums bodies_;
  double stored_at_start_ = 0, kinetic_at_start_ = 0, potential_at_start_ = 0;
  double max_stored_ = 0;  // largest energy in springs and potentials, or of walls before a change (J)
  bool started_ = false;
};

}  // namespace scree
