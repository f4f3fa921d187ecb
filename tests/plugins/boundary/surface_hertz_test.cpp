#include "wall_support.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include <scree/wall_surfaces.hpp>

// Hertz contacts of spheres with curved walls, against the theory of elliptic contacts.

using namespace scree;
using namespace scree::test;

namespace {

// Complete elliptic integrals of parameter m by the arithmetic-geometric mean.
struct Elliptic {
  double first, second;

  explicit Elliptic(double m) {
    double a = 1, b = std::sqrt(1 - m), sum = 0.5 * m;
    for (double c = 1, power = 1; c > 1e-16; power *= 2) {
      c = 0.5 * (a - b);
      const double mean = 0.5 * (a + b);
      b = std::sqrt(a * b), a = mean;
      sum += power * c * c;
    }
    first = std::numbers::pi / (2 * a);
    second = first * (1 - sum);
  }
};

// F/(E* δ^1.5) of a contact with relative curvatures 1/R and (1 + κ)/R for R = 1 (Johnson 1985, eqs 4.26 to
// 4.28): the ratio of the axes by bisection.
double elliptic_stiffness(double kappa) {
  const double low = 0.5 * std::min(1.0, 1 + kappa), high = 0.5 * std::max(1.0, 1 + kappa);
  const auto shape = [](double ratio, const Elliptic& e) {
    return std::array{e.second / (ratio * ratio) - e.first, e.first - e.second};
  };
  double least = 0.05, most = 1 - 1e-7;
  for (int k = 0; k < 100; ++k) {
    const double ratio = 0.5 * (least + most);
    const auto [over, under] = shape(ratio, Elliptic(1 - ratio * ratio));
    (over / under > high / low ? least : most) = ratio;
  }
  const double m = 1 - least * least;
  const Elliptic e(m);
  const auto [over, under] = shape(least, e);
  const double pressure = std::sqrt(low * high) * m / (least * std::sqrt(over * under));
  return 2.0 / 3 * pressure * std::numbers::pi * least / std::pow(pressure * least * e.first, 1.5);
}

// Force (N) on a wall of a sphere that overlaps with it.
double force_on(const std::string& plugin, Values values, double distance, double radius) {
  Scene sc = scene(
      3, 1e-7, {body(1, radius, 0.01, {{distance, 0, 0}})},
      {{"youngs_modulus", {1e7}}, {"poissons_ratio", {0.25}}, {"restitution", {0.5}}, {"friction", {0.3}}},
      "hertz_mindlin");
  values.push_back({"point", {0, 0, 0}});
  add_boundary(sc, plugin, values);
  const Simulation s(sc);
  return std::abs(s.surfaces().loads[0].force[0]);
}

}  // namespace

// F ∝ √R*, relative to a flat wall. A cylinder leaves out F₂ of Johnson's eq. 4.26: 0.02 κ², and 0.035 κ²
// where it is hollow, for curvatures κ up to a half.
TEST_CASE("the curvature of a wall enters the effective radius of Hertz contacts", "[surfaces]") {
  constexpr double radius = 0.01, overlap = 1e-5;
  REQUIRE(elliptic_stiffness(1e-6) == Approx(4.0 / 3).epsilon(1e-6));
  const double flat = force_on("disc", {{"normal", {1, 0, 0}}, {"radius", {1}}}, radius - overlap, radius);
  REQUIRE(flat > 0);
  for (const double wall : {0.02, 0.05, 0.1}) {
    const Values inside = {{"radius", {wall}}, {"side", {2}}}, outside = {{"radius", {wall}}, {"side", {1}}};
    for (const double sign : {-1.0, 1.0}) {
      const double kappa = sign * radius / wall;
      INFO("wall of " << wall << " m, curvature " << kappa);
      const double distance = wall + sign * (radius - overlap);
      const Values& side = sign < 0 ? inside : outside;
      CHECK(force_on("sphere", side, distance, radius) / flat ==
            Approx(1 / std::sqrt(1 + kappa)).epsilon(1e-10));
      CHECK(force_on("cylinder", side, distance, radius) / flat ==
            Approx(0.75 * elliptic_stiffness(kappa)).epsilon((kappa < 0 ? 0.041 : 0.02) * kappa * kappa));
    }
  }
}
