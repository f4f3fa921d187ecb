#include "bodies/body_sums.hpp"

#include <scree/state_transfer.hpp>

namespace scree {

void BodySums::transfer(const StateTransfer& state) {
  state.value("potential", "J", potential, stored::any);
  state.value("dissipation_rate_translation", "W", dissipation_rate_translation, stored::any);
  state.value("dissipation_rate_rotation", "W", dissipation_rate_rotation, stored::any);
}

}  // namespace scree
