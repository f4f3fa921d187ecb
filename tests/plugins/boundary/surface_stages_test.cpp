#include "surface_support.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/energy.hpp>
#include <scree/state.hpp>

// Surfaces whose motion stages change or end, and states of surfaces that forces move.

using namespace scree;
using namespace scree::test;

TEST_CASE("between any two controls a surface goes on from where it is, and the balance stays closed",
          "[surfaces]") {
  struct Control {
    Values along, turn;
    double speed, spin;  // at once; NaN: as before
  };
  const double same = std::nan("");
  const Control controls[] = {{{{"control", {at_rest}}}, {{"spin_control", {spin_at_rest}}}, 0, 0},
                              {{{"control", {by_displacement}}, {"displacement", {3, 0.5, 0.7, 0.1}}},
                               {{"spin_control", {by_angle}}, {"angle", {3, 0, 0.3, 0.1}}},
                               2,
                               3},
                              {{{"control", {by_velocity}}, {"velocity", {0, -3}}},
                               {{"spin_control", {by_spin}}, {"spin", {0, 5}}},
                               -3,
                               5},
                              {{{"control", {by_force}}, {"force", {0, -30}}},
                               {{"spin_control", {by_torque}}, {"torque", {0, 0.1}}, {"inertia", {0.02}}},
                               same,
                               same}};
  for (const Control& before : controls)
    for (const Control& after : controls) {
      Scene sc = far_body(1e-4);
      add_boundary(sc, "disc", together(plate, together(before.along, before.turn)));
      Simulation s(sc);
      run(s, 200);
      const scree_frame old = frame(s);
      reconfigure(s, "disc", together(plate, together(after.along, after.turn)));
      CHECK(frame(s).position[2] == old.position[2]);
      CHECK(frame(s).orientation[3] == old.orientation[3]);
      CHECK(frame(s).velocity[2] == Approx(std::isnan(after.speed) ? old.velocity[2] : after.speed));
      CHECK(frame(s).spin[2] == Approx(std::isnan(after.spin) ? old.spin[2] : after.spin));
      run(s, 200);
      // Round-off of 400 terms of 9 J.
      CHECK(std::abs(s.energy().residual) < 9 * 400 * 2 * unit_round_off);
    }
}

TEST_CASE("a stage that changes the directions of a surface keeps the parts of its speeds along them",
          "[surfaces]") {
  Scene sc = far_body(1e-4);
  const Values spun = together(plate, {{"force", {0, 4}}, {"torque", {0, 0.1}}, {"inertia", {0.02}}});
  add_boundary(sc, "disc", spun);
  Simulation s(sc);
  run(s, 500);
  const double speed = 4 / disc_mass * s.time(), spin = 0.1 / 0.02 * s.time();
  CHECK(frame(s).velocity[2] == Approx(speed));
  reconfigure(s, "disc", together(spun, {{"direction", {0, 3, 4}}, {"spin_axis", {0, 0.8, -0.6}}}));
  CHECK(frame(s).velocity[1] == Approx(0.8 * speed * 0.6));
  CHECK(frame(s).velocity[2] == Approx(0.8 * speed * 0.8));
  CHECK(frame(s).spin[1] == Approx(-0.6 * spin * 0.8));
  CHECK(frame(s).spin[2] == Approx(0.6 * spin * 0.6));
  // The energy of the other parts is taken away as work: the balance stays closed.
  run(s, 100);
  CHECK(std::abs(s.energy().residual) < 600 * 2 * unit_round_off);
}

