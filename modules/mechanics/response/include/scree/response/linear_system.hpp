#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include <scree/response/degrees_of_freedom.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

// Small motions q of a packing about its present state, with its walls displaced by w:
//   M q″ + C q′ + K q = f − M_w w″ − C_w w′ − K_w w
// q: translations (m) and rotations (rad) of the bodies that are held by contacts, along axes that are not
// fixed, displacements (m) of the walls that forces move and angles (rad) of the walls that torques turn and
// held bodies touch. For a wall that forces move, w is the superposed displacement: inertia and viscosity act
// on q − w. Rows are forces (N) and torques (N m).
struct LinearSystem {
  DegreesOfFreedom freedom;
  Eigen::SparseMatrix<double> stiffness, damping;  // K, C: (q, q)
  Eigen::VectorXd mass;  // M: (q) masses (kg), 0 or more for walls; moments of inertia (kg m²)
  // K_w, C_w, M_w: (q, walls × dimension)
  Eigen::SparseMatrix<double> wall_stiffness, wall_damping, wall_mass;
  std::vector<std::uint32_t> rattlers;  // bodies that are left out, in ascending order
  std::size_t sliding_contacts = 0;     // of held bodies, according to the laws in the last step
  // Contacts of held bodies whose stiffness differs in loading and unloading: K has the mean, and small
  // motions are not linear.
  std::size_t one_way_contacts = 0;
  double time_step = 0;                 // (s) of the run, or 0: continuous time
  Eigen::VectorXd wall_viscosity = {};  // (q) (kg/s) the part of C due to walls alone
};

// Behaviour of contacts whose tangential force is at the limit of friction.
enum class AtLimit {
  slide,  // they slide on, one way: the tangential force follows the normal force, and K is not symmetric
  stick   // they stick, as in small oscillations, in which slip stops within a few periods
};

// The time step in which laws see motions: velocities are predictions, and dashpots make up for their errors.
enum class TimeStep {
  limit,  // h → 0: motions in continuous time
  of_run  // the step of the run: harmonic motions as velocity Verlet makes them
};

struct AssemblyOptions {
  // Smallest number of contacts with held bodies or walls that holds a body. 0: D + 1 if none of its contacts
  // can exert a tangential force, else 2.
  int fewest_contacts = 0;
  // Walls that forces move are held, and displaced by w alone.
  bool hold_walls = false;
  AtLimit at_limit = AtLimit::slide;
  TimeStep time_step = TimeStep::limit;
};

// Linearises all contacts, body forces and walls at the present positions, orientations and springs, with
// bodies and walls at rest. Contacts within the limit of friction stick. Throws Error if a law has no
// derivatives, if no body is held, or, with the time step of the run, if it is not a step of velocity Verlet
// or a law integrates spins.
LinearSystem assemble(const Simulation& simulation, const AssemblyOptions& options = {});

// Which laws must have derivatives: at least one, or all.
enum class LawsNeeded { any, all };
// Throws Error if laws that are needed have no derivatives. Can be called before there are contacts.
void check_laws(const Scene& scene, LawsNeeded needed);
// Throws Error if the scene has no linear response with TimeStep::of_run.
void check_integration(const Scene& scene);

// "<what>; <cure>" for a number of LinearSystem::one_way_contacts.
std::string one_way_warning(std::size_t contacts);

}  // namespace scree::response
