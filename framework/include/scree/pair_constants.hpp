#pragma once

#include <vector>

#include <scree/contacts.hpp>
#include <scree/particles.hpp>

namespace scree {

// What does not change for a pair from one neighbour search to the next, and what contacts leave for it.
struct PairConstants {
  enum Column { reduced_mass, effective_radius, column_count };

  explicit PairConstants(Precision precision) : terms(precision), force(precision) {}

  // For all pairs, padding included.
  void update(const Contacts& contacts, const Particles& particles);

  scree::Column<double> radius_sum;  // R_a + R_b, of a plane R_a; −1 for padding, which never touches (m)
  PairColumns terms;                 // m* (kg), R* (m)
  PairColumns force;                 // (3 or 2) on a at the last evaluation (N)
};

}  // namespace scree
