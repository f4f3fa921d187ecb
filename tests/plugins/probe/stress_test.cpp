#include "error_line.hpp"
#include "pressed_spheres.hpp"
#include "probe_support.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("stress: two discs pressed together have the stress of one force over a branch", "[probe]") {
  // Overlap 0.02 m: 100 N along x over a distance of 1.98 m, in a box of 4 m by 3 m.
  Scene sc = scene(
      2, 1e-4, {body(1, 1, 1, {{1, 1.5, 0}}, {}, {}, 2), body(2, 1, 2, {{2.98, 1.5, 0}}, {1, 0, 0}, {}, 2)},
      {{"normal_stiffness", {5000}}, {"normal_damping", {0}}});
  const Simulation s(sc);
  const Values box = {{"region", {1}}, {"lower", {0, 0, 0}}, {"upper", {4, 3, 0}}};
  const Sampled all = sample(s, "stress", box);
  CHECK(all["xx"] == Approx(100 * 1.98 / 12));
  CHECK(all["yy"] == 0);
  CHECK(all["xy"] == 0);
  CHECK(all["p"] == Approx(50 * 1.98 / 12));
  CHECK(all["q"] == Approx(50 * 1.98 / 12));
  CHECK(all["major"] == Approx(100 * 1.98 / 12));
  CHECK(all["major_x"] == Approx(1));
  // Velocities 0 and 1 m/s of 1 and 2 kg: mean 2/3, and Σ m (v − 2/3)² = 4/9 + 2/9.
  Values kinetic = box;
  kinetic.push_back({"kinetic", {2}});
  CHECK(sample(s, "stress", kinetic)["xx"] == Approx(2.0 / 3 / 12));
  kinetic.back().second = {1};
  CHECK(sample(s, "stress", kinetic)["xx"] == Approx((100 * 1.98 + 2.0 / 3) / 12));
  // Of one disc alone: the half of the branch that lies in it.
  CHECK(sample(s, "stress", box, {0, 1})["xx"] == Approx(100 * 0.99 / 12));
  CHECK(sample(s, "stress", box, {1, 0})["xx"] == Approx(100 * 0.99 / 12));
  // Bins along the branch: from 1 to 2.98 m in bins of 1 m.
  Values bins = box;
  bins.insert(bins.end(), {{"bins", {4}}, {"along", {0}}});
  const Sampled parts = sample(s, "stress", bins);
  CHECK(parts["xx_1"] == 0);
  CHECK(parts["xx_2"] == Approx(100.0 / 3));
  CHECK(parts["xx_3"] == Approx(98.0 / 3));
  CHECK(parts["xx_4"] == 0);
}

// The force through a section at a height z is the load on the lid, minus friction of side walls and net
// forces of bodies above it; the stress of a layer times its section is the mean over the layer.
TEST_CASE("stress: a layer bears the load on the lid but for friction at the sides and net forces",
          "[probe]") {
  Simulation s(pressed_spheres());
  run(s, 4000);
  const SimulationView contacts(s, SCREE_NEEDS_CONTACTS);
  const scree_view& view = contacts.get();
  const double low = s.planes()[4].point[2], high = s.planes()[5].point[2];
  const double section = s.lengths()[0] * s.lengths()[1];
  constexpr int layer_count = 5;
  const double height = (high - low) / layer_count;
  const Sampled row = sample(s, "stress", {{"bins", {layer_count}}, {"along", {2}}});
  const double lid = s.loads()[5].force[2];
  REQUIRE(lid > 1);
  double friction = 0;
  for (int layer = 0; layer < layer_count; ++layer) {
    const double from = low + layer * height;
    // The outer layers reach into the walls.
    const auto above = [&](double z) {
      const double part = z - from;
      return std::clamp(part, layer == 0 ? -INFINITY : 0.0, layer == layer_count - 1 ? INFINITY : height);
    };
    double through = lid * height;
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      if (view.contact_b[c] < view.body_count || view.contact_b[c] >= view.body_count + 4) continue;
      const std::uint32_t a = view.contact_a[c];
      through -= view.contact_force[3 * c + 2] * above(view.position[2][a]);
      friction += std::abs(view.contact_force[3 * c + 2]);
    }
    for (std::uint64_t i = 0; i < view.body_count; ++i)
      through += view.force[2][i] * above(view.position[2][i]);
    INFO("layer " << layer);
    CHECK(std::abs(row["zz_" + std::to_string(layer + 1)] * section * height - through) <
          1e-10 * lid * height);
  }
  CHECK(friction > 0.01 * lid);  // the sides take part
}

TEST_CASE("stress: the whole of a packing has the virial of its walls and net forces", "[probe]") {
  Simulation s(pressed_spheres());
  run(s, 4000);
  const SimulationView contacts(s, SCREE_NEEDS_CONTACTS);
  const scree_view& view = contacts.get();
  const Sampled row = sample(s, "stress");
  const double volume = s.lengths()[0] * s.lengths()[1] * s.lengths()[2];
  const char* const names[3] = {"xx", "yy", "zz"};
  for (int k = 0; k < 3; ++k) {
    double virial = 0;
    for (std::uint64_t i = 0; i < view.body_count; ++i) virial += view.force[k][i] * view.position[k][i];
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      if (view.contact_b[c] < view.body_count) continue;
      const std::uint32_t a = view.contact_a[c];
      const scree_plane& plane = view.planes[view.contact_b[c] - view.body_count];
      // The point on the wall below the centre.
      const double at = std::abs(plane.normal[k]) > 0.5 ? plane.point[k] : view.position[k][a];
      virial -= view.contact_force[3 * c + std::uint64_t(k)] * at;
    }
    CHECK(std::abs(row[names[k]] * volume - virial) < 1e-10 * std::abs(virial));
  }
  CHECK(row["p"] == Approx((row["xx"] + row["yy"] + row["zz"]) / 3));
}