TEST_CASE("a superposed motion that ends leaves the motion by forces as it is", "[surfaces]") {
  const Values pushed = {{"force", {0, 4}}, {"torque", {0, 0.1}}, {"inertia", {0.02}}};
  const Values shaken = {{"superposed", {1, 0, 0.01, 30, 0}}, {"superposed_angle", {1, 0, 0.1, 20, 0}}};
  Scene sc = far_body(1e-4);
  add_boundary(sc, "disc", together(plate, together(pushed, shaken)));
  Simulation s(sc);
  run(s, 530);
  const double speed = 4 / disc_mass * s.time(), spin = 0.1 / 0.02 * s.time();
  REQUIRE(std::abs(frame(s).velocity[2] - speed) > 0.1);
  REQUIRE(std::abs(frame(s).spin[2] - spin) > 0.1);
  reconfigure(s, "disc", together(plate, pushed));
  // A constant acceleration is exact; round-off of 530 steps.
  CHECK(frame(s).velocity[2] == Approx(speed).epsilon(1e-12));
  CHECK(frame(s).spin[2] == Approx(spin).epsilon(1e-12));
}

TEST_CASE("surfaces that forces move go on from a state to the same bits", "[surfaces]") {
  for (const Integration integration :
       {Integration::velocity_verlet, Integration::position_verlet, Integration::fourth_order}) {
    std::vector<Body> bodies;
    for (int i = 0; i < 6; ++i)
      bodies.push_back(body(i + 1, 0.05, 0.1, {{0.11 * (i % 3) - 0.11, 0.11 * (i / 3) - 0.05, 0.06}}));
    Scene sc = scene(3, 1e-5, bodies,
                     {{"normal_stiffness", {1e5}},
                      {"restitution", {0.7}},
                      {"tangential_stiffness", {3e4}},
                      {"static_friction", {0.4}}});
    sc.integration = integration;
    add_boundary(sc, "disc",
                 together(plate, {{"force", {0, 3}},
                                  {"superposed", {1, 0, 1e-3, 20, 0}},
                                  {"torque", {0, 0.2}},
                                  {"inertia", {0.02}}}));
    add_body_force(sc, "gravity", {{"acceleration", {0.5, 0, -9.81}}});
    Simulation whole(sc), first(sc);
    run(whole, 6000);
    run(first, 2300);
    Simulation second(sc, first.state());
    run(second, 3700);
    CHECK(second.state_hash() == whole.state_hash());
  }
}

TEST_CASE("a surface that is absent bears nothing, and comes back before bodies have passed", "[surfaces]") {
  Scene sc = scene(3, 1e-4, {body(1, 0.1, 1, {{0, 0, 0.1 - 10 / stiffness}})},
                   {{"normal_stiffness", {stiffness}}, {"normal_damping", {20}}});
  const Values lid = {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {0.2}}, {"side", {1}}};
  const Values absent_lid = together(lid, {{"control", {left_out}}});
  add_boundary(sc, "disc", lid);
  add_body_force(sc, "gravity", {{"acceleration", {0, 0, -10}}});
  Simulation s(sc);
  run(s, 10);
  CHECK(s.surfaces().loads[0].force[2] == Approx(-10));
  reconfigure(s, "disc", absent_lid);
  CHECK(s.absent_walls()[0]);
  CHECK(s.surfaces().loads[0].force[2] == 0);
  run(s, 500);
  CHECK(position(s, 0)[2] == Approx(0.1 - 10 / stiffness - 0.0125).epsilon(1e-11));
  reconfigure(s, "disc", lid);  // the centre is still above
  run(s, 10);
  CHECK(s.surfaces().loads[0].force[2] < 0);
  reconfigure(s, "disc", absent_lid);
  run(s, 3000);
  REQUIRE(position(s, 0)[2] < 0);
  CHECK_THROWS_WITH(reconfigure(s, "disc", lid), Catch::Contains("with the centre of 1 body behind it"));
  // Nothing moves it.
  reconfigure(s, "disc", together(absent_lid, {{"spin", {0, 5}}, {"spin_axis", {1, 0, 0}}}));
  run(s, 10);
  CHECK(frame(s).orientation[0] == 1);
  // From the start, with bodies behind.
  Scene below = sc;
  below.boundaries.clear();
  below.bodies[0].position[2] = -1;
  add_boundary(below, "disc", absent_lid);
  Simulation passing(below);
  run(passing, 10);
  CHECK(position(passing, 0)[2] < -1);
}
