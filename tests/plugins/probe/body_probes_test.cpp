#include "probe_support.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/probes.hpp>

// walls, contact and body_energy: the probes of two-body scenes.

using namespace scree;
using namespace scree::test;

namespace {

constexpr double sphere_radius = 0.005, sphere_mass = 1e-3, sphere_stiffness = 5000, sphere_friction = 0.3;

const Values sphere_law = {{"normal_stiffness", {sphere_stiffness}},
                           {"normal_damping", {0}},
                           {"tangential_stiffness", {1000}},
                           {"static_friction", {sphere_friction}}};

struct Recorder {
  Recorder(const Simulation& s, const std::string& plugin, const Values& values)
      : probe(parameters(plugin, SCREE_PROBE, values), s.dimension()) {
    sample(s);
  }
  void sample(const Simulation& s) { row = probe.sample(SimulationView(s, probe.needs()).get()); }
  double operator[](const std::string& name) const {
    const std::vector<std::string> names = probe.names();
    const auto at = std::find(names.begin(), names.end(), name);
    INFO(name);
    REQUIRE(at != names.end());
    return row[std::size_t(at - names.begin())];
  }
  Probe probe;
  std::vector<double> row;
};

// Body 7 overlaps the floor by 2e-4 m, body 3 touches it from the side and slightly above; body 5 floats
// free.
Scene corner() {
  Scene s =
      scene(3, 1e-5,
            {body(7, sphere_radius, sphere_mass, {{0, 0, sphere_radius - 2e-4}}, {{1, 0, 0}}, {{0, -200, 0}}),
             body(3, sphere_radius, sphere_mass, {{0, 2 * sphere_radius - 1e-4, sphere_radius + 1e-4}}),
             body(5, sphere_radius, sphere_mass, {{1, 1, 1}})},
            sphere_law);
  add_boundary(s, "plane", {{"point", {0, 0, -1}}, {"normal", {0, 0, 2}}}, "cellar");
  add_boundary(s, "plane", {{"point", {3, 4, 0}}, {"normal", {0, 0, 1}}}, "floor");
  return s;
}

}  // namespace

TEST_CASE("contact: overlap, forces and normal in the order of the parameters", "[probe]") {
  const Simulation s(corner());
  const Recorder c(s, "contact", {{"pairs", {3, 7, 7, 3, 5, 7}}, {"at_walls", {7, 2, 3, 2}}});
  const double distance = std::hypot(2 * sphere_radius - 1e-4, 3e-4), overlap = 2 * sphere_radius - distance;
  CHECK(c["overlap_3_7"] == Approx(overlap));
  CHECK(c["normal_force_3_7"] == Approx(sphere_stiffness * overlap));
  CHECK(c["normal_y_3_7"] == Approx((2 * sphere_radius - 1e-4) / distance));
  CHECK(c["normal_z_7_3"] == Approx(-3e-4 / distance));
  CHECK(c["overlap_7_wall2"] == Approx(2e-4));
  CHECK(c["normal_force_7_wall2"] == Approx(sphere_stiffness * 2e-4));
  CHECK(c["tangential_force_7_wall2"] == 0);
  CHECK(c["normal_z_7_wall2"] == 1);
  for (const char* open : {"overlap_5_7", "normal_force_5_7", "normal_x_5_7", "overlap_3_wall2"})
    CHECK(c[open] == 0);
}

TEST_CASE("contact and walls: a sliding body exerts the friction of its normal force", "[probe]") {
  Simulation s(corner());
  run(s, 40);  // displaced by at least 4e-4 m, 1.3 times the spring at slip
  const Recorder c(s, "contact", {{"at_walls", {7, 2}}});
  CHECK(c["sliding_7_wall2"] == 1);
  CHECK(c["tangential_force_7_wall2"] == Approx(sphere_friction * c["normal_force_7_wall2"]));
  const Recorder w(s, "walls", {{"walls", {2, 1}}});
  CHECK(w["normal_force_2"] == Approx(c["normal_force_7_wall2"]));
  CHECK(w["tangential_force_2"] == Approx(c["tangential_force_7_wall2"]));
  CHECK(w["normal_force_1"] == 0);
}

