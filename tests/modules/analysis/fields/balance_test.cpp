#include "field_scenes.hpp"
#include "numbers.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/fields/balance.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::fields;

namespace {

ThreadPool& lone_thread() {
  static ThreadPool pool(1);
  return pool;
}

// Before and after one step.
struct StepInputs {
  FieldInput before, after;
};

StepInputs step_of(const PackingScene& packing, int steps = 150) {
  const auto simulation = agitated(packing, steps);
  StepInputs inputs = {input_of(*simulation), {}};
  simulation->step();
  inputs.after = input_after_step(*simulation, {&inputs.before, 1});
  return inputs;
}

// As the kernel evaluates forces between steps: drag at the velocities that the step before predicted.
FieldInput input_between_steps(Simulation& simulation) {
  const FieldInput earlier = input_of(simulation);
  simulation.step();
  return input_after_step(simulation, {&earlier, 1});
}

// Each term has a relative error of some ε times |x|/w times the degree 6 of the kernel; a point has some
// hundred terms, most of them smaller than the largest one.
constexpr double residual_round_off = 1e-13;

}  // namespace

// Any path between two places closes the balance of mass; this one is that of the body.
TEST_CASE("the path of a body does not jump at periodic faces", "[fields]") {
  for (const std::size_t scene : {std::size_t(2), std::size_t(3)}) {
    const auto simulation = agitated(packing_scenes[scene]);
    const FieldInput first = input_of(*simulation);
    std::vector<Vec3> travelled(first.bodies.size());
    for (int step = 0; step < 400; ++step) {
      simulation->step();
      const FieldInput now = input_of(*simulation);
      for (std::size_t i = 0; i < travelled.size(); ++i)
        travelled[i] += simulation->step_length() * now.bodies[i].velocity;
    }
    const FieldInput second = input_of(*simulation);
    for (std::size_t i = 0; i < travelled.size(); ++i)
      // The sum over velocities at the ends of steps is wrong by a step times the change of velocity.
      CHECK(norm(path_between(first.bodies[i], second.bodies[i], first.domain) - travelled[i]) < 0.02);
  }
}

TEST_CASE("mass is conserved at every point between any two times", "[fields]") {
  for (const PackingScene& packing : packing_scenes) {
    CAPTURE(packing.name);
    const auto simulation = agitated(packing);
    const FieldInput first = input_of(*simulation);
    run(*simulation, 400);
    const FieldInput second = input_of(*simulation);
    double furthest = 0;
    int crossed = 0;
    for (std::size_t i = 0; i < first.bodies.size(); ++i) {
      crossed += first.bodies[i].image != second.bodies[i].image;
      furthest = std::max(furthest, norm(second.bodies[i].position - first.bodies[i].position));
    }
    CHECK(furthest > 0.1);
    CHECK((crossed > 0) == (!packing.periodic.empty() && !packing.groups));
    for (const double w : {1.2, 2.5}) {
      const Balance balance = mass_balance(first, second, grid_over(packing),
                                           AveragingKernel(packing.dimension, w), lone_thread());
      CHECK(balance.largest_term > 0.01);
      INFO(fmt::format("relative {:g}", balance.relative()));
      CHECK(balance.relative() < residual_round_off);
    }
  }
}

TEST_CASE("momentum over a step of velocity Verlet is balanced at every point", "[fields]") {
  for (const PackingScene& packing : packing_scenes) {
    CAPTURE(packing.name);
    const auto simulation = agitated(packing);
    FieldInput before = input_between_steps(*simulation);
    // Over 20 steps, in which contacts begin and end.
    for (int step = 0; step < 20; ++step) {
      simulation->step();
      FieldInput after = input_after_step(*simulation, {&before, 1});
      const Balance balance =
          momentum_balance(before, after, verlet_shares(before, after, simulation->step_length()),
                           grid_over(packing, 1.3), AveragingKernel(packing.dimension, 2), lone_thread());
      INFO(fmt::format("relative {:g} in step {}", balance.relative(), step));
      CHECK(balance.largest_term > 0.01);
      CHECK(balance.relative() < residual_round_off);
      before = std::move(after);
    }
  }
}

TEST_CASE("what is left out of a step shows in the balance of momentum", "[fields]") {
  const PackingScene packing = packing_scenes[4];
  const StepInputs step = step_of(packing);
  const auto residual = [&](const FieldInput& before, const FieldInput& after) {
    return momentum_balance(before, after, verlet_shares(before, after, 1e-3), grid_over(packing),
                            AveragingKernel(3, 2), lone_thread())
        .relative();
  };
  CHECK(residual(step.before, step.after) < residual_round_off);
  StepInputs changed = step;
  changed.after.contacts.pop_back();
  CHECK(residual(changed.before, changed.after) > 1e-7);
  changed = step;
  changed.before.bodies[30].body_force = {};
  CHECK(residual(changed.before, changed.after) > 1e-7);
  changed = step;
  changed.after.bodies[30].velocity[1] += 1e-9;
  CHECK(residual(changed.before, changed.after) > 1e-11);
}

TEST_CASE("balances have the same bits for any number of threads", "[fields]") {
  const PackingScene& packing = packing_scenes[2];
  const StepInputs step = step_of(packing);
  const FieldGrid grid = grid_over(packing);
  const AveragingKernel kernel(3, 2);
  ThreadPool three(3);
  const Balance one = momentum_balance(step.before, step.after, verlet_shares(step.before, step.after, 1e-3),
                                       grid, kernel, lone_thread());
  const Balance many = momentum_balance(step.before, step.after, verlet_shares(step.before, step.after, 1e-3),
                                        grid, kernel, three);
  CHECK(one.residual == many.residual);
  CHECK(one.largest_term == many.largest_term);
}

TEST_CASE("states with other bodies have no balance", "[fields]") {
  const PackingScene& packing = packing_scenes[0];
  StepInputs step = step_of(packing, 1);
  step.after.bodies.pop_back();
  try {
    mass_balance(step.before, step.after, grid_over(packing), AveragingKernel(3, 2), lone_thread());
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(std::string(error.what()) == "the states have different bodies; give states of one run");
  }
}
