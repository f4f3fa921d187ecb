#pragma once

namespace scree {

// What one evaluation of all contacts adds up to. Dissipated columns are of the contacts in which they are
// above 0; those below 0 add up to what the laws create.
struct ContactSums {
  double elastic_normal = 0, elastic_tangential = 0;                                // (J)
  double dissipated_normal = 0, dissipated_tangential = 0, dissipated_rolling = 0;  // (W)
  double dissipated_friction = 0, dissipated_release = 0;                           // (J) in this step
  double created_power = 0;                                                         // (W)
  double created = 0;                                                               // (J) in this step
  double max_overlap_ratio = 0;  // overlap / smaller radius, met so far

  ContactSums& operator+=(const ContactSums& other);
};

}  // namespace scree
