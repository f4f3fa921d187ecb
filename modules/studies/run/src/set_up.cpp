#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/probes.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/step_check.hpp>
#include <scree/state_error.hpp>

namespace scree::run {

namespace {

// A simulation of a scene, from the state with which the plan begins if there is one.
std::unique_ptr<Simulation> simulation_of(const scenario::Plan& plan, Scene scene, Ranks* ranks = nullptr) {
  if (!plan.from_state) return std::make_unique<Simulation>(std::move(scene), ranks);
  return std::make_unique<Simulation>(scene, *plan.from_state, plan.branching, ranks);
}

std::unique_ptr<Simulation> make_simulation(const scenario::Plan& plan, unsigned threads, Ranks* ranks) {
  // What the first stage sets holds before the first force.
  Scene scene = scene_in_stage(plan.scene, plan.stages, 0);
  scene.threads = threads;
  try {
    return simulation_of(plan, std::move(scene), ranks);
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

// Whether a probe starts in a scene as it is now, as if it were another time. Returns the number of bodies
// that it will read. Throws Error if not.
std::size_t check_start(const scenario::ProbePlan& probe, const scenario::Plan& plan,
                        const Simulation& simulation, double time, double end_time) {
  const Probe candidate = scenario::configured(probe, plan.scene.dimension);
  const SimulationView view(simulation, candidate.view_needs(), end_time, candidate.listed_bodies());
  scree_view then = view.get();
  then.time = time;
  return candidate.check(then);
}

bool starts(const scenario::ProbePlan& probe, const scenario::Plan& plan, const Simulation& simulation) {
  try {
    check_start(probe, plan, simulation, simulation.time(), NAN);
    return true;
  } catch (const Error&) {
    return false;
  }
}

// Throws Error if a probe has many bodies sent to the first rank in every step.
void check_sent(const scenario::ProbePlan& probe, const scenario::Plan& plan, std::size_t bodies) {
  constexpr double most = 50, bytes_per_body = 250;  // (MB), of state and loads of a sphere with spin
  const double megabytes = 1e-6 * bytes_per_body * double(bodies);
  const Probe candidate = scenario::configured(probe, plan.scene.dimension);
  const double every =
      candidate.observes() ? std::min(probe.every, probe.observe_every.value_or(0)) : probe.every;
  if (megabytes <= most || every >= 1.5 * plan.scene.step) return;
  throw Error(
      fmt::format("reads {} in every step, for which {:.0f} MB go to the first rank each time; give a "
                  "longer every, or leave out --ranks",
                  counted(bodies, "body", "bodies"), megabytes));
}

void check_probes(const scenario::Plan& plan, const Simulation& simulation, bool over_ranks) {
  for (const scenario::ProbePlan& probe : plan.probes) {
    const Span span = span_of(probe, plan.stages);
    const bool later = span.begin != 0;
    // A probe of later stages may read contacts or walls that do not exist yet; then nothing is known of its
    // times either.
    if (later && (!std::isfinite(span.begin) || !starts(probe, plan, simulation))) continue;
    try {
      const double now = simulation.time();
      const std::size_t read = check_start(probe, plan, simulation, now + span.begin, now + span.end);
      if (over_ranks) check_sent(probe, plan, read);
    } catch (const Error& error) {
      throw error.at(probe.place, ExitStatus::bad_input);
    }
  }
}

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

std::unique_ptr<Simulation> set_up(const scenario::Plan& plan, unsigned threads, Ranks* ranks) {
  auto simulation = make_simulation(plan, threads, ranks);
  if (const auto problem = plan.step_guard ? step_problem(*simulation) : std::nullopt)
    throw problem->at(plan.step_place);
  check_later_stages(plan);
  check_probes(plan, *simulation, ranks && ranks->size() > 1);
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
                                    const StateTransfer& stages, unsigned threads, Ranks* ranks) {
  Scene scene = scene_in_stage(plan.scene, plan.stages, stage_of(stages));
  scene.threads = threads;
  return std::make_unique<Simulation>(scene, state, ranks);
}

void require_stages(const scenario::Plan& plan) {
  if (plan.stages.empty())
    throw Error(fmt::format(
        "{}: the scenario says nothing of how long it lasts; give time.duration or [[stage]]{}",
        plan.source.string(),
        plan.studies.empty() ? ""
                             : fmt::format(", or run scree {} with it", fmt::join(plan.studies, " or "))));
}

std::string describe_bodies(const Simulation& s) {
  const Footprint print = s.footprint();
  std::vector<std::string> parts;
  if (print.fixed_bodies > 0) parts.push_back(fmt::format("{} fixed", print.fixed_bodies));
  if (print.held_bodies > 0) parts.push_back(fmt::format("{} fixed along some axes", print.held_bodies));
  return fmt::format("{}{} in {}D", counted(s.scene().bodies.size(), "body", "bodies"),
                     parts.empty() ? "" : fmt::format(" ({})", fmt::join(parts, ", ")), s.dimension());
}

}  // namespace scree::run
