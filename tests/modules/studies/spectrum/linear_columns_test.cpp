#include "linear_columns.hpp"

#include "chain.hpp"
#include "harmonic_motion.hpp"

#include <numbers>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/wall_surfaces.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

TEST_CASE("a column of a position follows the motion of its body, and one of a velocity is iω times that",
          "[spectrum]") {
  const scenario::Plan plan = driven_plan_of(
      with(Chain().text("from_hz = 20\nto_hz = 160\nstep_hz = 20\n"), "'particles.z_1'", "'particles.vz_8'"));
  const auto spectrum = read_spectrum(plan);
  REQUIRE(spectrum);
  REQUIRE(spectrum->observed[0].name == "particles.vz_8");
  REQUIRE(spectrum->observed[1].name == "particles.z_8");
  const auto simulation = run::set_up(plan);
  const std::vector<Vec3> walls = {Vec3{{0, 0, 1}}};
  const double hz = 60;
  const HarmonicMotion motion = harmonic_motion(*simulation, walls, {hz}, {.fewest_contacts = 1}, {});
  LinearColumns columns(plan, spectrum->observed, *simulation, walls, motion.freedom, 0);
  CHECK(columns.at_rest()[0] == 0);
  CHECK(columns.at_rest()[1] == simulation->particles().position()[2][7]);
  const auto [derivatives, change] = columns.along(motion.responses[0]);
  const std::complex<double> bead = motion.responses[0].amplitude[motion.freedom.translation(7, 2)];
  // Differences of 1e-3 radii at 0.08 m leave 1e-11 of round-off.
  CHECK(std::abs(derivatives[1] - bead) < 1e-9 * std::abs(bead));
  CHECK(std::abs(derivatives[0] - std::complex<double>(0, 2 * std::numbers::pi * hz) * bead) <
        1e-9 * std::abs(derivatives[0]));
  for (std::size_t c = 0; c < 2; ++c) CHECK(change[c] < 1e-9 * std::abs(derivatives[c]));
}

TEST_CASE("columns of energies and contacts are none of motion alone", "[spectrum]") {
  const scenario::Plan plan = driven_plan_of(Chain().text("from_hz = 20\nto_hz = 160\nstep_hz = 20\n") +
                                             "[[probe]]\nplugin = 'energy'\n" + Chain::layers);
  REQUIRE(plan.probes.size() == 3);
  CHECK(is_of_motion(plan, 0));
  CHECK_FALSE(is_of_motion(plan, 1));
}

TEST_CASE("derived columns of positions follow the motion, those of what observes the run are refused",
          "[spectrum]") {
  const std::string text = with(Chain().text("from_hz = 20\nto_hz = 160\nstep_hz = 20\n"),
                                "'particles.z_1', 'particles.z_8'", "'derived.stretch', 'particles.z_8'");
  const std::string stretch = "[derived]\nstretch = '3 * (particles.z_8 - particles.z_1)'\n";
  const scenario::Plan plan = driven_plan_of(text + stretch);
  CHECK(is_of_motion(plan, 1));
  const auto spectrum = read_spectrum(plan);
  const auto simulation = run::set_up(plan);
  const std::vector<Vec3> walls = {Vec3{{0, 0, 1}}};
  const HarmonicMotion motion = harmonic_motion(*simulation, walls, {60}, {.fewest_contacts = 1}, {});
  LinearColumns columns(plan, spectrum->observed, *simulation, walls, motion.freedom, 0);
  const auto derivatives = columns.along(motion.responses[0]).first;
  const auto bead = [&](std::size_t k) {
    return motion.responses[0].amplitude[motion.freedom.translation(k, 2)];
  };
  // As above.
  CHECK(std::abs(derivatives[0] - 3.0 * (bead(7) - bead(0))) < 3e-9 * std::abs(bead(7)));
  CHECK_FALSE(is_of_motion(
      driven_plan_of(text + with(stretch, "3 *", "energy.work *") + "[[probe]]\nplugin = 'energy'\n"), 2));
  CHECK(message([&] {
          driven_plan_of(
              text + with(stretch, "3 *", "lock_in.mean *") +
              "[[probe]]\nplugin = 'lock_in'\nof = 'particles.z_8'\nfrequency_hz = 10\nperiods = 3\n");
        }).find("'derived.stretch' depends on all steps, not on the present state") != std::string::npos);
}

// The axis is beside the origin of the frame.
TEST_CASE("surfaces that turn have places, velocities and spins in columns", "[spectrum][surfaces]") {
  Scene scene = test::scene(3, 1e-4, {body(1, 0.3, 1, {{1, 0, -0.29}})},
                            {{"normal_stiffness", {1e3}},
                             {"normal_damping", {0}},
                             {"tangential_stiffness", {500}},
                             {"static_friction", {1}}});
  scene.bodies[0].fixed = true;
  add_boundary(scene, "disc",
               {{"point", {0.5, 0, 0}},
                {"normal", {0, 0, -1}},
                {"radius", {2}},
                {"torque", {0}},
                {"inertia", {1}},
                {"spin_axis", {0, 0, 1}},
                {"spin_point", {0.2, 0, 0}}});
  const Simulation simulation(scene);
  const response::DegreesOfFreedom freedom(3, 3, {false}, {false}, {false}, {}, {true});
  const response::HarmonicResponse motion = {3, Eigen::VectorXcd::Constant(1, 2e-3), 0, 0};
  const std::vector<Vec3> walls(1);
  DisplacedView view(simulation, walls, freedom, 0);
  const scree_frame before = view.at_rest().frames[0];
  const scree_frame turned = view.displaced(motion, DisplacedView::Part::real, 1).frames[0];
  const auto angle = [](const scree_frame& frame) { return rotation_of(frame)(Vec3{{1, 0, 0}}); };
  // Turned by 2e-3 about z, of first order in place.
  CHECK(angle(turned)[1] - angle(before)[1] == Approx(2e-3 * angle(before)[0]).epsilon(1e-5));
  CHECK(turned.position[1] == Approx(0.3 * 2e-3));
  CHECK(turned.spin[2] == Approx(0).margin(1e-15));
  const scree_frame moving = view.displaced(motion, DisplacedView::Part::imaginary, 1).frames[0];
  const double spin = 2 * std::numbers::pi * 3 * 2e-3;  // −i iω φ
  CHECK(moving.spin[2] == Approx(spin));
  CHECK(moving.velocity[1] == Approx(0.3 * spin));
  CHECK(moving.position[1] == 0);
}
