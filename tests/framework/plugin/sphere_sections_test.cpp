#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/plugin/sphere_sections.hpp>

using namespace scree;

namespace {

constexpr double without_end = std::numeric_limits<double>::infinity();
constexpr double unit_sphere = 4.0 / 3 * std::numbers::pi;

RoundRegion cylinder_beside(double radius, double away) { return {3, true, radius, away, 0}; }

// ∫ f between two ends where f may have any power of the distance: x = middle + half tanh(½π sinh t).
template <class Function>
double double_exponential(const Function& f, double from, double to) {
  constexpr double step = 1.0 / 32;
  double sum = 0;
  for (int k = -110; k <= 110; ++k) {
    const double t = k * step, u = 0.5 * std::numbers::pi * std::sinh(t);
    const double x = 0.5 * (from + to) + 0.5 * (to - from) * std::tanh(u);
    if (x > from && x < to) sum += f(x) * std::cosh(t) / (std::cosh(u) * std::cosh(u));
  }
  return sum * step * 0.25 * std::numbers::pi * (to - from);
}

// The reference: lines along x, whose length in the unit sphere is known, over circles around the x axis, of
// which an arc lies in the cylinder.
double volume_by_lines(double radius, double away, double low, double high) {
  const auto ring = [&](double s) {
    const double chord = std::sqrt((1 - s) * (1 + s));
    const double length = std::min(high, chord) - std::max(low, -chord);
    const double cosine = (away * away + (s - radius) * (s + radius)) / (2 * away * s);
    return length > 0 ? 2 * s * std::acos(std::clamp(cosine, -1.0, 1.0)) * length : 0.0;
  };
  std::vector<double> cut = {0, 1};
  for (const double s : {std::abs(away - radius), away + radius, std::sqrt(std::max(0.0, 1 - low * low)),
                         std::sqrt(std::max(0.0, 1 - high * high))})
    if (s > 0 && s < 1) cut.push_back(s);
  std::sort(cut.begin(), cut.end());
  double sum = 0;
  for (std::size_t k = 0; k + 1 < cut.size(); ++k) sum += double_exponential(ring, cut[k], cut[k + 1]);
  return sum;
}

// Share of points of the unit ball that lie in a region, whose axis is shifted along y, and between low and
// high along x.
struct CountedShare {
  double share, deviation;
};
CountedShare counted_share(const RoundRegion& region, double low, double high, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  constexpr int points = 40000;
  int tried = 0, inside = 0;
  while (tried < points) {
    const double x = place(generator), y = place(generator), z = region.dimension == 3 ? place(generator) : 0;
    if (x * x + y * y + z * z >= 1) continue;
    ++tried;
    const double along = region.cylinder ? 0 : x - region.along, across = y - region.away;
    const double radius = region.radius + region.slope * x;
    inside += x > low && x < high && along * along + across * across + z * z < radius * radius;
  }
  const double share = double(inside) / points;
  return {share, std::sqrt(std::max(share * (1 - share), 1.0 / points) / points)};
}

}  // namespace

TEST_CASE("a cylinder around the centre of a sphere leaves a napkin ring", "[volumes]") {
  for (const double radius : {1e-3, 0.3, 0.9, 0.999999}) {
    const double inside = unit_sphere * (1 - std::pow((1 - radius) * (1 + radius), 1.5));
    // Of 1 − (1 − R²)^1.5, for a thin cylinder 1.5 R², round-off of 1 is left.
    CHECK(sphere_in_round(1, cylinder_beside(radius, 0), -without_end, without_end) ==
          Approx(inside).epsilon(1e-14).margin(1e-15));
  }
  CHECK(sphere_in_round(1, cylinder_beside(1.5, 0.4), -2, 2) == Approx(unit_sphere).epsilon(1e-15));
  CHECK(sphere_in_round(1, cylinder_beside(0.25, 0.5), -0.1, 0.2) ==
        Approx(0.3 * std::numbers::pi / 16).epsilon(1e-14));
  CHECK(sphere_in_round(1, cylinder_beside(1, 2), -2, 2) == 0);
  CHECK(sphere_in_round(1, cylinder_beside(1, 1), 1, 2) == 0);
  // A cap below the end of a wide cylinder, of height 0.3.
  CHECK(sphere_in_round(1, cylinder_beside(9, 1), 0.7, without_end) ==
        Approx(std::numbers::pi * 0.09 * 0.9).epsilon(1e-14));
}