TEST_CASE("contact: a body at surfaces, beside planes and other bodies", "[probe]") {
  Scene s = corner();
  add_boundary(s, "disc", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {1}}, {"control", {5}}},
               "away");
  // Body 3 overlaps the rectangle by 3e-4 m from the side.
  const double beside = 3 * sphere_radius - 4e-4;
  add_boundary(s, "rectangle",
               {{"point", {0, beside, 0}},
                {"normal", {0, -1, 0}},
                {"along", {1, 0, 0}},
                {"length", {1}},
                {"width", {1}}},
               "side");
  const Simulation at_rest(s);
  const Recorder c(at_rest, "contact",
                   {{"pairs", {3, 7}}, {"at_walls", {7, 2}}, {"at_surfaces", {3, 2, 7, 1, 7, 2}}});
  CHECK(c["overlap_3_surface2"] == Approx(3e-4));
  CHECK(c["normal_force_3_surface2"] == Approx(sphere_stiffness * 3e-4));
  CHECK(c["normal_y_3_surface2"] == -1);
  CHECK(c["overlap_7_wall2"] == Approx(2e-4));
  CHECK(c["normal_z_7_wall2"] == 1);
  CHECK(c["overlap_3_7"] > 0);
  for (const char* open : {"overlap_7_surface1", "overlap_7_surface2", "normal_y_7_surface2"})
    CHECK(c[open] == 0);
  CHECK_THROWS_WITH(Recorder(at_rest, "contact", {{"at_surfaces", {3, 3}}}),
                    Catch::Contains("surface 3 does not exist"));
  CHECK_THROWS_WITH(Recorder(at_rest, "contact", {{"at_surfaces", {4, 1}}}),
                    Catch::Contains("id 4 does not exist"));
}

TEST_CASE("contact: of several spots on a mesh, the deepest", "[probe]") {
  // Two faces at a right angle, one triangle each; the body lies deeper in the second one.
  Scene s = scene(3, 1e-5, {body(1, 0.1, 1, {{0.095, 0.098, 0}})}, sphere_law);
  const std::vector<double> corner_of_faces = {6, 0, 0, -9, 0, 0, 9, 0, 9, 0, 0, 0, -9,
                                               9, 0, 0, 0,  0, 9, 0, 2, 1, 3, 4, 5};
  add_boundary(s, "mesh", {{"file", corner_of_faces}});
  const Simulation at_rest(s);
  REQUIRE(at_rest.contact_list().size() == 2);
  const Recorder c(at_rest, "contact", {{"at_surfaces", {1, 1}}});
  CHECK(c["overlap_1_surface1"] == Approx(0.005));
  CHECK(c["normal_x_1_surface1"] == Approx(1));
}

TEST_CASE("walls: position and velocity along the normal of a moving wall", "[probe]") {
  Scene moving = corner();
  add_boundary(moving, "plane",
               {{"point", {2, 0, 0}}, {"normal", {-1, 0, 0}}, {"displacement", {3, 0, 0.5, 10}}}, "piston");
  Simulation s(moving);
  Recorder w(s, "walls", {{"walls", {3}}});
  CHECK(w["position_3"] == -2);
  run(s, 10);
  w.sample(s);
  CHECK(w["position_3"] == Approx(-2 + 0.05 * 10 * 1e-5).epsilon(1e-12));
  CHECK(w["velocity_3"] == Approx(0.05));
}

TEST_CASE("walls: a wall that is driven along itself shows its displacement and its load, with their signs",
          "[probe]") {
  for (const int dimension : {2, 3}) {
    // The wall rubs at 0.05 m/s under a body that is pressed upon it: friction drags the body along.
    Scene driven = scene(
        dimension, 1e-5,
        {body(1, sphere_radius, sphere_mass, {{0, sphere_radius - 1e-4, 0}}, {}, {}, dimension)}, sphere_law);
    add_boundary(driven, "plane",
                 {{"point", {0, 0, 0}},
                  {"normal", {0, 1, 0}},
                  {"direction", {-1, 0, 0}},
                  {"displacement", {3, 0, 0.5, 10}}});
    Simulation s(driven);
    Recorder w(s, "walls", {{"walls", {1}}});
    CHECK(w.row.size() == std::size_t(4 + 2 * dimension));
    CHECK(w["displacement_x_1"] == 0);
    CHECK(w["force_y_1"] == Approx(-sphere_stiffness * 1e-4));
    run(s, 10);
    w.sample(s);
    CHECK(w["displacement_x_1"] == Approx(-0.05 * 10 * 1e-5).epsilon(1e-12));
    CHECK(w["displacement_y_1"] == 0);
    CHECK(w["position_1"] == 0);
    CHECK(w["force_x_1"] == w["tangential_force_1"]);  // against the motion, towards +x
    CHECK(w["force_x_1"] > 0);
    CHECK(w["force_y_1"] == -w["normal_force_1"]);
  }
}

