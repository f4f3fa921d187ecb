#include "pressed_spheres.hpp"
#include "probe_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const Values wide_region = {{"region", {1}}, {"lower", {-9, -9, -9}}, {"upper", {9, 9, 9}}};

}  // namespace

TEST_CASE("fabric: three discs at a right angle, and contacts with a wall if they are wanted", "[probe]") {
  Scene sc = scene(2, 1e-4,
                   {body(1, 1, 1, {{0, 0, 0}}, {}, {}, 2), body(2, 1, 1, {{1.99, 0, 0}}, {}, {}, 2),
                    body(3, 1, 1, {{1.99, 1.99, 0}}, {}, {}, 2)},
                   elastic_law);
  add_boundary(sc, "plane", {{"point", {0, -0.99, 0}}, {"normal", {0, 1, 0}}}, "ground");
  const Simulation s(sc);
  const Sampled row = sample(s, "fabric", wide_region);
  CHECK(row["contacts"] == 2);
  CHECK(row["xx"] == Approx(0.5));
  CHECK(row["yy"] == Approx(0.5));
  CHECK(std::abs(row["xy"]) < 1e-15);
  CHECK(row["p"] == Approx(0.5));
  CHECK(std::abs(row["q"]) < 1e-15);
  Values with_walls = wide_region;
  with_walls.push_back({"walls", {1}});
  const Sampled walls = sample(s, "fabric", with_walls);
  CHECK(walls["contacts"] == 4);
  CHECK(walls["yy"] == Approx(0.75));
  CHECK(walls["q"] == Approx(0.25));
  CHECK(walls["major_y"] == Approx(1));
  // Only the contact whose point lies in the upper half.
  const Sampled bins =
      sample(s, "fabric",
             {{"region", {1}}, {"lower", {-9, -9, 0}}, {"upper", {9, 9, 0}}, {"bins", {2}}, {"along", {1}}});
  CHECK(bins["contacts_1"] == 0);
  CHECK(std::isnan(bins["xx_1"]));
  CHECK(bins["contacts_2"] == 2);
}

TEST_CASE("fabric: of a packing, by a sum over contacts of its own", "[probe]") {
  Simulation s(pressed_spheres());
  run(s, 3000);
  const ContactList list = s.contact_list();
  double contacts = 0, sum[3][3] = {};
  for (std::size_t c = 0; c < list.size(); ++c) {
    if (list.b[c] >= s.particles().size()) continue;
    ++contacts;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        sum[i][k] += list.normal[3 * c + std::size_t(i)] * list.normal[3 * c + std::size_t(k)];
  }
  REQUIRE(contacts > 100);
  const Sampled row = sample(s, "fabric");
  CHECK(row["contacts"] == contacts);
  CHECK(row["xx"] == Approx(sum[0][0] / contacts));
  CHECK(row["yz"] == Approx(sum[1][2] / contacts));
  CHECK(row["xx"] + row["yy"] + row["zz"] == Approx(1).epsilon(1e-13));
}
