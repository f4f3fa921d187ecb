#include "pressed_spheres.hpp"
#include "probe_support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("forces: two contacts of 100 and 300 N have known moments and classes", "[probe]") {
  const Simulation s(scene(2, 1e-4,
                           {body(1, 1, 1, {{0, 0, 0}}, {}, {}, 2), body(2, 1, 1, {{1.99, 0, 0}}, {}, {}, 2),
                            body(3, 1, 1, {{3.96, 0, 0}}, {}, {}, 2)},
                           {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}}));
  const Values wide = {
      {"region", {1}}, {"lower", {-9, -9, 0}}, {"upper", {9, 9, 0}}, {"classes", {4}}, {"largest", {2}}};
  const Sampled row = sample(s, "forces", wide);
  CHECK(row["contacts"] == 2);
  CHECK(row["normal_mean"] == Approx(200));
  CHECK(row["tangential_mean"] < 1e-11);  // round-off of 300 N
  CHECK(row["normal_moment_2"] == Approx(1.25));
  CHECK(row["normal_moment_3"] == Approx(1.75));
  CHECK(row["normal_moment_4"] == Approx((std::pow(0.5, 4) + std::pow(1.5, 4)) / 2));
  CHECK(row["mobilised_mean"] < 1e-13);
  // 0.5 and 1.5 of the mean, each at the lower end of a class up to round-off of positions.
  double sum = 0;
  for (int k = 1; k <= 4; ++k) sum += 0.5 * row["normal_" + std::to_string(k)];
  CHECK(sum == Approx(1));
  CHECK(row["normal_1"] + row["normal_2"] == Approx(1));
  const Sampled none = sample(s, "forces", {{"region", {1}}, {"lower", {7, 7, 0}}, {"upper", {9, 9, 0}}});
  CHECK(none["contacts"] == 0);
  CHECK(std::isnan(none["normal_mean"]));
  CHECK(std::isnan(none["mobilised_largest"]));
}

TEST_CASE("forces: of a packing, by sums of its own, with friction mobilised up to its limit", "[probe]") {
  Simulation s(pressed_spheres());
  run(s, 3000);
  const ContactList list = s.contact_list();
  std::vector<double> normal, ratio;
  double tangential = 0;
  for (std::size_t c = 0; c < list.size(); ++c) {
    if (list.b[c] >= s.particles().size()) continue;
    double along = 0, square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      along += list.force[3 * c + k] * list.normal[3 * c + k];
      square += list.force[3 * c + k] * list.force[3 * c + k];
    }
    normal.push_back(along);
    tangential += std::sqrt(std::max(0.0, square - along * along));
    if (along > 0) ratio.push_back(std::sqrt(std::max(0.0, square - along * along)) / along);
  }
  double mean = 0, square = 0;
  for (const double f : normal) mean += f / double(normal.size());
  for (const double f : normal) square += f * f / double(normal.size()) / (mean * mean);
  const Sampled row = sample(s, "forces", {{"largest", {8}}, {"classes", {16}}});
  CHECK(row["contacts"] == double(normal.size()));
  CHECK(row["normal_mean"] == Approx(mean));
  CHECK(row["normal_moment_2"] == Approx(square));
  CHECK(row["tangential_mean"] == Approx(tangential / double(normal.size())));
  // Squares of forces, whose difference is a small one, err by 1e-16 of the larger.
  CHECK(row["mobilised_largest"] == Approx(*std::max_element(ratio.begin(), ratio.end())).epsilon(1e-9));
  CHECK(row["mobilised_largest"] <= 0.4 * (1 + 1e-12));
  CHECK(row["mobilised_largest"] > 0.39);
  double shares = 0;
  for (int k = 1; k <= 16; ++k) shares += 0.5 * row["normal_" + std::to_string(k)];
  const auto below =
      std::count_if(normal.begin(), normal.end(), [&](double f) { return f >= 0 && f < 8 * mean; });
  CHECK(shares == Approx(double(below) / double(normal.size())));
}
