#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <scree/simulation.hpp>
#include <scree/state.hpp>

namespace scree::response {

struct QuasiStaticOptions {
  double longest_increment = 0;  // (s) of the programs of the walls; must be given
  // Increments without an equilibrium at their end are halved, down to the shortest.
  double shortest_increment = 0;  // (s) 0: 1/64 of the longest
  // Largest net force on a body or wall relative to the largest force on a contact or wall; a net torque is
  // divided by the radius.
  double tolerance = 1e-11;
  std::function<bool()> proceed = [] { return true; };  // called between Newton steps; false ends the search
};

struct QuasiStaticCounts {
  std::size_t increments = 0, iterations = 0, events = 0;
};

// Pressing forces (N) on the walls of a simulation at a time (s), with the walls in their present places.
// Throws Error if a wall is moved by a program other than a stress or a force.
std::vector<double> loads_of_walls(const Simulation& simulation, double time);

// Names of the contact laws, among those with contacts now, whose springs move by spin × step with the values
// at the end of the step: their error is in proportion to the increment.
std::vector<std::string> laws_that_integrate_spins(const Simulation& simulation);

// Follows a packing through states of equilibrium, without inertia and without dashpots, as the programs of
// its walls load it. At the end of each increment all forces and torques of the contacts are in balance with
// the loads there. Contacts slide according to their laws at the end of the increment. If contacts slide, an
// increment ends at the first contact that begins to slide, touches or parts, located to 1e-4 of the
// increment, unless it has more than eight such events or sixteen have been located in it.
class QuasiStatic {
 public:
  // Begins from the present state of a simulation, which must outlive this object. Throws Error if a law has
  // no derivatives, if walls are moved by programs other than stresses or forces, or if the options are out
  // of range.
  QuasiStatic(const Simulation& simulation, const QuasiStaticOptions& options);
  ~QuasiStatic();

  // Advances to a later time (s) of the present stage. Returns false, at an earlier time, if there is no
  // equilibrium near the present one, so that the packing moves by inertia, or if `proceed` returned false.
  bool advance(double time);

  double time() const;
  QuasiStaticCounts counts() const;
  std::size_t degrees_of_freedom() const;
  std::size_t touching() const;
  std::size_t sliding() const;
  // The walls at rest in their present places, and the forces of contacts on them, 0 before the first
  // balance.
  std::vector<scree_plane> planes() const;
  std::vector<scree_load> loads() const;
  // The same of surfaces.
  std::vector<scree_frame> frames() const;
  std::vector<scree_frame_load> surface_loads() const;
  // 1 for walls that are not there.
  const std::vector<std::uint8_t>& absent_walls() const;
  // The state of the simulation with this packing at rest, at this time.
  State state() const;

 private:
  class Packing;
  std::unique_ptr<Packing> packing_;
};

}  // namespace scree::response
