#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/packing/radius_distribution.hpp>

namespace scree::packing {

namespace {

void require_radius(double radius, std::string_view what) {
  if (std::isfinite(radius) && radius > 0.0) return;
  throw Error("radius distribution", fmt::format("{} {} m is not positive and finite", what, radius),
              "give a number above 0");
}

void require_range(double minimum, double maximum) {
  require_radius(minimum, "minimum");
  require_radius(maximum, "maximum");
  if (minimum <= maximum) return;
  throw Error("radius distribution", fmt::format("minimum {} m exceeds maximum {} m", minimum, maximum),
              "swap them");
}

// Fraction of a normal distribution in [minimum, maximum]. If both bounds lie below the mean they are
// mirrored, as erfc is accurate in the upper tail.
double acceptance(const NormalRadius& d) {
  const double scale = 1.0 / (d.standard_deviation * std::numbers::sqrt2);
  double low = (d.minimum - d.mean) * scale;
  double high = (d.maximum - d.mean) * scale;
  if (high < 0.0) {
    std::swap(low, high);
    low = -low;
    high = -high;
  }
  return 0.5 * (std::erfc(low) - std::erfc(high));
}

void check_distribution(const ConstantRadius& d) { require_radius(d.radius, "radius"); }

void check_distribution(const UniformRadius& d) { require_range(d.minimum, d.maximum); }

void check_distribution(const NormalRadius& d) {
  require_range(d.minimum, d.maximum);
  if (!std::isfinite(d.mean)) throw Error("radius distribution", "the mean is not finite", "give a number");
  if (!(std::isfinite(d.standard_deviation) && d.standard_deviation > 0.0))
    throw Error("radius distribution",
                fmt::format("standard deviation {} m is not positive and finite", d.standard_deviation),
                "give a number above 0, or a constant radius");
  const double fraction = acceptance(d);
  if (fraction < min_acceptance)
    throw Error(
        "radius distribution",
        fmt::format(
            "only a fraction of {:.2g} of the normal distribution lies between minimum {} m and maximum {} m",
            fraction, d.minimum, d.maximum),
        "widen the range or move the mean into it");
}

void check_distribution(const BidisperseRadius& d) {
  require_radius(d.small_radius, "small radius");
  require_radius(d.large_radius, "large radius");
  if (d.small_radius > d.large_radius)
    throw Error("radius distribution",
                fmt::format("small radius {} m exceeds large radius {} m", d.small_radius, d.large_radius),
                "swap them");
  if (!(d.large_fraction >= 0.0 && d.large_fraction <= 1.0))
    throw Error("radius distribution",
                fmt::format("fraction {} of large bodies is not between 0 and 1", d.large_fraction),
                "give 0 to 1");
}

void check_distribution(const ListedRadius& d) {
  if (d.radii.empty()) throw Error("radius distribution", "the list is empty", "give at least one radius");
  for (const double radius : d.radii) require_radius(radius, "listed radius");
  if (d.weights.empty()) return;
  if (d.weights.size() != d.radii.size())
    throw Error("radius distribution",
                fmt::format("{} for {}", counted(d.weights.size(), "weight"),
                            counted(d.radii.size(), "radius", "radii")),
                "give one weight for each radius");
  for (const double weight : d.weights)
    if (!(std::isfinite(weight) && weight >= 0.0))
      throw Error("radius distribution", fmt::format("weight {} is negative or not finite", weight),
                  "give 0 or more");
  const double sum = std::accumulate(d.weights.begin(), d.weights.end(), 0.0);
  if (!(std::isfinite(sum) && sum > 0.0))
    throw Error("radius distribution", fmt::format("the weights add up to {}", sum),
                "give weights with a positive finite sum");
}

double draw_one(const ConstantRadius& d, std::size_t, Random&) { return d.radius; }

double draw_one(const UniformRadius& d, std::size_t, Random& random) {
  return random.uniform(d.minimum, d.maximum);
}

double draw_one(const NormalRadius& d, std::size_t, Random& random) {
  while (true) {
    const double radius = d.mean + d.standard_deviation * random.normal();
    if (radius >= d.minimum && radius <= d.maximum) return radius;
  }
}

double draw_one(const BidisperseRadius& d, std::size_t, Random& random) {
  return random.uniform() < d.large_fraction ? d.large_radius : d.small_radius;
}

double draw_one(const ListedRadius& d, std::size_t index, Random& random) {
  if (d.weights.empty()) return d.radii[index];
  double left = random.uniform() * std::accumulate(d.weights.begin(), d.weights.end(), 0.0);
  std::size_t chosen = 0;
  for (std::size_t k = 0; k < d.radii.size(); ++k) {
    if (d.weights[k] == 0.0) continue;
    chosen = k;  // the last radius with weight also absorbs the rounding error
    if (left < d.weights[k]) break;
    left -= d.weights[k];
  }
  return d.radii[chosen];
}

struct Extremes {
  double smallest;
  double largest;
};

Extremes extremes_of(const ConstantRadius& d) { return {d.radius, d.radius}; }
Extremes extremes_of(const UniformRadius& d) { return {d.minimum, d.maximum}; }
Extremes extremes_of(const NormalRadius& d) { return {d.minimum, d.maximum}; }
Extremes extremes_of(const BidisperseRadius& d) {
  return {d.large_fraction == 1.0 ? d.large_radius : d.small_radius,
          d.large_fraction == 0.0 ? d.small_radius : d.large_radius};
}
Extremes extremes_of(const ListedRadius& d) {
  const auto [smallest, largest] = std::minmax_element(d.radii.begin(), d.radii.end());
  return {*smallest, *largest};
}

}  // namespace

void check(const RadiusDistribution& distribution) {
  std::visit([](const auto& d) { check_distribution(d); }, distribution);
}

double smallest_radius(const RadiusDistribution& distribution) {
  check(distribution);
  return std::visit([](const auto& d) { return extremes_of(d).smallest; }, distribution);
}

double largest_radius(const RadiusDistribution& distribution) {
  check(distribution);
  return std::visit([](const auto& d) { return extremes_of(d).largest; }, distribution);
}

std::vector<double> draw_radii(const RadiusDistribution& distribution, std::size_t count, Random& random) {
  check(distribution);
  const auto* list = std::get_if<ListedRadius>(&distribution);
  if (list && list->weights.empty() && list->radii.size() != count)
    throw Error("radius distribution",
                fmt::format("the list has {} for {}", counted(list->radii.size(), "radius", "radii"),
                            counted(count, "body", "bodies")),
                "give one for each, or weights to draw them at random");
  std::vector<double> radii(count);
  std::visit(
      [&](const auto& d) {
        for (std::size_t k = 0; k < count; ++k) radii[k] = draw_one(d, k, random);
      },
      distribution);
  return radii;
}

}  // namespace scree::packing
