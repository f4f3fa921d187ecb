#pragma once

#include "contacts/kernel/block.hpp"

namespace scree::kernel {

// Sums of the positive and of the negative values of a padded column.
struct SignedSums {
  double above = 0, below = 0;
};

// Summed in 8 interleaved parts: the same order for every vector width.
SCREE_HOT SignedSums sum_column(const double* column, std::uint32_t padded) {
  double above[SCREE_LANES] = {}, below[SCREE_LANES] = {};
  for (std::uint32_t i = 0; i < padded; i += SCREE_LANES)
    for (std::uint32_t k = 0; k < SCREE_LANES; ++k) {
      above[k] += std::max(column[i + k], 0.0);
      below[k] += std::min(column[i + k], 0.0);
    }
  SignedSums sums;
  for (const double part : above) sums.above += part;
  for (const double part : below) sums.below += part;
  return sums;
}

// Largest ratio of overlap to the smaller radius of a pair. Divides only if a pair exceeds the largest ratio
// so far.
template <bool planes>
SCREE_HOT double largest_overlap_ratio(const double* radius_sum, std::uint32_t padded,
                                       const BlockColumns& block, double largest) {
  const auto smaller_radius = [&](std::uint32_t i) {
    const double difference = block.radius_difference[i];
    return planes ? difference : 0.5 * (radius_sum[i] - std::abs(difference));
  };
  Count deeper = 0;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < padded; ++i)
    deeper += block.input[SCREE_OVERLAP][i] > largest * smaller_radius(i);
  if (deeper == 0) return largest;
  for (std::uint32_t i = 0; i < padded; ++i)
    if (block.input[SCREE_OVERLAP][i] > 0)
      largest = std::max(largest, block.input[SCREE_OVERLAP][i] / smaller_radius(i));
  return largest;
}

// backwards: of a step backwards in time, in which what was dissipated or created in a step comes back.
SCREE_HOT ContactSums sum_block(const BlockColumns& block, std::uint32_t padded, bool backwards) {
  ContactSums sums;
  const auto stored = [&](scree_contact_output column) SCREE_INLINE_LAMBDA {
    const SignedSums all = sum_column(block.output[column], padded);
    return all.above + all.below;
  };
  const auto dissipated_power = [&](scree_contact_output column) SCREE_INLINE_LAMBDA {
    const SignedSums all = sum_column(block.output[column], padded);
    sums.created_power -= all.below;
    return all.above;
  };
  sums.elastic_normal = stored(SCREE_ELASTIC_NORMAL);
  sums.elastic_tangential = stored(SCREE_ELASTIC_TANGENTIAL);
  sums.dissipation_rate_normal = dissipated_power(SCREE_DISSIPATION_RATE_NORMAL);
  sums.dissipation_rate_tangential = dissipated_power(SCREE_DISSIPATION_RATE_TANGENTIAL);
  sums.dissipation_rate_rolling = dissipated_power(SCREE_DISSIPATION_RATE_ROLLING);
  const auto dissipated_in_step = [&](scree_contact_output column) SCREE_INLINE_LAMBDA {
    const SignedSums all = sum_column(block.output[column], padded);
    sums.created -= backwards ? all.above : all.below;
    return backwards ? all.below : all.above;
  };
  sums.dissipated_friction = dissipated_in_step(SCREE_DISSIPATED_FRICTION);
  sums.dissipated_release = dissipated_in_step(SCREE_DISSIPATED_RELEASE);
  return sums;
}

}  // namespace scree::kernel
