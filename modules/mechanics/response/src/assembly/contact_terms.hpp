#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <scree/plugin_host.hpp>
#include <scree/response/linear_system.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

// At most 12 × 12: translations and rotations of two bodies.
using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 12, 12>;

// A contact, linearised: negative derivatives of forces and torques with the displacements and velocities of
// its two bodies. Rows and columns: translations and rotations of a, then those of b.
struct ContactTerms {
  std::uint32_t a, b;     // as in ContactList
  std::size_t contact;    // index into it
  bool tangential;        // the law exerts tangential forces or couples
  bool sliding;           // in the last step
  bool one_way;           // the stiffness differs in loading and unloading; that below is the mean
  bool integrates_spin;   // the law moves its spring by spin times step
  Eigen::Vector3d force;  // on a (N), with both at rest
  Block stiffness, damping;
};

// spins: rotations of a body that count, 0, 1 or 3. Throws Error as `assemble` does.
std::vector<ContactTerms> linearise_contacts(const Simulation& simulation, int spins, AtLimit at_limit,
                                             TimeStep time_step = TimeStep::limit);

// A law with its derivatives. Throws Error if it has none.
ConfiguredLaw differentiable(const Scene::Law& law, int dimension);

}  // namespace scree::response
