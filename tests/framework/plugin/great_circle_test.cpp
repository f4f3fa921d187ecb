#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include <scree/plugin/great_circle.hpp>

using namespace scree;

namespace {

struct Sample {
  Vec3 from, direction;  // orthogonal unit vectors
  double angle;
};

template <class Visit>
void each_sample(const Visit& visit) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> component;
  std::uniform_real_distribution<double> exponent(-12, std::log10(longest_arc));
  for (int k = 0; k < 20000; ++k) {
    Vec3 from = {{component(random), component(random), component(random)}};
    from = (1 / norm(from)) * from;
    Vec3 across = tangential_part(Vec3{{component(random), component(random), component(random)}}, from);
    across = tangential_part(across, from);
    visit(Sample{from, (1 / norm(across)) * across, std::pow(10, exponent(random))});
  }
}

}  // namespace

TEST_CASE("arcs and their ends agree with trigonometric functions to round-off", "[great_circle]") {
  double arc_error = 0, end_error = 0, back_error = 0, shear_error = 0;
  each_sample([&](const Sample& s) {
    const Vec3 arc = s.angle * s.direction;
    const Vec3 to = std::cos(s.angle) * s.from + std::sin(s.angle) * s.direction;
    arc_error = std::max(arc_error, norm(arc_between(s.from, to) - arc));
    end_error = std::max(end_error, norm(end_of_arc(s.from, arc) - to));
    back_error = std::max(back_error, norm(arc_between(s.from, end_of_arc(s.from, arc)) - arc));
    // The closed form loses digits as 1/φ².
    const double exact = (1 - s.angle / std::tan(s.angle)) / (s.angle * s.angle);
    if (s.angle > 0.05)
      shear_error = std::max(shear_error, std::abs(arc_shear(s.angle * s.angle) - exact) * s.angle * s.angle);
  });
  // Components of unit vectors are rounded to 1.1e-16; some four operations on each.
  CHECK(arc_error < 8e-16);
  CHECK(end_error < 8e-16);
  CHECK(back_error < 8e-16);
  CHECK(shear_error < 8e-16);
  CHECK(arc_shear(0.0) == Approx(1.0 / 3).epsilon(1e-15));
  CHECK(norm(arc_between(Vec3{{0, 0, 1}}, Vec3{{0, 0, 1}})) == 0);
}

TEST_CASE("rotation by a quaternion is that of its angle about its axis, and its inverse undoes it",
          "[great_circle]") {
  each_sample([&](const Sample& s) {
    const Vec<4> q = {{std::cos(0.5 * s.angle), std::sin(0.5 * s.angle) * s.from[0],
                       std::sin(0.5 * s.angle) * s.from[1], std::sin(0.5 * s.angle) * s.from[2]}};
    const Vec3 expected = std::cos(s.angle) * s.direction + std::sin(s.angle) * cross(s.from, s.direction);
    CHECK(norm(rotated(q, s.direction) - expected) < 8e-16);
    CHECK(norm(rotated_back(q, rotated(q, s.direction)) - s.direction) < 8e-16);
  });
}

TEST_CASE("a quaternion changes as its body turns about axes of space", "[great_circle]") {
  const double small = 1e-4;  // rad; the change is of the first order, so that its square is left out
  each_sample([&](const Sample& s) {
    const Vec<4> q = {{0.5, 0.5, -0.1, 0.7}};
    const Vec3 before = rotated(q, s.direction);
    const Vec3 after = rotated(q + quaternion_change(q, small * s.from), s.direction);
    CHECK(norm(after - before - small * cross(s.from, before)) < small * small);
  });
}
