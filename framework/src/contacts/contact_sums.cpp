#include "contacts/contact_sums.hpp"

#include <algorithm>

namespace scree {

ContactSums& ContactSums::operator+=(const ContactSums& other) {
  elastic_normal += other.elastic_normal;
  elastic_tangential += other.elastic_tangential;
  dissipated_normal += other.dissipated_normal;
  dissipated_tangential += other.dissipated_tangential;
  dissipated_rolling += other.dissipated_rolling;
  dissipated_friction += other.dissipated_friction;
  dissipated_release += other.dissipated_release;
  created_power += other.created_power;
  created += other.created;
  max_overlap_ratio = std::max(max_overlap_ratio, other.max_overlap_ratio);
  return *this;
}

}  // namespace scree
