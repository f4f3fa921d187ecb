#pragma once

#include <algorithm>
#include <vector>

namespace scree {

class RankSums;

// Sums over all contacts in one evaluation. Dissipated columns sum the positive values only; the negative
// values add up to the energy that the laws create.
struct ContactSums {
  double elastic_normal = 0, elastic_tangential = 0;                                                  // (J)
  double dissipation_rate_normal = 0, dissipation_rate_tangential = 0, dissipation_rate_rolling = 0;  // (W)
  double dissipated_friction = 0, dissipated_release = 0;  // (J) in this step
  double created_power = 0;                                // (W)
  double created = 0;                                      // (J) in this step
  double max_overlap_ratio = 0;                            // overlap / smaller radius, largest so far

  ContactSums& operator+=(const ContactSums& other);
  void transfer(const class StateTransfer& state);
};

// The sum over tiles, exact before it is rounded: the same bits in any order.
void add_total(const std::vector<ContactSums>& tiles, ContactSums& total, RankSums& sums);

inline ContactSums& ContactSums::operator+=(const ContactSums& other) {
  elastic_normal += other.elastic_normal;
  elastic_tangential += other.elastic_tangential;
  dissipation_rate_normal += other.dissipation_rate_normal;
  dissipation_rate_tangential += other.dissipation_rate_tangential;
  dissipation_rate_rolling += other.dissipation_rate_rolling;
  dissipated_friction += other.dissipated_friction;
  dissipated_release += other.dissipated_release;
  created_power += other.created_power;
  created += other.created;
  max_overlap_ratio = std::max(max_overlap_ratio, other.max_overlap_ratio);
  return *this;
}

}  // namespace scree
