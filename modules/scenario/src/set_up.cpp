#include <numbers>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/probes.hpp>
#include <scree/scenario/set_up.hpp>

namespace scree::scenario {

namespace {

std::unique_ptr<Simulation> make_simulation(const Plan& plan, unsigned threads) {
  Scene scene = plan.scene;
  scene.threads = threads;
  try {
    return std::make_unique<Simulation>(scene);
  } catch (const Error& error) {
    // Beside the bodies, only a periodic length can be wrong for the scene as a whole.
    const bool of_bodies = error.status() == ExitStatus::blow_up || plan.periodic_place.empty();
    throw Error(fmt::format("{}: {}", of_bodies ? plan.bodies_place : plan.periodic_place, error.what()));
  }
}

void check_probes(const Plan& plan, const Simulation& simulation) {
  const SimulationView view(simulation, false);
  for (const ProbePlan& probe : plan.probes) {
    try {
      Probe(probe.parameters, plan.scene.dimension).check(view.get());
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", probe.place, error.what()));
    }
  }
}

}  // namespace

std::unique_ptr<Simulation> set_up(const Plan& plan, unsigned threads) {
  auto simulation = make_simulation(plan, threads);
  check_probes(plan, *simulation);
  return simulation;
}

std::string describe_step(const Simulation& s) {
  constexpr double few = 20;  // below which contacts are resolved to some per cent only
  const double steps = s.min_steps_per_contact();
  return fmt::format("time step {:.4g} s, {:.3g} steps in the shortest contact{}", s.step_length(), steps,
                     steps < few ? "; that is few: use 20 or more, 50 for a per mille" : "");
}

std::optional<std::string> step_problem(const Simulation& s) {
  const double steps = s.min_steps_per_contact();
  if (!(steps < std::numbers::pi / 2)) return std::nullopt;
  const double contact = steps * s.step_length();
  return fmt::format(
      "the time step of {:g} s is too long for the shortest contact, which lasts {:.3g} s between "
      "particles of the smallest mass (t = {:g} s); use time.step = {:.2g} or less",
      s.step_length(), contact, s.time(), contact / 50);
}

}  // namespace scree::scenario
