#pragma once

#include "assembly/contact_terms.hpp"

#include <vector>

namespace scree::response {

// Negative derivatives of the body forces on a body by its own displacement and velocity. Rows and columns:
// translations, rotations.
struct BodyForceTerms {
  Block stiffness, damping;
  Eigen::VectorXd load;  // force (N) and torque (N m) at rest
};

// The constant loads of groups are among the loads. Differentiates the plug-ins by central differences about
// bodies at rest, to round-off where they are linear. One element per body; none in a scene without body
// forces and such loads.
std::vector<BodyForceTerms> linearise_body_forces(const Simulation& simulation, int spins);

}  // namespace scree::response
