#pragma once

namespace scree {

// Sums over all contacts in one evaluation. Dissipated columns sum the positive values only; the negative
// values add up to the energy that the laws create.
struct ContactSums {
  double elastic_normal = 0, elastic_tangential = 0;                                // (J)
  double dissipated_normal = 0, dissipated_tangential = 0, dissipated_rolling = 0;  // (W)
  double dissipated_friction = 0, dissipated_release = 0;                           // (J) in this step
  double created_power = 0;                                                         // (W)
  double created = 0;                                                               // (J) in this step
  double max_overlap_ratio = 0;  // overlap / smaller radius, largest so far

  ContactSums& operator+=(const ContactSums& other);
};

}  // namespace scree
