#pragma once

#include <cstdint>

namespace scree::response {

enum class PairStatus : std::uint8_t { open, sticks, slides };

// A pair after an evaluation. A change of its status is an event.
struct PairState {
  PairStatus status = PairStatus::open;
  double overlap = 0;    // (m) below 0 where the pair does not touch
  double mobilised = 0;  // tangential over normal force; 0 where the pair does not touch
};

}  // namespace scree::response
