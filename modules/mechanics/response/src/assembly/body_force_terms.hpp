#pragma once

#include "assembly/contact_terms.hpp"

#include <vector>

namespace scree::response {

// Negative derivatives of the body forces on a body with its own displacement and velocity. Rows and columns:
// translations, rotations.
struct BodyForceTerms {
  Block stiffness, damping;
  Eigen::VectorXd load;  // force (N) and torque (N m) at rest
};

// Central differences of the plug-ins about bodies at rest; exact to round-off where they are linear. One
// entry per body, none in a scene without body forces.
std::vector<BodyForceTerms> linearise_body_forces(const Simulation& simulation, int spins);

}  // namespace scree::response
