#pragma once

#include "block.hpp"

namespace scree::kernel {

// Sum of a padded column in 8 interleaved parts: the same order for every vector width.
template <class T>
SCREE_HOT double sum_column(const T* column, std::uint32_t padded) {
  double part[SCREE_LANES] = {};
  for (std::uint32_t i = 0; i < padded; i += SCREE_LANES)
    for (std::uint32_t k = 0; k < SCREE_LANES; ++k) part[k] += double(column[i + k]);
  double sum = 0;
  for (const double p : part) sum += p;
  return sum;
}

// Largest overlap over the smaller radius of each pair. Divides only where it exceeds what was met already.
template <bool planes, class T>
SCREE_HOT double largest_overlap_ratio(const double* radius_sum, std::uint32_t padded, const Block<T>& w,
                                       double largest) {
  const auto smaller_radius = [&](std::uint32_t i) {
    const double difference = double(w.radius_difference[i]);
    return planes ? difference : 0.5 * (radius_sum[i] - std::abs(difference));
  };
  Count<double> deeper = 0;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i)
    deeper += double(w.input[SCREE_OVERLAP][i]) > largest * smaller_radius(i);
  if (deeper == 0) return largest;
  for (std::uint32_t i = 0; i < padded; ++i)
    if (w.input[SCREE_OVERLAP][i] > T(0))
      largest = std::max(largest, double(w.input[SCREE_OVERLAP][i]) / smaller_radius(i));
  return largest;
}

template <class T>
SCREE_HOT ContactSums sum_block(const Block<T>& w, std::uint32_t padded) {
  ContactSums sums;
  sums.elastic_normal = sum_column(w.output[SCREE_ELASTIC_NORMAL], padded);
  sums.elastic_tangential = sum_column(w.output[SCREE_ELASTIC_TANGENTIAL], padded);
  sums.dissipated_normal = sum_column(w.output[SCREE_DISSIPATED_NORMAL], padded);
  sums.dissipated_tangential = sum_column(w.output[SCREE_DISSIPATED_TANGENTIAL], padded);
  sums.dissipated_friction = sum_column(w.output[SCREE_DISSIPATED_FRICTION], padded);
  return sums;
}

}  // namespace scree::kernel
