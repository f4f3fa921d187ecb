#include "scenes.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const Values soft_law = {{"normal_stiffness", {5000}}, {"normal_damping", {0.5}}};

// Wall order of the box plug-in.
enum { x_low, x_high, y_low, y_high, z_low, z_high };

const scree_plane& wall(const Simulation& s, int w) { return s.planes()[std::size_t(w)]; }
double force_on(const Simulation& s, int w) { return s.loads()[std::size_t(w)].force[w / 2]; }

// A small sphere in the middle of a cube of this edge, touching nothing.
Scene empty_box(double edge, double step, const Values& box, int dimension = 3) {
  Scene sc = scene(dimension, step, {body(1, 0.001, 1e-3, {}, {}, {}, dimension)}, soft_law);
  Values values = {{"lower", {-edge / 2, -edge / 2, -edge / 2}}, {"upper", {edge / 2, edge / 2, edge / 2}}};
  values.insert(values.end(), box.begin(), box.end());
  add_boundary(sc, "box", values);
  return sc;
}

}  // namespace

TEST_CASE("a stress-controlled wall obeys m s'' = p A − γ s'", "[box]") {
  // One wall moves, the others are fixed, so that its area stays L².
  const double edge = 0.1, m = 2, gamma = 200, p = 1000, step = 1e-5;
  Simulation s(empty_box(edge, step,
                         {{"mass", {m}},
                          {"viscosity", {gamma}},
                          {"stress", {0, p}},
                          {"x_low", {1}},
                          {"y_low", {1}},
                          {"y_high", {1}},
                          {"z_low", {1}},
                          {"z_high", {1}}}));
  run(s, 2000);
  const double terminal = p * edge * edge / gamma, rate = gamma / m, t = s.time();
  const double distance = terminal * (t - (1 - std::exp(-rate * t)) / rate);
  // Step error: (γΔt/m)² / 12 = 1e-7 relative.
  CHECK(edge / 2 - wall(s, x_high).point[0] == Approx(distance).epsilon(1e-6));
  CHECK(-wall(s, x_high).velocity[0] == Approx(terminal * (1 - std::exp(-rate * t))).epsilon(1e-6));
  CHECK(wall(s, x_low).point[0] == -edge / 2);
}

TEST_CASE("all walls close at once, each pressing on its present area", "[box]") {
  const double step = 1e-4;
  Simulation s(empty_box(0.1, step, {{"mass", {0.01}}, {"viscosity", {200}}, {"stress", {0, 1000}}}));
  run(s, 2000);
  // A light wall is in its viscous limit: dL/dt = −2 p L²/γ, so 1/L = 1/L0 + 2 p t/γ.
  const double expected = 1 / (1 / 0.1 + 2 * 1000 * s.time() / 200);
  for (int k = 0; k < 3; ++k) {
    const double length = wall(s, 2 * k + 1).point[k] - wall(s, 2 * k).point[k];
    // The inertia delays the start by m/γ = 5e-5 s, Δt has the same size: together 2e-4 s of 10 /s · t, 1e-3
    // of L.
    CHECK(length == Approx(expected).epsilon(1e-3));
    CHECK(wall(s, 2 * k).point[k] == Approx(-wall(s, 2 * k + 1).point[k]).epsilon(1e-12));
  }
}

TEST_CASE("at rest the contacts carry the stress of every wall, programmed ones too", "[box]") {
  // One sphere in a box of its size: k δ = p A on each axis.
  const double k = 5000, step = 1e-5;
  Scene sc = scene(3, step, {body(1, 0.005, 1e-3, {})}, soft_law);
  add_boundary(sc, "box",
               {{"mass", {0.02}},
                {"viscosity", {20}},
                {"stress", {0, 1000}},
                {"stress_y", {0, 2000}},
                {"stress_z", {3, 1000, 500, 0.05}}});
  add_body_force(sc, "background_damping", {{"translational", {0.5}}});
  Simulation s(sc);
  run(s, 60000);
  const double length[3] = {wall(s, x_high).point[0] - wall(s, x_low).point[0],
                            wall(s, y_high).point[1] - wall(s, y_low).point[1],
                            wall(s, z_high).point[2] - wall(s, z_low).point[2]};
  const double stress[3] = {1000, 2000, 500};
  for (int a = 0; a < 3; ++a) {
    const double area = length[(a + 1) % 3] * length[(a + 2) % 3];
    // 0.6 s are 60 relaxation times of the slowest mode, γ/k = 4e-3 s: the remainder is below e^-60, less
    // than round-off.
    CHECK(force_on(s, 2 * a + 1) == Approx(stress[a] * area).epsilon(1e-9));
    CHECK(-force_on(s, 2 * a) == Approx(stress[a] * area).epsilon(1e-9));
    CHECK(0.01 - length[a] == Approx(2 * stress[a] * area / k).epsilon(1e-9));
  }
}