TEST_CASE("stress: a scene without walls, and keys that do not fit, are refused", "[probe]") {
  const Simulation s(scene(2, 1e-4, {body(1, 1, 1, {{1, 1.5, 0}}, {}, {}, 2)},
                           {{"normal_stiffness", {5000}}, {"normal_damping", {0}}}));
  const auto refusal = [&](const Values& values) { return error_line([&] { sample(s, "stress", values); }); };
  CHECK_THAT(refusal({}), Catch::Contains("the scene is not enclosed along x; give region = \"box\""));
  CHECK_THAT(refusal({{"region", {1}}, {"lower", {0, 0, 0}}}), Catch::Contains("lacks lower or upper"));
  CHECK_THAT(refusal({{"region", {1}}, {"lower", {0, 0, 0}}, {"upper", {1, 0, 0}}}),
             Catch::Contains("upper is not above lower"));
  CHECK_THAT(refusal({{"region", {2}}}), Catch::Contains("lacks centre or radius"));
  CHECK_THAT(refusal({{"region", {3}}, {"centre", {0, 0, 0}}, {"radius", {1}}}),
             Catch::Contains("2D scene has no cylinders"));
  CHECK_THAT(refusal({{"along", {3}}}), Catch::Contains("shells along = \"radius\" need"));
  CHECK_THAT(refusal({{"along", {2}}}), Catch::Contains("2D scene has no z axis"));
  CHECK_THAT(refusal({{"follow", {1}}}), Catch::Contains("a region that follows a body"));
  CHECK_THAT(refusal({{"lower", {0, 0, 0}}, {"upper", {1, 1, 0}}}),
             Catch::Contains("lower and upper belong to region = \"box\""));
  CHECK_THAT(refusal({{"radius", {1}}}), Catch::Contains("centre and radius belong to region"));
  CHECK_THAT(refusal({{"axis", {0}}}), Catch::Contains("length and axis belong to region = \"cylinder\""));
  CHECK_THAT(refusal({{"radius_low", {1}}}),
             Catch::Contains("radius_low and radius_high belong to region = \"cone\""));
  const Values cone = {{"region", {4}}, {"centre", {0, 0, 0}}, {"radius_low", {1}}, {"radius_high", {0}}};
  CHECK_THAT(refusal(cone), Catch::Contains("2D scene has no cylinders"));
  const Simulation spatial(
      scene(3, 1e-4, {body(1, 1, 1, {{0, 0, 0}})}, {{"normal_stiffness", {5000}}, {"normal_damping", {0}}}));
  const auto refusal_3d = [&](Values values) {
    values.insert(values.begin(), cone.begin(), cone.end());
    return error_line([&] { sample(spatial, "stress", values); });
  };
  CHECK_THAT(refusal_3d({}), Catch::Contains("region = \"cone\" lacks length"));
  CHECK_THAT(refusal_3d({{"length", {1}}, {"radius", {1}}}),
             Catch::Contains("centre and radius belong to region"));
  CHECK_THAT(refusal_3d({{"length", {1}}, {"radius_low", {0}}}),
             Catch::Contains("both radii of the cone are 0"));
  CHECK_THAT(refusal_3d({{"length", {1}}, {"along", {3}}}),
             Catch::Contains("shells along = \"radius\" need"));
  CHECK_THAT(refusal_3d({{"length", {1}}, {"bins", {2}}, {"along", {0}}}),
             Catch::Contains("bins of a cone lie along its axis"));
  Scene drum = spatial.scene();
  add_boundary(drum, "cylinder", {{"point", {0, 0, 0}}, {"axis", {0, 0, 1}}, {"radius", {9}}});
  CHECK_THAT(error_line([&] { sample(Simulation(drum), "stress"); }),
             Catch::Contains("not enclosed along x by planes, and this region does not end at cylinders"));
  CHECK_THAT(refusal({{"region", {2}}, {"centre", {0, 0, 0}}, {"radius", {1e200}}}),
             Catch::Contains("is infinite in the numbers of a computer; give a smaller region"));
  CHECK_THAT(refusal({{"region", {1}}, {"lower", {0, 0, 0}}, {"upper", {1e-200, 1e-200, 0}}}),
             Catch::Contains("is 0 in the numbers of a computer; give a larger region"));
  CHECK_THAT(refusal({{"region", {2}}, {"centre", {0, 0, 0}}, {"radius", {1}}, {"follow", {9}}}),
             Catch::Contains("no body with the id of follow"));
}

TEST_CASE("stress: a sphere follows a body", "[probe]") {
  Scene sc = scene(
      2, 1e-4,
      {body(4, 1, 1, {{1, 1.5, 0}}, {50, 0, 0}, {}, 2), body(2, 1, 2, {{2.98, 1.5, 0}}, {50, 0, 0}, {}, 2)},
      {{"normal_stiffness", {5000}}, {"normal_damping", {0}}});
  sc.limits.speed = 1e3;
  Simulation s(sc);
  run(s, 10);
  const Values near = {{"region", {2}}, {"centre", {0, 0, 0}}, {"radius", {0.5}}, {"follow", {4}}};
  const double distance = position(s, 1)[0] - position(s, 0)[0], force = 5000 * (2 - distance);
  CHECK(sample(s, "stress", near)["xx"] == Approx(force * 0.5 / (3.14159265358979 * 0.25)).epsilon(1e-9));
}
