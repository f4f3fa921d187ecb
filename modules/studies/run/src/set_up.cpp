#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/probes.hpp>
#include <scree/run/set_up.hpp>
#include <scree/state_error.hpp>
#include <scree/step_guard.hpp>
#include <scree/told_apart.hpp>

namespace scree::run {

namespace {

// A simulation of a scene, from the state with which the plan begins if there is one.
std::unique_ptr<Simulation> simulation_of(const scenario::Plan& plan, const Scene& scene) {
  if (!plan.from_state) return std::make_unique<Simulation>(scene);
  return std::make_unique<Simulation>(scene, *plan.from_state, plan.branching);
}

std::unique_ptr<Simulation> make_simulation(const scenario::Plan& plan, unsigned threads) {
  // What the first stage sets holds before the first force.
  Scene scene = scene_in_stage(plan.scene, plan.stages, 0);
  scene.threads = threads;
  try {
    return simulation_of(plan, scene);
  } catch (const Error& error) {
    // Errors of the scene as a whole concern either the bodies or, as bad input, a periodic length.
    const bool of_bodies = error.status() != ExitStatus::bad_input || plan.periodic_place.empty() ||
                           dynamic_cast<const StateError*>(&error);
    throw error.at(of_bodies ? plan.bodies_place : plan.periodic_place, ExitStatus::bad_input);
  }
}

// When a probe records (s); NaN where a stage before the end has no duration.
struct Span {
  double begin = NAN, end = 0;
};
Span span_of(const scenario::ProbePlan& probe, const std::vector<Stage>& stages) {
  if (probe.stages.empty() || stages.empty()) return {0, duration_of(stages)};
  Span span;
  double time = 0;
  bool begun = false;
  for (const Stage& stage : stages) {
    const bool records =
        std::find(probe.stages.begin(), probe.stages.end(), stage.name) != probe.stages.end();
    if (records && !begun) span.begin = time, begun = true;
    time += stage.duration.value_or(NAN);
    if (records) span.end = time;
  }
  return span;
}

// Whether a probe starts in a scene as it is now, as if it were another time. Throws Error if not.
void check_start(const scenario::ProbePlan& probe, const scenario::Plan& plan, const Simulation& simulation,
                 double time, double end_time) {
  const Probe candidate = scenario::configured(probe, plan.scene.dimension);
  const SimulationView view(simulation, candidate.needs(), end_time);
  scree_view then = view.get();
  then.time = time;
  candidate.check(then);
}

bool starts(const scenario::ProbePlan& probe, const scenario::Plan& plan, const Simulation& simulation) {
  try {
    check_start(probe, plan, simulation, simulation.time(), NAN);
    return true;
  } catch (const Error&) {
    return false;
  }
}

void check_probes(const scenario::Plan& plan, const Simulation& simulation) {
  for (const scenario::ProbePlan& probe : plan.probes) {
    const Span span = span_of(probe, plan.stages);
    const bool later = span.begin != 0;
    // A probe of later stages may read contacts or walls that do not exist yet; then nothing is known of its
    // times either.
    if (later && (!std::isfinite(span.begin) || !starts(probe, plan, simulation))) continue;
    try {
      check_start(probe, plan, simulation, simulation.time() + span.begin, simulation.time() + span.end);
    } catch (const Error& error) {
      throw error.at(probe.place, ExitStatus::bad_input);
    }
  }
}

}  // namespace

void check_step(const scenario::Plan& plan, const Simulation& s) {
  const auto problem = plan.step_guard ? step_problem(s) : std::nullopt;
  if (problem) throw problem->at(fmt::format("t = {:g} s", s.time()), ExitStatus::blow_up);
}

namespace {

// Applies the changes of a stage to laws and body forces; returns whether there are any.
bool change_scene(const Stage& stage, Scene& scene) {
  bool changed = false;
  for (const Stage::Change& change : stage.changes) {
    for (Scene::Law& law : scene.laws)
      if (change.kind == SCREE_CONTACT_LAW && law.name == change.name)
        law.parameters = change.parameters, changed = true;
    for (Scene::BodyForce& term : scene.body_forces)
      if (change.kind == SCREE_BODY_FORCE && term.name == change.name)
        term.parameters = change.parameters, changed = true;
  }
  return changed;
}

// Throws Error if a later stage makes the time step too long; checks this without running the stages.
void check_later_stages(const scenario::Plan& plan) {
  Scene scene = scene_in_stage(plan.scene, plan.stages, 0);
  for (std::size_t k = 1; k < plan.stages.size(); ++k) {
    const Stage& stage = plan.stages[k];
    if (!plan.step_guard || !change_scene(stage, scene)) continue;
    if (const auto problem = step_problem(*simulation_of(plan, scene)))
      throw Error(plan.step_place, fmt::format("in stage '{}' {}", stage.name, problem->problem()),
                  problem->cure());
  }
}

}  // namespace

std::unique_ptr<Simulation> set_up(const scenario::Plan& plan, unsigned threads) {
  auto simulation = make_simulation(plan, threads);
  if (const auto problem = plan.step_guard ? step_problem(*simulation) : std::nullopt)
    throw problem->at(plan.step_place);
  check_later_stages(plan);
  check_probes(plan, *simulation);
  return simulation;
}

std::unique_ptr<Simulation> set_up_with_last_stage(const scenario::Plan& plan) {
  try {
    return simulation_of(plan, scene_in_stage(plan.scene, plan.stages, plan.stages.size()));
  } catch (const Error&) {
    return nullptr;
  }
}

std::unique_ptr<Simulation> resumed(const scenario::Plan& plan, const State& state,
                                    const StateTransfer& stages, unsigned threads) {
  Scene scene = scene_in_stage(plan.scene, plan.stages, stage_of(stages));
  scene.threads = threads;
  return std::make_unique<Simulation>(scene, state);
}

void require_stages(const scenario::Plan& plan) {
  if (plan.stages.empty())
    throw Error(fmt::format(
        "{}: the scenario says nothing of how long it lasts; give time.duration or [[stage]]{}",
        plan.source.string(),
        plan.studies.empty() ? ""
                             : fmt::format(", or run scree {} with it", fmt::join(plan.studies, " or "))));
}

namespace {

// Of a step that is computed from the limit with which it is compared.
constexpr double round_off = 1e-12;

// Rounded down to two digits, so that the printed number is allowed.
double rounded_down(double step) {
  const double unit = std::pow(10, std::floor(std::log10(step)) - 1);
  return std::floor(step / unit * (1 + round_off)) * unit;
}

// Error without a place if the time step is above its limit.
std::optional<Error> too_long(const Simulation& s) {
  const StepLimit limit = shortest_limit(s);
  if (s.step_length() <= limit.longest_step * (1 + round_off)) return std::nullopt;
  const std::string_view plural = limit.cause.starts_with("the contacts") ? "" : "s";
  if (!(limit.longest_step > 0))
    return Error("", fmt::format("no time step is short enough: {} allow{} none", limit.cause, plural),
                 "check speeds, masses and viscosities");
  const double contact = s.min_steps_per_contact() * s.step_length();
  const std::string step = told_apart(s.step_length(), limit.longest_step)[0];
  const std::string longest = told_apart(s.step_length(), limit.longest_step, 4)[1];
  return Error("",
               fmt::format("the time step of {} s is too long: {} allow{} {} s at most", step, limit.cause,
                           plural, longest),
               fmt::format("use time.step = {:.2g} or less{}",
                           rounded_down(std::min(contact / 50, limit.longest_step)),
                           contact / 50 < limit.longest_step ? " (50 steps per contact)" : ""));
}

}  // namespace

std::string describe_bodies(const Simulation& s) {
  const Footprint print = s.footprint();
  std::vector<std::string> parts;
  if (print.fixed_bodies > 0) parts.push_back(fmt::format("{} fixed", print.fixed_bodies));
  if (print.held_bodies > 0) parts.push_back(fmt::format("{} fixed along some axes", print.held_bodies));
  return fmt::format("{}{} in {}D", counted(s.particles().size(), "body", "bodies"),
                     parts.empty() ? "" : fmt::format(" ({})", fmt::join(parts, ", ")), s.dimension());
}

std::string describe_step(const Simulation& s) {
  return fmt::format(
      "time step {:.4g} s, {:.3g} steps in the shortest contact, {:.2g} of the longest stable step",
      s.step_length(), s.min_steps_per_contact(), s.step_length() / shortest_limit(s).longest_step);
}

std::optional<std::string> step_warning(const Simulation& s) {
  constexpr double few = 20;  // with fewer steps, errors of contacts are several per cent
  if (const auto problem = too_long(s)) return problem->what();
  if (s.min_steps_per_contact() >= few * (1 - round_off)) return std::nullopt;
  return fmt::format(
      "the shortest contact takes {} time steps; use {:g} or more, 50 for errors of 0.1 % unless damping is "
      "strong",
      told_apart(s.min_steps_per_contact(), few, 3)[0], few);
}

std::optional<Error> step_problem(const Simulation& s) {
  const auto problem = too_long(s);
  if (!problem) return std::nullopt;
  return Error("", problem->problem(), problem->cure() + ", or time.step_guard = false to run it anyway");
}

}  // namespace scree::run
