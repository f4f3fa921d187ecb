#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <scree/plugin_host.hpp>
#include <scree/response/linear_system.hpp>
#include <scree/simulation.hpp>
#include <scree/wall_equations.hpp>

namespace scree::response {

// At most 12 × 12: translations and rotations of two bodies.
using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 12, 12>;

// A linearised contact: negative derivatives of forces and torques by the displacements and velocities of its
// two bodies. Rows and columns: translations and rotations of a, then of b.
struct ContactTerms {
  std::uint32_t a, b;             // as in ContactList
  std::size_t contact;            // index into it
  bool tangential;                // the law exerts tangential forces or couples
  bool sliding;                   // in the last step
  bool one_way;                   // the stiffness differs in loading and unloading; `stiffness` is the mean
  bool integrates_spin;           // the law moves its spring by spin × step
  bool springs_twist;             // springs turn about the normal with both ends, since the law follows these
  Eigen::Vector3d place, normal;  // (m) of a, and unit
  Eigen::Vector3d force, torque;  // on a (N), (N m), with both at rest
  Eigen::Vector3d torque_b;       // (N m) on another body
  Eigen::Matrix3d normal_change;  // (1/m) derivative of the normal by u_a − u_b
  Block stiffness, damping;
};

// spins: number of rotations of a body, 0, 1 or 3. Throws Error as `assemble` does.
std::vector<ContactTerms> linearise_contacts(const Simulation& simulation, int spins, AtLimit at_limit,
                                             TimeStep time_step = TimeStep::limit);

// Throws Error if a wall moves in a way that no equation has. controls: of a spin that have one, for the
// cure.
void check_equations(const Simulation& simulation, const WallEquations& equations, const char* controls);

// The configured law. Throws Error if it has no derivatives.
ConfiguredLaw differentiable(const Scene::Law& law, int dimension);

}  // namespace scree::response
