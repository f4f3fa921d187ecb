#include "contacts/contact_sums.hpp"

#include "ranks/rank_sums.hpp"

#include <scree/state_transfer.hpp>

namespace scree {

void ContactSums::transfer(const StateTransfer& state) {
  state.value("elastic_normal", "J", elastic_normal, stored::any);
  state.value("elastic_tangential", "J", elastic_tangential, stored::any);
  state.value("dissipation_rate_normal", "W", dissipation_rate_normal, stored::any);
  state.value("dissipation_rate_tangential", "W", dissipation_rate_tangential, stored::any);
  state.value("dissipation_rate_rolling", "W", dissipation_rate_rolling, stored::any);
  state.value("dissipated_friction", "J", dissipated_friction, stored::any);
  state.value("dissipated_release", "J", dissipated_release, stored::any);
  state.value("created_power", "W", created_power, stored::any);
  state.value("created", "J", created, stored::any);
  state.value("max_overlap_ratio", "1", max_overlap_ratio, stored::non_negative);
}

void add_total(const std::vector<ContactSums>& tiles, ContactSums& total, RankSums& sums) {
  if (tiles.size() == 1 && !sums.over_ranks()) {
    total = tiles[0];
    return;
  }
  for (double ContactSums::*const member :
       {&ContactSums::elastic_normal, &ContactSums::elastic_tangential, &ContactSums::dissipation_rate_normal,
        &ContactSums::dissipation_rate_tangential, &ContactSums::dissipation_rate_rolling,
        &ContactSums::dissipated_friction, &ContactSums::dissipated_release, &ContactSums::created_power,
        &ContactSums::created})
    sums.sum(total.*member, tiles, [&](const ContactSums& tile) { return tile.*member; });
  total.max_overlap_ratio = 0;
  for (const ContactSums& tile : tiles)
    total.max_overlap_ratio = std::max(total.max_overlap_ratio, tile.max_overlap_ratio);
}

}  // namespace scree
