#include "body_stress.hpp"

#include "sample_frame.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("the stress of a body is of the forces on it and the arms to its contacts", "[pictures]") {
  // Two spheres of radius 0.1 m along x, with 3 N along the normal and 1 N along y on the first.
  Frame frame;
  frame.id = {4, 9};
  frame.radius = {0.1, 0.1};
  frame.position = {0.2, 0, 0, 0, 0, 0};
  frame.contact_a = {4};
  frame.contact_b = {9};
  frame.contact_normal_force = {3};
  frame.contact_overlap = {0.02};
  frame.contact_normal = {1, 0, 0};
  frame.contact_force = {3, 1, 0};
  const double volume = 4.0 / 3 * std::numbers::pi * 1e-3;
  const std::vector<double> stress = stresses(frame);
  REQUIRE(stress.size() == 12);
  for (std::size_t body = 0; body < 2; ++body) {
    const double* const s = stress.data() + 6 * body;
    CHECK(s[0] == Approx(3 * 0.09 / volume));
    CHECK(s[1] == 0);
    CHECK(s[3] == Approx(0.5 * 0.09 / volume));  // xy
    CHECK(s[4] == 0);
    CHECK(s[5] == 0);
    CHECK(pressures(frame)[body] == Approx((s[0] + s[1] + s[2]) / 3));
  }
  frame.contact_normal = {0, 1, 0};
  frame.contact_force = {0, 3, 2};
  CHECK(stresses(frame)[4] == Approx(0.09 / volume));  // yz
  CHECK(largest_forces(frame)[0] == Approx(std::sqrt(13.0)));
  frame.contact_a.clear();  // as in files of earlier versions
  CHECK(stresses(frame).empty());
}
