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
  // Increments at whose end there is no equilibrium are halved, down to the shortest.
  double shortest_increment = 0;  // (s) 0: 1/64 of the longest
  // Largest residual of a force over the largest force on a contact or a wall, and of a torque over that times the radius.
  double tolerance = 1e-11;
  std::function<bool()> proceed = [] { return true; };  // called between Newton steps; false: go no further
};

struct QuasiStaticCounts {
  std::size_t increments = 0, iterations = 0, events = 0;
};

// Pressing forces (N) on the walls of a simulation at a time (s), with the walls where they are. Throws Error if a wall is moved by a
// program other than of a stress or force.
std::vector<double> loads_of_walls(const Simulation& simulation, double time);

// Names of contact laws whose springs are moved by spin times step, with their values at the end of the step: their error is in proportion
// to the increment. Of laws with contacts in the present state.
std::vector<std::string> laws_that_integrate_spins(const Simulation& simulation);

// Follows a packing through states of equilibrium, without inertia and without dashpots, as the programs of its walls load it:
// in each increment, positions, rotations and the springs at its end are those for which all forces and torques are in
// balance with the loads at its end. Contacts slide as their laws say at the end of the increment. Where contacts slide, an increment ends
// at the first contact that begins to slide, touches or parts, within 1e-4 of it, unless more than eight do or sixteen have done so in it.
class QuasiStatic {
 public:
  // Begins from the present state of a simulation, which must outlive this object. Throws Error if a law has no derivatives, if walls are moved
  // by programs other than of stresses, or if the options cannot be.
  QuasiStatic(const Simulation& simulation, const QuasiStaticOptions& options);
  ~QuasiStatic();

  // Goes on to a time (s) of the present stage, not before the present one. Returns false, at a time before it, where there
  // is no equilibrium next to the present one, where the packing moves on by inertia alone, or where `proceed` returned false.
  bool advance(double time);

  double time() const;
  QuasiStaticCounts counts() const;
  std::size_t degrees_of_freedom() const;
  std::size_t touching() const;
  std::size_t sliding() const;
  // Walls where they are, at rest, and forces of the contacts on them, 0 before the first balance.
  std::vector<scree_plane> planes() const;
  std::vector<scree_load> loads() const;
  // The state of the simulation with this packing in it, at rest, at this time.
  State state() const;

 private:
  class Packing;
  std::unique_ptr<Packing> packing_;
};

}  // namespace scree::response
