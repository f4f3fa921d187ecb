#include "contacts/contact_sums.hpp"

#include <scree/state_transfer.hpp>

namespace scree {

void ContactSums::transfer(const StateTransfer& state) {
  state.value("elastic_normal", "J", elastic_normal);
  state.value("elastic_tangential", "J", elastic_tangential);
  state.value("dissipation_rate_normal", "W", dissipation_rate_normal);
  state.value("dissipation_rate_tangential", "W", dissipation_rate_tangential);
  state.value("dissipation_rate_rolling", "W", dissipation_rate_rolling);
  state.value("dissipated_friction", "J", dissipated_friction);
  state.value("dissipated_release", "J", dissipated_release);
  state.value("created_power", "W", created_power);
  state.value("created", "J", created);
  state.value("max_overlap_ratio", "1", max_overlap_ratio);
}

}  // namespace scree
