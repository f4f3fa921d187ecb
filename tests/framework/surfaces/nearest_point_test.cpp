#include "surfaces/nearest_point.hpp"

#include "numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree;
using scree::test::infinite;

namespace {

struct ShapeCase {
  const char* name;
  int dimension;
  scree_surface surface;
};

const std::vector<ShapeCase> shape_cases = {
    {"rectangle", 3, {SCREE_FLAT, SCREE_BOTH_SIDES, {0.7, 0.4}, nullptr, 0}},
    {"strip", 3, {SCREE_FLAT, SCREE_BOTH_SIDES, {0.7, 50}, nullptr, 0}},
    {"tube", 3, {SCREE_REVOLVED, SCREE_BOTH_SIDES, {0.8, -0.6, 0.8, 0.7}, nullptr, 0}},
    {"funnel", 3, {SCREE_REVOLVED, SCREE_BOTH_SIDES, {0.2, -0.5, 0.9, 0.6}, nullptr, 0}},
    {"cone", 3, {SCREE_REVOLVED, SCREE_BOTH_SIDES, {0.9, -0.5, 0, 0.6}, nullptr, 0}},
    {"ring", 3, {SCREE_REVOLVED, SCREE_BOTH_SIDES, {0.9, 0.1, 0.3, 0.1}, nullptr, 0}},
    {"ball", 3, {SCREE_BALL, SCREE_BOTH_SIDES, {0.8, -infinite, infinite}, nullptr, 0}},
    {"bowl", 3, {SCREE_BALL, SCREE_BOTH_SIDES, {0.8, -infinite, 0.3}, nullptr, 0}},
    {"zone", 3, {SCREE_BALL, SCREE_BOTH_SIDES, {0.8, -0.2, 0.5}, nullptr, 0}},
    {"segment", 2, {SCREE_FLAT, SCREE_BOTH_SIDES, {0.6}, nullptr, 0}},
    {"circle", 2, {SCREE_BALL, SCREE_BOTH_SIDES, {0.7, -infinite, infinite}, nullptr, 0}},
    {"arc", 2, {SCREE_BALL, SCREE_BOTH_SIDES, {0.7, -infinite, 0.2}, nullptr, 0}},
};

// A point of a surface by two parameters in [0, 1].
Vec3 point_of(const ShapeCase& c, double u, double v) {
  const double* const size = c.surface.size;
  const double angle = 2 * std::numbers::pi * u;
  const auto between = [](double a, double b, double t) { return a + t * (b - a); };
  if (c.surface.shape == SCREE_FLAT)
    return c.dimension == 2 ? Vec3{{between(-size[0], size[0], u), 0, 0}}
                            : Vec3{{between(-size[0], size[0], u), between(-size[1], size[1], v), 0}};
  if (c.surface.shape == SCREE_REVOLVED) {
    const double radius = between(size[0], size[2], v);
    return {{radius * std::cos(angle), radius * std::sin(angle), between(size[1], size[3], v)}};
  }
  const double low = std::max(size[1], -size[0]), high = std::min(size[2], size[0]);
  if (c.dimension == 2) {
    // Both halves of the arc, by its angle from the bottom.
    const double from = std::acos(-low / size[0]), to = std::acos(-high / size[0]);
    const double turn = between(from, to, std::abs(2 * u - 1));
    return {{(u < 0.5 ? -1 : 1) * size[0] * std::sin(turn), -size[0] * std::cos(turn), 0}};
  }
  const double height = between(low, high, v), radius = std::sqrt(size[0] * size[0] - height * height);
  return {{radius * std::cos(angle), radius * std::sin(angle), height}};
}

// The least distance to points of a surface: a coarse grid, then ever finer ones about the best of it.
double least_distance(const ShapeCase& c, const Vec3& x) {
  double best = infinite, at_u = 0.5, at_v = 0.5, width = 0.5;
  constexpr int points = 40;
  for (int round = 0; round < 14; ++round, width *= 0.15) {
    const double middle_u = at_u, middle_v = at_v;
    for (int i = -points; i <= points; ++i)
      for (int k = -points; k <= points; ++k) {
        double u = middle_u + width * i / points;
        const double v = std::clamp(middle_v + width * k / points, 0.0, 1.0);
        // Revolved surfaces are closed; others end.
        if (c.surface.shape == SCREE_FLAT || c.dimension == 2) u = std::clamp(u, 0.0, 1.0);
        if (const double distance = norm(x - point_of(c, u, v)); distance < best)
          best = distance, at_u = u, at_v = v;
      }
  }
  return best;
}

NearestPoint nearest(const ShapeCase& c, const Vec3& x) { return nearest_point(c.surface, c.dimension, x); }

}  // namespace

