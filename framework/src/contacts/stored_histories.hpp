#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include <scree/state.hpp>

namespace scree {

// What the law of a contact has kept, in a state.
struct StoredHistory {
  const std::string& plugin;  // of the law
  bool plane;                 // b is a plane
  std::uint32_t a, b;
  std::uint32_t spot;  // of a body and a wall
  std::span<const double> numbers;
};

// Calls visit() for each contact in a state that has a history. Throws Error if the arrays do not fit.
void each_history(const State& state, const std::function<void(const StoredHistory&)>& visit);

}  // namespace scree
