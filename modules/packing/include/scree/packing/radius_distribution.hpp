#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include <scree/packing/random.hpp>

namespace scree::packing {

// Every body the same.
struct ConstantRadius {
  double radius = 0.0;  // (m)
};

// Uniform in [minimum, maximum].
struct UniformRadius {
  double minimum = 0.0;  // (m)
  double maximum = 0.0;  // (m)
};

// Normal, restricted to [minimum, maximum] by drawing again; never clipped to a bound.
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
  double large_fraction = 0.0;  // probability of the large one, 0 to 1, by number
};

// Explicit sizes: without weights the k-th body gets the k-th radius; with weights each body draws one.
struct ListedRadius {
  std::vector<double> radii;    // (m)
  std::vector<double> weights;  // by number, not negative, sum positive; empty or one for each radius
};

using RadiusDistribution =
    std::variant<ConstantRadius, UniformRadius, NormalRadius, BidisperseRadius, ListedRadius>;

// Least share of normal deviates that must fall in [minimum, maximum].
inline constexpr double least_acceptance = 1e-3;

// Throws Error unless radii are positive and finite, ranges ordered, fractions and weights sensible.
void check(const RadiusDistribution& distribution);

// Smallest and largest radius that can occur. (m)
double smallest_radius(const RadiusDistribution& distribution);
double largest_radius(const RadiusDistribution& distribution);

// Radii of that many bodies. (m) Checks first; a list without weights must have exactly that length.
std::vector<double> draw_radii(const RadiusDistribution& distribution, std::size_t count, Random& random);

}  // namespace scree::packing