// The search ends within 1e-9 of the least distance, of a length of 1: it is the square of its last spacing
// beside a smooth minimum, and the spacing itself, 0.5 · 0.15^13 / 40, at an edge.
TEST_CASE("nearest points are as near as the nearest of many points of the surface", "[surfaces]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-1.3, 1.3);
  for (const ShapeCase& c : shape_cases) {
    REQUIRE(problem_of(c.surface, c.dimension) == std::string());
    for (int n = 0; n < 60; ++n) {
      const Vec3 x = {{place(random), place(random), c.dimension == 2 ? 0 : place(random)}};
      INFO(c.name << " at " << x[0] << ", " << x[1] << ", " << x[2]);
      const NearestPoint found = nearest(c, x);
      CHECK(found.distance == Approx(least_distance(c, x)).margin(1e-9));
      CHECK(norm(x - found.point) == Approx(found.distance).margin(1e-15));
      CHECK(norm(found.normal) == Approx(1).margin(1e-15));
      CHECK(norm(found.point + found.distance * found.normal - x) < 1e-14);
      CHECK(norm(found.point) <= reach_of(c.surface, c.dimension) * (1 + 1e-15));
    }
  }
}

TEST_CASE("a surface with one side has a distance below 0 behind it, and edges have both sides",
          "[surfaces]") {
  for (ShapeCase c : shape_cases) {
    INFO(c.name);
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> place(-1.3, 1.3);
    int behind = 0;
    for (int n = 0; n < 200; ++n) {
      const Vec3 x = {{place(random), place(random), c.dimension == 2 ? 0 : place(random)}};
      c.surface.side = SCREE_BOTH_SIDES;
      const NearestPoint both = nearest(c, x);
      c.surface.side = SCREE_OUTSIDE;
      const NearestPoint outside = nearest(c, x);
      c.surface.side = SCREE_INSIDE;
      const NearestPoint inside = nearest(c, x);
      const bool on_edge = outside.distance == inside.distance;
      CHECK(both.distance == std::max(outside.distance, inside.distance));
      if (on_edge) continue;
      CHECK(outside.distance == -inside.distance);
      CHECK(outside.normal == -inside.normal);
      CHECK(outside.curvature == -inside.curvature);
      behind += outside.distance < 0;
    }
    CHECK(behind > 0);
  }
}

// The surface bends away from its tangent plane by ½ κ s² beside a convex place.
TEST_CASE("curvature is how a surface bends away from its tangent plane", "[surfaces]") {
  constexpr double aside = 1e-4;
  const auto bend_of = [&](const ShapeCase& c, const Vec3& x) {
    const NearestPoint at = nearest(c, x);
    // Across the axis, where cylinders and cones bend.
    Vec3 across =
        c.dimension == 2 ? Vec3{{-at.normal[1], at.normal[0], 0}} : cross(at.normal, Vec3{{0, 0, 1}});
    across = 1 / norm(across) * across;
    const Vec3 beside = at.point + aside * across;
    const NearestPoint there = nearest(c, beside + 0.01 * at.normal);
    return 2 * dot(at.normal, at.point - there.point) / (aside * aside);
  };
  for (const ShapeCase& c : shape_cases) {
    if (c.surface.shape == SCREE_FLAT || c.name == std::string("ring")) continue;
    const Vec3 out = {{0.9, c.dimension == 2 ? -0.3 : 0.4, c.dimension == 2 ? 0.0 : 0.05}};
    for (const double part : {1.0, 0.4}) {
      const Vec3 x = part * out;
      INFO(c.name << " at " << part);
      CHECK(bend_of(c, x) == Approx(nearest(c, x).curvature[0]).epsilon(0.05));
    }
  }
}

TEST_CASE("shapes that are none are named", "[surfaces]") {
  const auto problem = [](std::uint32_t shape, std::vector<double> size, int dimension = 3) {
    scree_surface surface = {shape, SCREE_BOTH_SIDES, {}, nullptr, 0};
    std::copy(size.begin(), size.end(), surface.size);
    return std::string(problem_of(surface, dimension));
  };
  CHECK(problem(SCREE_FLAT, {1, 0}) == "a length is not above 0");
  CHECK(problem(SCREE_FLAT, {NAN, 1}) == "a length is not above 0");
  CHECK(problem(SCREE_FLAT, {1}, 2).empty());
  CHECK(problem(SCREE_REVOLVED, {1, 0, 1, 1}, 2) == "a 2D scene has no such shape");
  CHECK(problem(SCREE_REVOLVED, {-1, 0, 1, 1}) == "a radius is below 0, or both are 0");
  CHECK(problem(SCREE_REVOLVED, {1, 0, NAN, 1}) == "a radius is below 0, or both are 0");
  CHECK(problem(SCREE_REVOLVED, {1, 1, 1, 0}) == "its end lies below its start");
  CHECK(problem(SCREE_REVOLVED, {1, -infinite, 2, infinite}) == "it is infinite at one end alone");
  CHECK(problem(SCREE_REVOLVED, {1, -infinite, 1, 0}) == "it is infinite at one end alone");
  CHECK(problem(SCREE_REVOLVED, {1, -infinite, 1, infinite}).empty());
  CHECK(problem(SCREE_REVOLVED, {1, 2, 1, 2}) == "its line has no length");
  CHECK(problem(SCREE_BALL, {0, -1, 1}) == "its radius is not above 0");
  CHECK(problem(SCREE_BALL, {1, 2, 3}) == "its limits leave nothing of it");
  CHECK(problem(9, {}) == "its shape or side is unknown");
}
