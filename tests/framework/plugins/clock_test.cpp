#include "plugins/clock.hpp"

#include "scenes.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/plugin/program.hpp>
#include <scree/simulation.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double clock_step = 1e-3;

// Walls at x = −1 and x = 1, of which each has a speed of its own.
Parameters walls(const std::vector<double>& low, const std::vector<double>& high) {
  return parameters("box", SCREE_BOUNDARY,
                    {{"lower", {-1, -1, -1}},
                     {"upper", {1, 1, 1}},
                     {"y", {1}},
                     {"z", {1}},
                     {"x_low", {3}},
                     {"x_high", {3}},
                     {"velocity_x_low", low},
                     {"velocity_x_high", high}});
}

const std::vector<double> ramp = {Program::ramp, 0, 1, 1};  // 1 m/s²
std::vector<double> steady(double speed) { return {Program::constant, speed}; }

Scene empty_box(const Parameters& parameters) {
  Scene s =
      scene(3, clock_step, {body(1, 0.01, 1, {})}, {{"normal_stiffness", {1}}, {"normal_damping", {0}}});
  s.boundaries.push_back({"box", 0, parameters});
  return s;
}

void set(Simulation& s, const Parameters& parameters, const std::vector<std::string>& going_on) {
  s.reconfigure_boundary("box", parameters, going_on);
  s.apply_reconfiguration();
}

}  // namespace

TEST_CASE("a function of time that a stage does not set goes on, also over several stages") {
  Simulation s(empty_box(walls(steady(0), ramp)));
  run(s, 100);
  set(s, walls(ramp, ramp), {"velocity_x_high"});
  run(s, 100);
  set(s, walls(steady(0), ramp), {"velocity_x_high"});
  run(s, 100);
  // 0.3 s of 1 m/s² inwards; Simpson's rule is exact for it, with 300 roundings.
  CHECK(s.planes()[1].point[0] == Approx(1 - 0.5 * 0.09).epsilon(1e-13));
  CHECK(-s.planes()[1].velocity[0] == Approx(0.3).epsilon(1e-13));
  // 0.1 s of its own.
  CHECK(s.planes()[0].point[0] == Approx(-1 + 0.5 * 0.01).epsilon(1e-13));
}

TEST_CASE("a function of time that a stage sets starts again") {
  Simulation s(empty_box(walls(ramp, ramp)));
  run(s, 100);
  set(s, walls(ramp, ramp), {});
  run(s, 100);
  CHECK(s.planes()[1].point[0] == Approx(1 - 2 * 0.5 * 0.01).epsilon(1e-13));
}

TEST_CASE("the time of each function is in the state: a run goes on to the same bits") {
  Simulation whole(empty_box(walls(steady(0), ramp)));
  run(whole, 100);
  set(whole, walls(ramp, ramp), {"velocity_x_high"});
  run(whole, 50);
  Simulation again(empty_box(walls(ramp, ramp)), whole.state());
  run(whole, 50), run(again, 50);
  CHECK(whole.state_hash() == again.state_hash());
  CHECK(again.planes()[1].point[0] == Approx(1 - 0.5 * 0.04).epsilon(1e-13));
  // A stage after that.
  for (Simulation* s : {&whole, &again}) set(*s, walls(steady(0), ramp), {"velocity_x_high"});
  run(whole, 50), run(again, 50);
  CHECK(whole.state_hash() == again.state_hash());
}

TEST_CASE("functions of time of body forces have clocks too") {
  const auto pull = [](const std::vector<double>& x, const std::vector<double>& y) {
    return parameters("gravity", SCREE_BODY_FORCE,
                      {{"acceleration", {0, 0, 0}}, {"acceleration_x", x}, {"acceleration_y", y}});
  };
  Scene scene = test::scene(3, clock_step, {body(1, 0.01, 1, {})},
                            {{"normal_stiffness", {1}}, {"normal_damping", {0}}});
  add_body_force(scene, "gravity", {{"acceleration", {0, 0, 0}}});
  scene.body_forces[0].parameters = pull(ramp, ramp);
  Simulation s(scene);
  run(s, 100);
  s.reconfigure_body_force("gravity", pull(ramp, ramp), {"acceleration_x"});
  s.apply_reconfiguration();
  run(s, 50);
  scene.body_forces[0].parameters = pull(ramp, ramp);
  Simulation again(scene, s.state());
  run(s, 50), run(again, 50);
  // v = ∫ t dt: the trapezoidal rule is exact for it.
  CHECK(velocity(s, 0)[0] == Approx(0.5 * 0.04).epsilon(1e-12));
  CHECK(velocity(s, 0)[1] == Approx(2 * 0.5 * 0.01).epsilon(1e-12));
  CHECK(s.state_hash() == again.state_hash());
}

TEST_CASE("a function that is ahead is the one of a later time, with its rate, period and extremes") {
  const std::vector<std::vector<double>> all = {{Program::constant, 2},
                                                {Program::sine, 1, 2, 3, 0.5},
                                                {Program::cycle, 1, 3, 0.7},
                                                {Program::ramp, 0, 2, 0.5},
                                                {Program::table, 0, 1, 0.2, 4, 1, -1},
                                                {Program::drive, 1, 2, 0.1, 3, 0},
                                                {Program::noise, 0, 1, 0.1, 2, 1, 0.3, 0.7}};
  for (const std::vector<double>& data : all) {
    std::vector<double> later = {Program::ahead, 0.25};
    later.insert(later.end(), data.begin(), data.end());
    const Program now({data.data(), data.size()}), then({later.data(), later.size()});
    for (const double t : {-0.3, 0.0, 0.1, 0.4, 2.0}) {
      CHECK(then(t) == now(t + 0.25));
      CHECK(then.rate(t) == now.rate(t + 0.25));
    }
    CHECK(then.period() == now.period());
    CHECK(then.extremes() == now.extremes());
  }
}
