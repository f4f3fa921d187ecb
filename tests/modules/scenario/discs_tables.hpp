#pragma once

#include "plan_support.hpp"

#include <string>

// The scene `discs` with other tables, or other values.

namespace scree::test {

inline const std::string particles_of_discs =
    "[particles]\nlattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
    "random_velocity = 0.1\n";

// With these tables of bodies.
inline std::string scene_with_lots(const std::string& tables) {
  return with(discs, particles_of_discs, tables);
}

inline std::string refusal_of_override(const std::string& text) { return refusal(discs, {text}); }

}  // namespace scree::test
