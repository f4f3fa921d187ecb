#include "prepared.hpp"
#include "static/column.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/response/quasi_static.hpp>

// Paths through states of equilibrium.

namespace scree::test {

namespace {

using response::QuasiStatic;

double length(const std::vector<scree_plane>& box, int k) {
  return box[std::size_t(2 * k + 1)].point[k] - box[std::size_t(2 * k)].point[k];
}

// L_y/L_y0 − L_x/L_x0
double strain(const std::vector<scree_plane>& box, const std::vector<scree_plane>& before) {
  return length(box, 1) / length(before, 1) - length(box, 0) / length(before, 0);
}

}  // namespace

// The strain that dynamics leave after a cycle approaches that of the quasi-static solver as the period
// grows.
TEST_CASE("slow cycles end in the strain of the quasi-static solver") {
  const auto prepared = [](double period) {
    return Prepared(box_of_discs, {"scene.seed=5", fmt::format("stage.cycles.period={}", period),
                                   fmt::format("stage.cycles.set.box.stress_y_high.period={}", period)});
  };
  const auto by_dynamics = [&](double period) {
    const Prepared p = prepared(period);
    const std::vector<scree_plane> before = p.simulation->planes();
    const auto steps = std::uint64_t(std::llround(period / p.simulation->step_length()));
    p.simulation->run(steps, [] { return true; });
    return strain(p.simulation->planes(), before);
  };
  const Prepared p = prepared(10);
  const double start = p.simulation->time();
  const auto without_dynamics = [&](int increments) {
    QuasiStatic packing(*p.simulation, {.longest_increment = 10.0 / increments});
    REQUIRE(packing.advance(start));
    const std::vector<scree_plane> before = packing.planes();
    REQUIRE(packing.advance(start + 10));
    return strain(packing.planes(), before);
  };
  const double exact = without_dynamics(160);
  const double at_20 = by_dynamics(20) - exact, at_40 = by_dynamics(40) - exact,
               at_80 = by_dynamics(80) - exact;
  INFO(exact << ": " << at_20 << ' ' << at_40 << ' ' << at_80);
  // Viscosity leaves a lag in proportion to the rate, inertia one to its square.
  CHECK(std::abs(at_40) < 0.6 * std::abs(at_20));
  CHECK(std::abs(at_80) < 0.6 * std::abs(at_40));
  // An eighth of the rate leaves at most an eighth of the lag.
  CHECK(std::abs(at_80) < 0.125 * std::abs(by_dynamics(10) - exact));
  // In packing 5 contacts slide; what an elastic packing keeps of a cycle is round-off of lengths.
  CHECK(std::abs(exact) > 1e-12);
}

// Four discs. In each cycle slip of one contact ends where that of another begins, in the middle of an
// increment. The numbers are those of a reference without the kernel: rate equations K dq = dP with the
// contacts that stick and slide, Runge-Kutta steps in the load, events located.
TEST_CASE("slip that ends within an increment leaves the strain of a reference") {
  const std::string plan =
      "particle = [\n"
      "{ position = [0.15150859929783628, 0.1546291580105516], material = \"disc\", radius = 0.15514514189499998 },\n"
      "{ position = [0.5141404002290935, 0.20608247158224566], material = \"disc\", radius = 0.21479175461992683 },\n"
      "{ position = [0.23202365803300146, 0.5578443454056454], material = \"disc\", radius = 0.23670140659459232 },\n"
      "{ position = [0.6963584141097195, 0.6061722000128001], material = \"disc\", radius = 0.23448223603965263 }]\n"
      "[scene]\ndimension = 2\n[time]\nstep = 5e-4\n"
      "[[material]]\nname = \"disc\"\ndensity = 1\n"
      "[[contact]]\nname = \"discs\"\nplugin = \"disc_cundall_strack\"\nnormal_stiffness = 100\n"
      "tangential_stiffness = 100\nnormal_damping = 0.5\ntangential_damping = 0.5\nfriction = 0.2\n"
      "[[boundary]]\nplugin = \"box\"\nlower = [0, 0]\nupper = [0.9225263586453263, 0.831429171807625]\n"
      "x_low = \"fixed\"\ny_low = \"fixed\"\nstress_x_high = 1\n"
      "stress_y_high = { from = 1, to = 1.3, period = 10 }\nmass = 0.1\nviscosity = 1\n"
      "[[stage]]\nname = \"cycles\"\ncycles = 6\nperiod = 10\n";
  constexpr double first = -6.013107e-4, last = 1.279525e-7;  // strain after a cycle, and in the sixth
  const Prepared p(plan_of(plan, {}));
  const auto strains = [&](int increments) {
    QuasiStatic packing(*p.simulation, {.longest_increment = 10.0 / increments});
    REQUIRE(packing.advance(0));
    const std::vector<scree_plane> start = packing.planes();
    std::vector<double> all;
    for (const double time : {10.0, 50.0, 60.0}) {
      REQUIRE(packing.advance(time));
      all.push_back(strain(packing.planes(), start));
    }
    return std::pair(all[0], all[2] - all[1]);
  };
  // Of second order, a 40th of a cycle squared: 6e-4.
  for (const int increments : {20, 40, 80}) {
    INFO(increments);
    CHECK(strains(increments).first == Approx(first).epsilon(6e-4));
    CHECK(strains(increments).second == Approx(last).epsilon(6e-4));
  }
}

// A disc between two walls, and a small one below it that nothing else touches. The load pushes the first
// disc against the small one, which stays where it was left when the load falls: nothing pulls it, and
// without inertia it does not go on.
TEST_CASE("a body that was pushed stays where it is when what pushed it recedes") {
  const std::string plan =
      "particle = [\n"
      "{ position = [0.99, 0], material = \"disc\", radius = 1 },\n"
      "{ position = [0.4371, -1.1823], material = \"disc\", radius = 0.3 }]\n"
      "[scene]\ndimension = 2\n[time]\nstep = 1e-3\n"
      "[[material]]\nname = \"disc\"\ndensity = 1\n"
      "[[contact]]\nname = \"discs\"\nplugin = \"disc_cundall_strack\"\nnormal_stiffness = 100\n"
      "tangential_stiffness = 100\nnormal_damping = 0.5\ntangential_damping = 0.5\nfriction = 0.5\n"
      "[[boundary]]\nplugin = \"box\"\nlower = [0, -5]\nupper = [1.98, 5]\nx_low = \"fixed\"\n"
      "y_low = \"fixed\"\ny_high = \"fixed\"\nstress_x_high = { from = 0.1, to = 0.5, period = 10 }\n"
      "mass = 0.1\nviscosity = 1\n"
      "[[stage]]\nname = \"cycle\"\nduration = 10\n";
  const Prepared p(plan_of(plan));
  const auto places = [&](const QuasiStatic& packing) { return p.from(packing.state())->particles(); };
  const auto distance = [](const Particles& at, const Particles& other) {
    return std::hypot(at.position()[0][0] - other.position()[0][1],
                      at.position()[1][0] - other.position()[1][1]);
  };
  QuasiStatic packing(*p.simulation, {.longest_increment = 0.25});
  REQUIRE(packing.advance(0));
  const Particles start = places(packing);
  REQUIRE(packing.advance(5));
  const Particles pushed = places(packing);
  REQUIRE(packing.advance(10));
  const Particles end = places(packing);
  CHECK(distance(start, start) > 1.3);
  CHECK(distance(pushed, start) < 1.3 - 1e-3);
  // The tolerance of the search, 1e-11, times the largest force over the stiffness, 0.05 m.
  CHECK(distance(pushed, pushed) == Approx(1.3).margin(1e-12).epsilon(0));
  CHECK(distance(end, pushed) > 1.3 + 1e-2);
  // As far as the load, which changes by 4 N, moves the other disc in the increment from the extreme.
  const double apart = std::hypot(end.position()[0][1] - pushed.position()[0][1],
                                  end.position()[1][1] - pushed.position()[1][1]);
  CHECK(apart < 4 / 100.0 * 0.5 * (1 - std::cos(2 * std::numbers::pi * 0.025)));
}

TEST_CASE("a quasi-static load refuses what it cannot follow") {
  const Prepared p(box_of_discs,
                   {"stage.cycles.set.box.x_low=velocity", "stage.cycles.set.box.velocity_x_low=1e-3"});
  CHECK_THROWS_WITH(QuasiStatic(*p.simulation, {.longest_increment = 1}),
                    Catch::Contains("wall box.x_low is moved with 0.001 m/s"));
  const Prepared q(box_of_discs, {});
  CHECK_THROWS_WITH(QuasiStatic(*q.simulation, {}), Catch::Contains("needs an increment above 0 s"));
  CHECK_THROWS_WITH(QuasiStatic(*q.simulation, {.longest_increment = 1, .shortest_increment = 2}),
                    Catch::Contains("shortest increment 2 s is not within 0 and the longest, 1 s"));
  for (const double tolerance : {0.0, std::nan("")})
    CHECK_THROWS_WITH(QuasiStatic(*q.simulation, {.longest_increment = 1, .tolerance = tolerance}),
                      Catch::Contains("of a quasi-static load is not within 0 and 1"));
  Scene swinging = column(6);
  add_body_force(swinging, "gravity", {{"acceleration", {0, 0, 0}}, {"acceleration_y", {1, 0, 1, 2, 0}}});
  CHECK_THROWS_WITH(QuasiStatic(Simulation(swinging), {.longest_increment = 1}),
                    Catch::Contains("gravity.acceleration_y changes with time"));
  swinging.body_forces[0].parameters.set_absent(true);
  CHECK_NOTHROW(QuasiStatic(Simulation(swinging), {.longest_increment = 1}));
}

TEST_CASE("a quasi-static load passes through walls and bodies of laws that are absent") {
  const auto wall_after = [](bool others) {
    Scene scene = column(6);
    const std::size_t top = 1;
    if (others) {
      const double middle = scene.bodies[column_discs / 2].position[1];
      add_boundary(scene, "plane", {{"point", {0, middle, 0}}, {"normal", {0, 1, 0}}, {"control", {7}}},
                   "gate");
      scene.materials.push_back("ghost");
      scene.laws.push_back(scene.laws[0]);
      scene.laws[1].name = "ghosts";
      scene.laws[1].parameters.set_absent(true);
      scene.law_of = {0, 1, 1, 1};
      scene.bodies.push_back(body(100, 1, 1, {{0.2, middle, 0}}, {}, {}, 2));
      scene.bodies.back().material = 1;
      scene.bodies.back().fixed = true;
    }
    const Simulation simulation(scene);
    const double start = simulation.planes()[top].point[1];
    QuasiStatic packing(simulation, {.longest_increment = 1});
    REQUIRE(packing.advance(0));
    CHECK(packing.touching() == column_discs + 1);
    return packing.planes()[top].point[1] - start;
  };
  CHECK(wall_after(true) == wall_after(false));
}

TEST_CASE("a quasi-static packing has a state before its first balance") {
  const Prepared p(box_of_discs, {});
  const QuasiStatic packing(*p.simulation, {.longest_increment = 1});
  for (const scree_load& load : packing.loads())
    for (const double f : load.force) CHECK(f == 0);
  CHECK(packing.state().has("bodies/position"));
}

// Each of its contacts bears 1 N. The tolerance of the search, 1e-11, times 1 N over the stiffness.
TEST_CASE("a quasi-static load presses a column on a fixed disc as on a floor") {
  const auto wall_after = [](bool fixed_disc) {
    Scene scene = column(6);
    if (fixed_disc) {
      scene.boundaries.erase(scene.boundaries.begin());
      for (const double x : {0.0, 1.0}) {
        scene.bodies.push_back(
            body(std::int64_t(scene.bodies.size()), 1, 1, {{x, -1 + 1e-12, 0}}, {}, {}, 2));
        scene.bodies.back().fixed = true;
      }
    }
    const Simulation simulation(scene);
    const std::size_t top = simulation.planes().size() - 1;
    const double start = simulation.planes()[top].point[1];
    QuasiStatic packing(simulation, {.longest_increment = 1});
    REQUIRE(packing.advance(0));
    CHECK(packing.degrees_of_freedom() == 2 * column_discs + 1);
    CHECK(packing.touching() == column_discs + 1);
    // The state that a run goes on from.
    const Simulation later(scene, packing.state());
    CHECK(later.contact_list().size() == column_discs + 1);
    for (std::size_t i = column_discs; i < scene.bodies.size(); ++i)
      CHECK(position(later, i) == scene.bodies[i].position);
    return packing.planes()[top].point[1] - start;
  };
  const double expected = -(column_discs + 1) / disc_stiffness;
  CHECK(wall_after(false) == Approx(expected).epsilon(1e-8));
  CHECK(wall_after(true) == Approx(expected).epsilon(1e-8));
}

TEST_CASE("laws that integrate spins are named") {
  for (const auto& [law, named] : {std::pair{"disc_cundall_strack", false}, std::pair{"disc_corrected", true},
                                   std::pair{"disc_angular", false}}) {
    const Prepared p(box_of_discs, {std::string("contact.discs.plugin=") + law});
    const std::vector<std::string> names = response::laws_that_integrate_spins(*p.simulation);
    CHECK(names == (named ? std::vector<std::string>{"discs"} : std::vector<std::string>{}));
  }
}

}  // namespace scree::test
