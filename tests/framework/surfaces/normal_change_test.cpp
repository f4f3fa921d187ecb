#include "surfaces/normal_change.hpp"

#include "meshes.hpp"
#include "numbers.hpp"
#include "surfaces/contact_spots.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

// Derivatives of nearest points against differences.

using namespace scree;
using scree::test::infinite;

namespace {

struct TurningCase {
  const char* name;
  int dimension;
  scree_surface surface;
};

const std::vector<TurningCase> turning_cases = {
    {"rectangle", 3, {SCREE_FLAT, SCREE_BOTH_SIDES, {0.7, 0.4}, nullptr, 0}},
    {"endless cylinder", 3, {SCREE_REVOLVED, SCREE_INSIDE, {0.8, -infinite, 0.8, infinite}, nullptr, 0}},
    {"tube", 3, {SCREE_REVOLVED, SCREE_BOTH_SIDES, {0.8, -0.6, 0.8, 0.7}, nullptr, 0}},
    {"funnel", 3, {SCREE_REVOLVED, SCREE_OUTSIDE, {0.2, -0.5, 0.9, 0.6}, nullptr, 0}},
    {"cone", 3, {SCREE_REVOLVED, SCREE_INSIDE, {0.9, -0.5, 0, 0.6}, nullptr, 0}},
    {"ring", 3, {SCREE_REVOLVED, SCREE_BOTH_SIDES, {0.9, 0.1, 0.3, 0.1}, nullptr, 0}},
    {"ball", 3, {SCREE_BALL, SCREE_OUTSIDE, {0.8, -infinite, infinite}, nullptr, 0}},
    {"zone", 3, {SCREE_BALL, SCREE_BOTH_SIDES, {0.8, -0.2, 0.5}, nullptr, 0}},
    {"segment", 2, {SCREE_FLAT, SCREE_BOTH_SIDES, {0.6}, nullptr, 0}},
    {"circle", 2, {SCREE_BALL, SCREE_INSIDE, {0.7, -infinite, infinite}, nullptr, 0}},
    {"arc", 2, {SCREE_BALL, SCREE_BOTH_SIDES, {0.7, -infinite, 0.2}, nullptr, 0}},
};

// Largest difference of a derivative and a central one of a function of a place.
template <class Function>
double deviation(const Function& function, const Vec3& x, int axis, double exact) {
  constexpr double step = 1e-5;
  Vec3 there = x, back = x;
  there[axis] += step, back[axis] -= step;
  return std::abs((function(there) - function(back)) / (2 * step) - exact);
}

// Whether the nearest point moves continuously about x: no edge and no axis is within some steps.
template <class Nearest>
bool is_smooth_at(const Nearest& nearest, const Vec3& x, int dimension) {
  const NearestPoint here = nearest(x);
  if (std::abs(here.distance) < 0.05) return false;
  for (int k = 0; k < dimension; ++k)
    for (const double step : {-1e-3, 1e-3}) {
      Vec3 beside = x;
      beside[k] += step;
      const NearestPoint there = nearest(beside);
      // The normal turns by the step over a distance of 0.05 at most.
      if (norm(there.normal - here.normal) > 0.03) return false;
      if ((there.curvature[0] == 0) != (here.curvature[0] == 0)) return false;
    }
  return true;
}

std::string text(const Vec3& x) {
  return std::to_string(x[0]) + " " + std::to_string(x[1]) + " " + std::to_string(x[2]);
}

}  // namespace

// Central differences with steps h = 1e-5: h²/6 of third derivatives, which are below 6/0.05³ = 5e4 at
// distances above 0.05: 1e-6. Points beside edges, where the derivative jumps, are left out.
TEST_CASE("derivatives of the normal and of the curvature are those of nearest points", "[surfaces]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.3, 1.3);
  for (const TurningCase& c : turning_cases) {
    const auto nearest = [&](const Vec3& x) { return nearest_point(c.surface, c.dimension, x); };
    int checked = 0;
    for (int point = 0; point < 400; ++point) {
      const Vec3 x = {{place(random), place(random), c.dimension == 2 ? 0 : place(random)}};
      if (!is_smooth_at(nearest, x, c.dimension) || std::hypot(x[0], x[1]) < 0.05) continue;
      INFO(c.name << " at " << text(x));
      ++checked;
      const NearestPoint here = nearest(x);
      const Matrix3 change = normal_change(c.surface, c.dimension, x, here);
      const Vec3 bend = curvature_change(c.surface, x, here);
      double worst = 0;
      for (int k = 0; k < c.dimension; ++k) {
        for (int n = 0; n < c.dimension; ++n)
          worst = std::max(worst, deviation([&](const Vec3& y) { return nearest(y).normal[n]; }, x, k,
                                            change[std::size_t(n)][k]));
        worst =
            std::max(worst, deviation([&](const Vec3& y) { return nearest(y).curvature[0]; }, x, k, bend[k]) /
                                std::max(1.0, here.curvature[0] * here.curvature[0]));
      }
      CHECK(worst < 1e-5);
    }
    CHECK(checked > 100);
  }
}

// As above, over faces, edges and corners of a box and of hills.
TEST_CASE("derivatives of the normal at spots of meshes are those of nearest points", "[surfaces]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1.3, 1.3);
  for (const scree::test::Mesh& shape :
       {scree::test::box_mesh({{0.5, 0.6, 0.7}}, 2), scree::test::sphere_mesh(0.8, 3)}) {
    const TriangleMesh mesh(shape.numbers(), 1);
    for (const std::uint32_t side : {SCREE_BOTH_SIDES, SCREE_OUTSIDE, SCREE_INSIDE}) {
      const SpotRule rule = {side, 1};
      const auto nearest = [&](const Vec3& x) { return nearest_spot(mesh, rule, x); };
      int checked = 0;
      for (int point = 0; point < 400; ++point) {
        const Vec3 x = {{place(random), place(random), place(random)}};
        if (!is_smooth_at(nearest, x, 3)) continue;
        INFO("side " << side << " at " << text(x));
        const Matrix3 change = normal_change(mesh, x, nearest(x));
        double worst = 0;
        for (int k = 0; k < 3; ++k)
          for (int n = 0; n < 3; ++n)
            worst = std::max(worst, deviation([&](const Vec3& y) { return nearest(y).normal[n]; }, x, k,
                                              change[std::size_t(n)][k]));
        CHECK(worst < 1e-5);
        ++checked;
      }
      CHECK(checked > 100);
    }
  }
}
