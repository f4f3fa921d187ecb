#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include <scree/packing/random.hpp>

namespace scree::packing {

// The same radius for every body.
struct ConstantRadius {
  double radius = 0.0;  // (m)
};

// Uniform in [minimum, maximum].
struct UniformRadius {
  double minimum = 0.0;  // (m)
  double maximum = 0.0;  // (m)
};

// Normal, restricted to [minimum, maximum] by redrawing values outside; values are never clipped.
struct NormalRadius {
  double mean = 0.0;                // (m) of the unrestricted normal distribution
  double standard_deviation = 0.0;  // (m) of the unrestricted normal distribution
  double minimum = 0.0;             // (m)
  double maximum = 0.0;             // (m)
};

// Two sizes, chosen independently for each body.
struct BidisperseRadius {
  double small_radius = 0.0;    // (m)
  double large_radius = 0.0;    // (m) at least small_radius
  double large_fraction = 0.0;  // probability of the large radius, 0 to 1, by number
};

// Explicit radii: without weights the k-th body gets the k-th radius; with weights each body draws one.
struct ListedRadius {
  std::vector<double> radii;    // (m)
  std::vector<double> weights;  // by number, not negative, positive sum; empty or one per radius
};

using RadiusDistribution =
    std::variant<ConstantRadius, UniformRadius, NormalRadius, BidisperseRadius, ListedRadius>;

// Minimum fraction of normal deviates that must lie in [minimum, maximum].
inline constexpr double min_acceptance = 1e-3;

// Throws Error unless radii are positive and finite, ranges ordered, fractions and weights valid.
void check(const RadiusDistribution& distribution);

// Smallest and largest possible radius (m).
double smallest_radius(const RadiusDistribution& distribution);
double largest_radius(const RadiusDistribution& distribution);

// Draws `count` radii (m). Throws Error if check() does, or if a list without weights has another length.
std::vector<double> draw_radii(const RadiusDistribution& distribution, std::size_t count, Random& random);

}  // namespace scree::packing
