#include "follower.hpp"

#include "course_files.hpp"
#include "load_warnings.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/energy.hpp>
#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/files/try_each.hpp>
#include <scree/response/linear_system.hpp>
#include <scree/run/set_up.hpp>
#include <scree/stage.hpp>

namespace scree::quasi_static {

namespace {

using response::QuasiStatic;
using Clock = std::chrono::steady_clock;

// Steps of the stages before that are taken at once.
constexpr std::uint64_t steps_at_once = 1000;
// Kinetic over elastic energy below which a packing that moves may be taken to be at rest: its motion is lost there.
constexpr double at_rest = 1e-6;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

Follower::Follower(const scenario::Plan& plan, const FollowOptions& options, run::RunDirectory& directory)
    : plan_(plan), options_(options), directory_(directory) {
  course_.title = plan.heading();
  course_.directory = directory.path();
  course_.scenario = plan.resolved_text;
  course_.inputs = run::hashes_of(plan.files);
}

Course Follower::begin() {
  find_start();
  directory_.begin([this] {
    write_record("running", course_, directory_);
    room_.reserve(directory_, results.record);
    directory_.write_file("scenario.toml", plan_.text_for_any_folder);
    series_.emplace(directory_.add("series/quasi_static.csv"));
    series_->add(box_->head());
    series_->flush();
  });
  return follow([this] {
    sample(dynamics_ ? sample_of(*dynamics_, course_.start) : sample_of(*packing_, course_.start));
    begin_part();
  });
}

Course Follower::resume(const State& state) {
  check_plan();
  const StateTransfer from = StateTransfer::restoring_from(state).below(results.group);
  transfer_state(from);
  kept_ = state;
  // A state that does not fit is refused before anything is changed.
  if (from.has("moves"))
    dynamics_ = simulation_of(state);
  else
    begin_packing(state);
  series_.emplace(directory_.path() / "series/quasi_static.csv", series_bytes_);
  directory_.create();
  room_.reserve(directory_, results.record);
  return follow([this] {
    series_->cut();
    write_record("running", course_, directory_);
    if (!plan_.text_for_any_folder.empty()) directory_.write_file("scenario.toml", plan_.text_for_any_folder);
  });
}

Course Follower::follow(const std::function<void()>& begin) {
  try {
    begin();
    while (interval_ < intervals() && proceeds()) {
      const std::size_t next = interval_ + 1;
      advance(next < intervals() ? course_.start + double(next) * course_.increment : course_.end);
      if (!proceeds()) break;
      interval_ = next;
      if (interval_ % between_states_ == 0 && interval_ < intervals()) begin_part();
      report();
    }
    course_.interrupted = !proceeds();
    save(course_.interrupted ? "interrupted" : "finished");
  } catch (const Error& error) {
    course_.error = error.what();
    save_failed();
    files::rethrow_as_failure(error);
  } catch (const std::exception& error) {  // such as of memory
    course_.error = error.what();
    save_failed();
    throw;
  }
  return std::move(course_);
}

void Follower::check_plan() const {
  if (plan_.stages.empty() || !plan_.stages.back().duration)
    throw Error(fmt::format(
        "{}: the last stage is followed, and has no duration; give it one, or cycles and a period",
        plan_.source.string()));
  if (plan_.scene.precision != Precision::double_precision)
    throw Error(fmt::format("{}: a quasi-static load takes double precision; leave time.precision out",
                            plan_.source.string()));
}

void Follower::find_start() {
  check_plan();
  run_stages_before();
  began_ = Clock::now();
  course_.period = plan_.stages.back().period;
  course_.start = course_.reached = simulation_->time();
  course_.end = course_.start + *plan_.stages.back().duration;
  const bool cyclic = course_.period > 0;
  course_.increment = (cyclic ? course_.period : *plan_.stages.back().duration) / options_.increments;
  between_states_ = cyclic ? options_.increments : FollowOptions::increments_per_cycle;
  course_.bodies = simulation_->particles().size();
  try {
    for (const std::string& warning : load_warnings(*simulation_, course_, options_.increments))
      warn(warning);
    packing_ = std::make_unique<QuasiStatic>(*simulation_, quasi_static_options());
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", plan_.source.string(), error.what()), error.status());
  }
  course_.degrees_of_freedom = packing_->degrees_of_freedom();
  const bool balanced = packing_->advance(course_.start);
  if (!proceeds()) throw interrupted("before the load was followed");
  lengths_at_start_ =
      BoxRow::lengths(simulation_->dimension(), balanced ? packing_->planes() : simulation_->planes());
  box_ = std::make_unique<BoxRow>(lengths_at_start_);
  if (balanced) return;
  // The load jumps there, or the packing has not come to rest.
  warn(
      "the packing is not in balance with the loads at the start of the last stage, and dynamics go on from there; begin the "
      "loads with their present values, and let the packing come to rest in the stage before (until)");
  end_packing();
  begin_dynamics(std::move(simulation_));
}

void Follower::run_stages_before() {
  simulation_ = run::set_up(plan_, options_.threads);
  if (plan_.stages.size() > 1) check_last_stage();
  for (const std::string& line : simulation_->let_go()) warn(line);
  StageRunner stages(*simulation_, plan_.stages);
  while (stages.current() + 1 < plan_.stages.size()) {
    stages.run(steps_at_once, [this] { return proceeds(); });
    if (!proceeds()) throw interrupted("before the stages had ended");
    if (options_.on_progress) options_.on_progress(0, 0, plan_.stages[stages.current()].name);
  }
}

// What can be told before the stages have run.
void Follower::check_last_stage() const {
  try {
    response::check_laws(plan_.scene, response::LawsNeeded::all);
    if (const auto last = run::set_up_with_last_stage(plan_)) response::loads_of_walls(*last, last->time());
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", plan_.source.string(), error.what()), error.status());
  }
}

Error Follower::interrupted(const std::string& when) const {
  return Error(fmt::format("{}: interrupted {}; nothing was written, give the same call again",
                           plan_.source.string(), when),
               ExitStatus::interrupted);
}

response::QuasiStaticOptions Follower::quasi_static_options() const {
  return {.longest_increment = course_.increment, .proceed = [this] { return proceeds(); }};
}

std::unique_ptr<Simulation> Follower::simulation_of(const State& state) const {
  Scene scene = scene_in_stage(plan_.scene, plan_.stages, plan_.stages.size() - 1);
  scene.threads = options_.threads;
  return std::make_unique<Simulation>(scene, state);
}

std::size_t Follower::intervals() const {
  return std::size_t(std::ceil((course_.end - course_.start) / course_.increment - 1e-9));
}

void Follower::advance(double time) {
  if (!dynamics_ && packing_->advance(time)) {
    sample(sample_of(*packing_, time));
    return;
  }
  if (!proceeds()) return;
  if (!dynamics_) hand_over();
  const Clock::time_point begin = Clock::now();
  course_.dynamic_steps +=
      dynamics_->run(std::uint64_t(std::llround((time - dynamics_->time()) / dynamics_->step_length())),
                     [this] { return proceeds(); });
  course_.hand_overs.back().to = dynamics_->time();
  course_.dynamic_wall += seconds_since(begin);
  if (proceeds()) end_dynamics_at_rest(time);
}

void Follower::hand_over() {
  State state = packing_->state();
  end_packing();
  begin_dynamics(simulation_of(state));
}

void Follower::begin_dynamics(std::unique_ptr<Simulation> simulation) {
  dynamics_ = std::move(simulation);
  course_.hand_overs.push_back({dynamics_->time(), dynamics_->time()});
}

void Follower::end_dynamics_at_rest(double time) {
  const scree_energy energy = dynamics_->energy();
  if (kinetic_energy(energy) > at_rest * elastic_energy(energy)) {
    sample(sample_of(*dynamics_, time));
    return;
  }
  auto packing = std::make_unique<QuasiStatic>(*dynamics_, quasi_static_options());
  const bool balanced = packing->advance(std::max(time, dynamics_->time()));
  if (proceeds()) sample(balanced ? sample_of(*packing, time) : sample_of(*dynamics_, time));
  packing_ = std::move(packing);
  if (balanced && proceeds())
    simulation_ = std::move(dynamics_);
  else
    end_packing();
}

void Follower::begin_part() {
  State state = packing_ ? packing_->state() : dynamics_->state();
  end_packing();
  keep_state(state);
  if (!dynamics_) begin_packing(state);
}

void Follower::begin_packing(const State& state) {
  simulation_ = simulation_of(state);
  packing_ = std::make_unique<QuasiStatic>(*simulation_, quasi_static_options());
  if (packing_->advance(simulation_->time()) || !proceeds()) return;
  end_packing();
  begin_dynamics(std::move(simulation_));
}

void Follower::end_packing() {
  if (!packing_) return;
  course_.increments += packing_->counts().increments;
  course_.iterations += packing_->counts().iterations;
  course_.events += packing_->counts().events;
  packing_.reset();
}

void Follower::sample(const Sample& sample) {
  directory_.check_in_place();
  series_->add(box_->line(sample));
  series_->flush();
  times_.push_back(course_.reached = sample.time);
  strains_.push_back(box_->deviatoric_strain(sample));
}

void Follower::report() const {
  if (options_.on_progress)
    options_.on_progress(double(interval_) / double(intervals()), seconds(), "quasi-static");
}

void Follower::warn(const std::string& line) {
  course_.warnings.push_back(line);
  if (options_.on_warning) options_.on_warning(line);
}

double Follower::seconds() const { return wall_before_ + seconds_since(began_); }

}  // namespace scree::quasi_static