TEST_CASE("the body of Viviani: a cylinder from the axis to the surface", "[volumes]") {
  // Radius ½ through the centre of the sphere and a point of its surface: 2π/3 − 8/9.
  CHECK(sphere_in_round(1, cylinder_beside(0.5, 0.5), -1, 1) ==
        Approx(2 * std::numbers::pi / 3 - 8.0 / 9).epsilon(1e-13));
}

TEST_CASE("the volume of a sphere in a cylinder agrees with sums over lines", "[volumes]") {
  std::mt19937_64 generator(8);
  std::uniform_real_distribution<double> place(-1.1, 1.1), wide(0.01, 2.5), deep(0, 1);
  for (int n = 0; n < 200; ++n) {
    const double radius = n % 5 == 0 ? 1.0 : wide(generator);
    // Some axes touch the surface, some cylinders pass near the centre.
    double away = std::abs(radius - 1) + deep(generator) * (radius + 1 - std::abs(radius - 1));
    if (n % 7 == 0) away = radius + 1e-3;
    if (n % 11 == 0) away = radius;
    const double a = n % 3 == 0 ? -without_end : place(generator),
                 b = n % 4 == 0 ? without_end : place(generator);
    const double low = std::min(a, b), high = std::max(a, b);
    INFO(n << ": radius " << radius << ", away " << away << ", " << low << " to " << high);
    // What sphere_in_round states; the reference has round-off of some 1e-14.
    CHECK(std::abs(sphere_in_round(1, cylinder_beside(radius, away), low, high) -
                   volume_by_lines(radius, away, low, high)) < 1e-13 * unit_sphere);
  }
}

TEST_CASE("a cone from the centre of a sphere, or from a point of it, or one that holds it", "[volumes]") {
  for (const double half_angle : {0.1, 0.7, 1.3}) {
    const double slope = std::tan(half_angle);
    // A sector with the apex in the centre: 2π/3 (1 − cos α).
    const double sector = 2 * std::numbers::pi / 3 * (1 - std::cos(half_angle));
    CHECK(sphere_in_round(1, {3, true, 0, 0, 0, slope}, 0, without_end) == Approx(sector).margin(4e-15));
    CHECK(sphere_in_round(1, {3, true, 0, 0, 0, -slope}, -without_end, 0) ==
          Approx(sector).margin(4e-15));  // round-off of the whole sphere
    // With the apex in its lowest point: what is seen from there, 4π/3 (1 − cos⁴ α).
    CHECK(sphere_in_round(1, {3, true, slope, 0, 0, slope}, -1, without_end) ==
          Approx(4 * std::numbers::pi / 3 * (1 - std::pow(std::cos(half_angle), 4))).epsilon(1e-13));
    // It touches the sphere from outside: R = (r cos α − d cos α) at the centre.
    const double touching = 1 / std::cos(half_angle);
    CHECK(sphere_in_round(1, {3, true, touching + 0.5, 0.5, 0, slope}, -without_end, without_end) ==
          Approx(unit_sphere).epsilon(1e-13));
    const double axis_behind = 0.5 + touching;
    CHECK(sphere_in_round(1, {3, true, 0.499999, axis_behind, 0, slope}, -0.1, without_end) < 1e-15);
  }
  // A piece of a thin cone inside the sphere.
  CHECK(sphere_in_round(1, {3, true, 0.2, 0.3, 0, 0.1}, -0.5, 0.5) ==
        Approx(frustum(0.15, 0.25, 1)).epsilon(1e-14));
  CHECK(frustum(0, 2, 3) == Approx(4 * std::numbers::pi));
}

