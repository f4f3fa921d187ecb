#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include <scree/plugin/sphere_volumes.hpp>

using namespace scree;

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
// Round-off of eight terms of the size of the sphere.
constexpr double volume_round_off = 8 * 4.2 * 2.3e-16 * 4;

// The reference: the length of lines along z, summed over a grid in polar angles of x and y, midpoint rule.
double summed_volume(const Vec3& lower, const Vec3& upper) {
  constexpr int lines = 600;
  const auto limit = [](double x) { return std::asin(std::clamp(x, -1.0, 1.0)); };
  double sum = 0;
  const double from = limit(lower[0]), to = limit(upper[0]);
  for (int i = 0; i < lines && from < to; ++i) {
    const double angle = from + (i + 0.5) * (to - from) / lines, rho = std::cos(angle);
    const double low = limit(lower[1] / rho), high = limit(upper[1] / rho);
    for (int k = 0; k < lines && low < high; ++k) {
      const double turn = low + (k + 0.5) * (high - low) / lines, half = rho * std::cos(turn);
      const double length = std::min(upper[2], half) - std::max(lower[2], -half);
      // dx dy = cos(angle) ρ cos(turn) dangle dturn
      if (length > 0) sum += length * rho * half * (to - from) / lines * (high - low) / lines;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("halves, quarters, eighths and caps of a sphere have their volumes", "[volumes]") {
  const Vec3 low = {-unlimited, -unlimited, -unlimited}, high = {unlimited, unlimited, unlimited};
  const double whole = 4.0 / 3 * std::numbers::pi;
  CHECK(sphere_in_box({}, 1, low, high) == Approx(whole).margin(volume_round_off));
  CHECK(sphere_in_box({}, 1, {0, -unlimited, -unlimited}, high) ==
        Approx(whole / 2).margin(volume_round_off));
  CHECK(sphere_in_box({}, 1, {0, 0, -unlimited}, high) == Approx(whole / 4).margin(volume_round_off));
  CHECK(sphere_in_box({}, 1, {0, 0, 0}, high) == Approx(whole / 8).margin(volume_round_off));
  // A cap of height h: π h² (R − h/3).
  CHECK(sphere_in_box({}, 1, low, {unlimited, -0.7, unlimited}) ==
        Approx(std::numbers::pi * 0.09 * 0.9).margin(volume_round_off));
  // A small cube within, and boxes beside the sphere.
  CHECK(sphere_in_box({1, 2, 3}, 1, {0.9, 1.9, 2.9}, {1.1, 2.1, 3.1}) ==
        Approx(0.008).margin(volume_round_off));
  CHECK(sphere_in_box({}, 1, {1, -5, -5}, {5, 5, 5}) == 0);
  CHECK(sphere_in_box({}, 1, {0.8, 0.8, -5}, {5, 5, 5}) == 0);
  CHECK(sphere_in_box({}, 1, {0, 0, 0}, {0, 1, 1}) == 0);
  CHECK(disc_in_rectangle({}, 2, low, high) == Approx(4 * std::numbers::pi).margin(volume_round_off));
  CHECK(disc_in_rectangle({}, 2, {0, 0, 0}, high) == Approx(std::numbers::pi).margin(volume_round_off));
  CHECK(disc_in_rectangle({0, 0, 7}, 2, {-0.1, -0.1, 0}, {0.1, 0.1, 0}) ==
        Approx(0.04).margin(volume_round_off));
}

TEST_CASE("the volume of a sphere in a box agrees with sums over lines", "[volumes]") {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> place(-1.2, 1.2);
  for (int n = 0; n < 60; ++n) {
    Vec3 lower, upper;
    for (int k = 0; k < 3; ++k) {
      const double a = n % 3 == k ? 0 : place(generator), b = place(generator);
      lower[k] = std::min(a, b);
      upper[k] = std::max(a, b);
    }
    INFO(lower[0] << ' ' << lower[1] << ' ' << lower[2] << " to " << upper[0] << ' ' << upper[1] << ' '
                  << upper[2]);
    // The midpoint rule with a kink at the surface errs by some 1/600² of a section.
    CHECK(std::abs(sphere_in_box({}, 1, lower, upper) - summed_volume(lower, upper)) < 2e-5);
  }
}

TEST_CASE("planes close to the centre of a sphere cut off the right volume", "[volumes]") {
  const Vec3 low = {-unlimited, -unlimited, -unlimited};
  for (double size = 1e-17; size < 0.5; size *= 1.7)
    for (const double b : {size, -size})
      for (int k = 0; k < 3; ++k) {
        INFO("plane " << b << " across axis " << k);
        Vec3 high = {unlimited, unlimited, unlimited};
        high[k] = b;
        const double cap = std::numbers::pi * (1 + b) * (1 + b) * (2 - b) / 3;
        CHECK(std::abs(sphere_in_box({}, 1, low, high) - cap) < volume_round_off);
        // A second plane leaves half of a cap, and b times the section of it; b³ is left out.
        if (size > 1e-6) continue;
        const double a = 0.3, section = std::acos(a) - a * std::sqrt(1 - a * a);
        const double half_cap = std::numbers::pi * (1 - a) * (1 - a) * (2 + a) / 6;
        Vec3 corner = low;
        corner[(k + 1) % 3] = a;
        CHECK(std::abs(sphere_in_box({}, 1, corner, high) - half_cap - b * section) < volume_round_off);
      }
}

TEST_CASE("shallow segments of a disc have their area", "[volumes]") {
  const double radius = 0.3;
  for (double depth = 1e-15; depth < 1e-6; depth *= 1.7) {
    // R² 4/3 √2 h^(3/2) (1 − 3h/20), with the h that round-off of the line's place leaves.
    const double line = radius * (1 - depth), h = (radius - line) / radius;
    const double segment =
        radius * radius * 4.0 / 3 * std::numbers::sqrt2 * h * std::sqrt(h) * (1 - 0.15 * h);
    const Vec3 low = {line, -unlimited, 0}, high = {unlimited, unlimited, 0};
    CHECK(std::abs(disc_in_rectangle({}, radius, low, high) - segment) < volume_round_off * radius * radius);
  }
}

TEST_CASE("parts of a sphere, and of a disc, add up to the whole", "[volumes]") {
  std::mt19937_64 generator(6);
  std::uniform_real_distribution<double> place(-1.2, 1.2);
  for (int n = 0; n < 300; ++n) {
    // Some cuts go through the centre, or touch the surface.
    const double cut[3] = {n % 4 == 0 ? 0 : place(generator), n % 3 == 0 ? 0 : place(generator),
                           n % 7 == 0 ? 1 : place(generator)};
    double volume = 0, area = 0;
    for (int part = 0; part < 8; ++part) {
      Vec3 lower = {}, upper = {};
      for (int k = 0; k < 3; ++k) {
        lower[k] = part >> k & 1 ? cut[k] : -unlimited;
        upper[k] = part >> k & 1 ? unlimited : cut[k];
      }
      volume += sphere_in_box({}, 1, lower, upper);
      if (part < 4) area += disc_in_rectangle({}, 1, lower, upper);
    }
    CHECK(std::abs(volume - 4.0 / 3 * std::numbers::pi) < 8 * volume_round_off);
    CHECK(std::abs(area - std::numbers::pi) < 4 * volume_round_off);
  }
}

TEST_CASE("spheres and discs have the volume of their lens in common", "[volumes]") {
  // Two unit spheres, a radius apart: 5π/12; two unit discs: 2π/3 − √3/2.
  CHECK(common_volume(3, 1, 1, 1) == Approx(5 * std::numbers::pi / 12).margin(volume_round_off));
  CHECK(common_volume(2, 1, 1, 1) ==
        Approx(2 * std::numbers::pi / 3 - std::sqrt(3.0) / 2).margin(volume_round_off));
  CHECK(common_volume(3, 1, 0.25, 0.5) == volume_of_sphere(3, 0.25));
  CHECK(common_volume(2, 0.25, 1, 0) == volume_of_sphere(2, 0.25));
  CHECK(common_volume(3, 1, 0.25, 1.25) == 0);
  // Unequal ones against a sum over sections.
  constexpr int sections = 20000;
  double volume = 0, area = 0;
  for (int k = 0; k < sections; ++k) {
    const double x = -1 + (k + 0.5) * 2 / sections;
    const double square = std::min(1 - x * x, 0.49 - (x - 0.9) * (x - 0.9));
    if (square <= 0) continue;
    volume += std::numbers::pi * square * 2 / sections;
    area += 2 * std::sqrt(square) * 2 / sections;
  }
  CHECK(common_volume(3, 1, 0.7, 0.9) == Approx(volume).margin(1e-7));
  CHECK(common_volume(2, 1, 0.7, 0.9) == Approx(area).margin(1e-5));
  // A small disc that a large circle cuts in half: its curvature leaves ∫ y²/2 dy = r³/3 out; the next order
  // is r⁵.
  const double small = 1e-6;
  CHECK(common_volume(2, 1, small, 1) ==
        Approx((std::numbers::pi / 2 - small / 3) * small * small).epsilon(3e-12));
}