TEST_CASE("contact: in 2D the normal has two components", "[probe]") {
  Scene scene2 = scene(
      2, 1e-5, {body(1, sphere_radius, sphere_mass, {{0, sphere_radius - 1e-4, 0}}, {}, {}, 2)}, sphere_law);
  add_boundary(scene2, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  const Simulation s(scene2);
  const Recorder c(s, "contact", {{"at_walls", {1, 1}}});
  CHECK(c.row.size() == 6);
  CHECK(c["normal_y_1_wall1"] == 1);
}

TEST_CASE("contact: in 2D the tangential force has a sign, the same for both orders of the bodies",
          "[probe]") {
  for (const double side : {1.0, -1.0}) {
    // Body 1 slides over body 2 towards ± x; with n = (0, 1) and t = z × n = (−1, 0), friction on body 1 is ±
    // along t.
    Simulation s(
        scene(2, 1e-5,
              {body(1, sphere_radius, sphere_mass, {{0, 2 * sphere_radius - 1e-4, 0}}, {{side, 0, 0}}, {}, 2),
               body(2, sphere_radius, sphere_mass, {{0, 0, 0}}, {}, {}, 2)},
              sphere_law));
    run(s, 5);
    const Recorder c(s, "contact", {{"pairs", {1, 2, 2, 1}}});
    CHECK(side * c["tangential_force_1_2"] > 0);
    CHECK(c["tangential_force_2_1"] == c["tangential_force_1_2"]);
  }
}

TEST_CASE("body_energy: the remaining fraction of translational and rotational energy", "[probe]") {
  for (const int dimension : {2, 3}) {
    const double gyration = dimension == 2 ? 0.5 : 0.4;
    const auto of = [&](double v, double spin) {
      return v * v + gyration * sphere_radius * sphere_radius * spin * spin;
    };
    Simulation s(
        scene(dimension, 1e-5,
              {body(1, sphere_radius, sphere_mass, {{0, 0, 0}}, {{2, 0, 0}}, {{0, 0, 300}}, dimension),
               body(2, sphere_radius, sphere_mass, {{1, 0, 0}}, {{1, 0, 0}}, {}, dimension)},
              sphere_law));
    Scene faster = s.scene();
    faster.bodies[0].velocity = {{1, 0, 0}};
    faster.bodies[1].velocity = {{3, 0, 0}};
    Recorder e(s, "body_energy", {{"ids", {2, 1}}});
    CHECK(e["largest_ratio"] == 1);
    e.sample(Simulation(faster));
    CHECK(e["ratio_1"] == Approx(of(1, 300) / of(2, 300)));
    CHECK(e["ratio_2"] == Approx(9));
    CHECK(e["smallest_ratio"] == e["ratio_1"]);
    CHECK(e["largest_ratio"] == e["ratio_2"]);
  }
}

TEST_CASE("body probes: an id above 1e15 is refused, because doubles tell larger ones apart no more",
          "[probe]") {
  const Simulation s(corner());
  for (const std::string probe : {"particles", "difference", "body_energy", "mean_squared_displacement"})
    CHECK_THROWS_WITH(sample(s, probe, {{"ids", {9007199254740993.0, 3}}}),
                      Catch::Contains("from 1 to 1e+15"));
  CHECK_THROWS_WITH(sample(s, "contact", {{"pairs", {9007199254740993.0, 3}}}),
                    Catch::Contains("from 1 to 1e+15"));
}

TEST_CASE("body probes: a body listed twice is refused, because its columns would have the same names",
          "[probe]") {
  const Simulation s(corner());
  CHECK_THROWS_WITH(
      sample(s, "particles", {{"ids", {3, 7, 3}}}),
      "plug-in particles: two columns are named 'x_3'; list every body, pair, wall or surface once");
}

TEST_CASE("body probes: missing bodies and walls are refused", "[probe]") {
  const Simulation s(corner());
  const auto refusal = [&](const std::string& plugin, const Values& values, const std::string& says) {
    CHECK_THROWS_WITH(Recorder(s, plugin, values), Catch::Contains(says));
  };
  refusal("contact", {{"pairs", {3, 8}}}, "id 8 does not exist; bodies without an id are numbered from 1");
  refusal("contact", {{"pairs", {3, 3}}}, "twice");
  refusal("contact", {{"pairs", {3, 7, 5}}}, "odd number");
  refusal("contact", {}, "no contact is selected");
  refusal("contact", {{"at_walls", {3, 3}}}, "wall 3 does not exist; the scene has 2");
  refusal("contact", {{"at_walls", {4, 1}}}, "id 4 does not exist");
  refusal("walls", {{"walls", {1.5}}}, "wall 1.5 does not exist");
  refusal("walls", {{"walls", {2, 3}}}, "wall 3 does not exist");
  refusal("particles", {{"ids", {7, 3.5}}}, "id 3.5 does not exist");
  refusal("body_energy", {{"ids", {9}}}, "id 9 does not exist");
  refusal("body_energy", {{"ids", {7, 5}}}, "body 5 is at rest");
}