TEST_CASE("zero is a legal stress", "[box]") {
  Simulation s(empty_box(0.1, 1e-4, {{"mass", {1}}, {"stress", {0, 0}}}));
  run(s, 100);
  CHECK(wall(s, x_high).point[0] == 0.05);
}

TEST_CASE("in 2D a wall's area is its length, 1 m deep", "[box]") {
  Simulation s(empty_box(0.1, 1e-5,
                         {{"mass", {1}},
                          {"viscosity", {0}},
                          {"stress", {0, 7}},
                          {"x_low", {1}},
                          {"y_low", {1}},
                          {"y_high", {1}}},
                         2));
  REQUIRE(s.planes().size() == 4);
  run(s, 100);
  // Uniform acceleration is exact in velocity Verlet.
  CHECK(-wall(s, x_high).velocity[0] == Approx(7 * 0.1 / 1 * s.time()).epsilon(1e-12));
}

TEST_CASE("the work of the walls and their viscosity close the energy balance", "[box]") {
  Simulation s(empty_box(0.1, 1e-5, {{"mass", {2}}, {"viscosity", {200}}, {"stress", {0, 1000}}}));
  run(s, 3000);
  const scree_energy e = s.energy();
  CHECK(e.work > 0);
  CHECK(e.dissipated_boundary > 0);
  // Step error of the trapezoidal sums: (γΔt/m)²/12 = 1e-7 of the energies transferred.
  CHECK(std::abs(e.residual) < 1e-6 * e.work);
}

TEST_CASE("a box without stress, inside out, or without bodies is refused", "[box]") {
  CHECK_THROWS_WITH(Simulation(empty_box(0.1, 1e-4, {})), Catch::Contains("stress"));
  CHECK_THROWS_WITH(Simulation(empty_box(-0.1, 1e-4, {{"stress", {0, 1}}})), Catch::Contains("upper"));
  Scene none = scene(3, 1e-4, {}, soft_law);
  add_boundary(none, "box", {{"stress", {0, 1}}});
  CHECK_THROWS_WITH(Simulation(none), Catch::Contains("corners"));
}

TEST_CASE("each corner of a box is used if given, and else encloses the bodies with the gap", "[box]") {
  const auto limits = [](const Values& corners) {
    Scene sc =
        scene(3, 1e-4,
              {body(1, 0.001, 1e-3, {{-0.02, -0.02, -0.02}}), body(2, 0.001, 1e-3, {{-0.01, -0.01, -0.01}})},
              soft_law);
    Values values = {{"x", {1}}, {"y", {1}}, {"z", {1}}, {"gap", {0.005}}};
    values.insert(values.end(), corners.begin(), corners.end());
    add_boundary(sc, "box", values);
    Simulation s(sc);
    return std::pair{s.planes()[x_low].point[0], s.planes()[z_high].point[2]};
  };
  const Values lower = {{"lower", {-0.05, -0.05, -0.05}}}, upper = {{"upper", {0, 0, 0}}};
  CHECK(limits({}) == std::pair{-0.02 - 0.001 - 0.005, -0.01 + 0.001 + 0.005});
  CHECK(limits(lower) == std::pair{-0.05, -0.01 + 0.001 + 0.005});
  CHECK(limits(upper) == std::pair{-0.02 - 0.001 - 0.005, 0.0});
  CHECK(limits({lower[0], upper[0]}) == std::pair{-0.05, 0.0});
  CHECK_THROWS_WITH(limits({{"lower", {-0.05, -0.05, 0}}, upper[0]}),
                    Catch::Contains("upper is not above lower"));
  CHECK_THROWS_WITH(limits({{"lower", {0, 0, 0}}}), Catch::Contains("upper is not above lower"));
}
