#pragma once

#include <functional>
#include <memory>
#include <string>

#include <scree/response/linear_system.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

// How far a packing is from rest, and the equilibrium nearby, about which small motions take place.
struct Rest {
  // Largest net force, or torque over a radius, on a held body or a wall that moves, relative to the mean
  // contact force.
  double unbalance = 0;
  // The packing in equilibrium, without motion; null if it is at rest but for round-off, or if there is no
  // equilibrium nearby.
  std::unique_ptr<Simulation> equilibrium;
  // |K − K'|/|K'|, K': stiffness in equilibrium; infinite if other bodies are held there.
  double stiffness_change = 0;
  std::string warning;  // "<what>; <cure>" if the linear response changes, or may change; else empty
};

// Searches for the equilibrium with the present springs, contacts and loads by Newton's method, as
// QuasiStatic does, for up to 12000 degrees of freedom. proceed: called between Newton steps; false ends the
// search. Throws Error as assemble() does.
Rest rest_of(
    const Simulation& simulation, const AssemblyOptions& options = {},
    const std::function<bool()>& proceed = [] { return true; });

}  // namespace scree::response