TEST_CASE("a cone of a small slope is a cylinder, and slices of a cone add up", "[volumes]") {
  const RoundRegion cone = {3, true, 0.6, 0.7, 0, 0.55};
  double sum = 0;
  for (int k = 0; k < 9; ++k) sum += sphere_in_round(1, cone, -1 + k * 2.0 / 9, -1 + (k + 1) * 2.0 / 9);
  CHECK(sum == Approx(sphere_in_round(1, cone, -1, 1)).epsilon(1e-13));
  CHECK(sphere_in_round(1, {3, true, 0.6, 0.7, 0, 1e-14}, -1, 1) ==
        Approx(sphere_in_round(1, cylinder_beside(0.6, 0.7), -1, 1)).epsilon(1e-13));
}

TEST_CASE("slices of a region, and shells, add up to what it has of a sphere", "[volumes]") {
  for (const int dimension : {2, 3}) {
    const RoundRegion region = {dimension, false, 0.8, 0.5, 0.3};
    double sum = 0;
    for (int k = 0; k < 7; ++k)
      sum += sphere_in_round(1, region, -0.5 + k * 1.6 / 7, -0.5 + (k + 1) * 1.6 / 7);
    CHECK(sum == Approx(common_volume(dimension, 1, 0.8, std::hypot(0.5, 0.3))).epsilon(1e-13));
    // Round-off of a section of a large region is that of its radius.
    const RoundRegion large = {dimension, false, 1e4, 6e3, 8e3};
    CHECK(sphere_in_round(1, large, -1, 1) == Approx(0.5 * volume_of_sphere(dimension, 1)).epsilon(1e-4));
  }
  // Two spheres on one axis: a lens of two caps, cut where they meet.
  CHECK(sphere_in_round(1, {3, false, 1, 0, 1}, 0.5, without_end) ==
        Approx(5 * std::numbers::pi / 24).epsilon(1e-13));
}

TEST_CASE("slices of spheres and cylinders hold the points that lie in them", "[volumes]") {
  for (const RoundRegion& region :
       {RoundRegion{3, true, 0.7, 0.6, 0}, RoundRegion{3, true, 0.7, 0.6, 0, 0.7},
        RoundRegion{3, true, 0.9, 0.3, 0, -0.85}, RoundRegion{3, true, 2, 1.7, 0, -1.9},
        RoundRegion{3, false, 0.7, 0.6, 0.2}, RoundRegion{3, false, 1.6, 0.9, -0.8},
        RoundRegion{2, false, 0.7, 0.6, 0.2}, RoundRegion{2, false, 1.6, 0.9, -0.8},
        RoundRegion{3, false, 0.4, 0.1, 0.2}}) {
    unsigned seed = 3;
    for (const double low : {-0.9, -0.3, 0.1, 0.4}) {
      const CountedShare counted = counted_share(region, low, low + 0.5, ++seed);
      const double exact = sphere_in_round(1, region, low, low + 0.5) / volume_of_sphere(region.dimension, 1);
      INFO(region.dimension << "D, radius " << region.radius << ", from " << low << ": " << exact);
      // Four standard deviations of the counts.
      CHECK(std::abs(exact - counted.share) < 4 * counted.deviation);
    }
  }
}

TEST_CASE("the error is one of the smaller body, however large the other is", "[volumes]") {
  // A grain cut in half, nearly, by the wall of a silo: the flat wall, and its curvature r⁴/(8R), π/4 over R:
  // ∫ y²/(2R) over the disc is π r⁴/(8 R).
  const double grain = 1e-3, silo = 1;
  const double half = unit_sphere / 2 * grain * grain * grain;
  const double bulge = std::numbers::pi / 8 * std::pow(grain, 4) / silo;
  CHECK(sphere_in_round(grain, cylinder_beside(silo, silo), -1, 1) ==
        Approx(half - bulge).epsilon(1e-7));  // the next order, (r/R)²
}
