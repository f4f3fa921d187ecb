#pragma once

#include <functional>
#include <memory>
#include <string>

#include <scree/response/linear_system.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

// How far a packing is from rest, and the equilibrium nearby, about which small motions are meant to be.
struct Rest {
  double unbalance = 0;  // largest net force on a held body, over the mean force of contacts
  // In equilibrium and without motion; null where the packing is at rest but for round-off, or where there is no equilibrium nearby.
  std::unique_ptr<Simulation> equilibrium;
  // |K − K'|/|K'| with K' of the equilibrium; infinite if other bodies are held there.
  double stiffness_change = 0;
  std::string
      warning;  // "<what>; <cure>" where a linear response changes, or cannot be told to stay; else empty
};

// Looks for the equilibrium with springs, contacts and loads of the present time by Newton's method, as QuasiStatic does, of up to 12000 degrees of
// freedom. proceed: called between its steps; false: go no further. Throws Error as assemble does.
Rest rest_of(
    const Simulation& simulation, const AssemblyOptions& options = {},
    const std::function<bool()>& proceed = [] { return true; });

}  // namespace scree::response
