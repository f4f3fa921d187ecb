#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/error.hpp>
#include <scree/scene_record.hpp>
#include <scree/stage.hpp>
#include <scree/told_apart.hpp>

namespace scree {

namespace {

// Steps between tests of a condition on energies, which are sums over all bodies.
constexpr std::uint64_t condition_interval = 100;
constexpr std::uint64_t unlimited = ~std::uint64_t(0);

template <class Entries>
bool has(const Entries& entries, const Stage::Change& change) {
  return std::any_of(entries.begin(), entries.end(), [&](const auto& entry) {
    return entry.name == change.name &&
           parameter_lines(entry.parameters) == parameter_lines(change.parameters);
  });
}

bool has(const Scene& scene, const Stage::Change& change) {
  switch (change.kind) {
    case SCREE_CONTACT_LAW:
      return has(scene.laws, change);
    case SCREE_BOUNDARY:
      return has(scene.boundaries, change);
    case SCREE_BODY_FORCE:
      return has(scene.body_forces, change);
    default:
      return false;
  }
}

// Probes begin in the first stage in which they record, so that they are followed in all stages if one needs
// a column.
std::shared_ptr<StageColumns> needed(const std::vector<Stage>& stages,
                                     std::shared_ptr<StageColumns> columns) {
  const bool any = std::any_of(stages.begin(), stages.end(),
                               [](const Stage& s) { return !s.duration && s.until.reads_columns(); });
  return any ? columns : nullptr;
}

}  // namespace

const char* name_of(StageEnd end) {
  constexpr const char* names[] = {"duration", "condition", "at_most"};
  return names[int(end)];
}

double duration_of(const std::vector<Stage>& stages) {
  double sum = stages.empty() ? NAN : 0;
  for (const Stage& stage : stages) sum += stage.duration.value_or(NAN);
  return sum;
}

StageRunner::StageRunner(Simulation& simulation, std::vector<Stage> stages,
                         std::shared_ptr<StageColumns> columns)
    : simulation_(simulation), stages_(std::move(stages)), columns_(needed(stages_, std::move(columns))) {
  if (!finished()) begin();
}

StageRunner::StageRunner(Simulation& simulation, std::vector<Stage> stages, const StateTransfer& state,
                         std::shared_ptr<StageColumns> columns)
    : simulation_(simulation), stages_(std::move(stages)), columns_(needed(stages_, std::move(columns))) {
  if (stages_.empty()) state.refuse("stage", "is one of a scenario without stages");
  transfer(state);
  if (began_step_ > simulation_.steps()) state.refuse("began_step", "is after the step of the state");
  const Stage& last = stages_.back();
  if (finished() && last.duration && steps_in(*last.duration) > steps()) --current_;
  if (!finished()) check_resumed();
}

void StageRunner::check_resumed() const {
  const Stage& stage = stages_[current_];
  if (const auto at_most = stage.until.at_most;
      !stage.duration && at_most && !stage.until.goes_on && steps() >= steps_of_limit(*at_most))
    throw Error(
        fmt::format("stage '{}' has taken {:g} s without meeting its conditions, and at_most is {:g} s; "
                    "give more time (--set \"stage.{}.until.at_most=<s>\")",
                    stage.name, simulation_.time() - began_, *at_most, stage.name));
  if (!stage.duration || steps_in(*stage.duration) > steps()) return;
  const auto [taken, duration] = told_apart(simulation_.time() - began_, *stage.duration);
  throw Error(
      fmt::format("stage '{}' has already taken {} s, and its duration is {} s; give a longer one, or begin "
                  "a new run from a state before (particles.state)",
                  stage.name, taken, duration));
}

void StageRunner::save(const StateTransfer& state) const { StageRunner(*this).transfer(state); }

void StageRunner::transfer(const StateTransfer& state) {
  state.value("stage", "", current_, stored::at_most(stages_.size()));
  state.value("began", "s", began_);
  state.value("began_step", "1", began_step_);
  if (state.has("last_end"))
    state.value("last_end", "", last_end_, stored::at_most(std::uint64_t(StageEnd::at_most)));
  if (columns_) columns_->transfer(state.below("columns"));
  if (state.restoring()) forget_values();
  for (std::size_t k = 0; k < values_.size(); ++k)
    if (const StateTransfer values = state.below(fmt::format("until/{}", k)); values.has("latest"))
      values_[k].transfer(values);
}

void StageRunner::forget_values() {
  values_.clear();
  if (finished() || stages_[current_].duration) return;
  for (const Condition& condition : stages_[current_].until.conditions) values_.emplace_back(condition);
}

void StageRunner::begin() {
  began_ = simulation_.time();
  began_step_ = simulation_.steps();
  forget_values();
  const Stage& stage = stages_[current_];
  // What the scene has had from t = 0 is not set again.
  const auto begun = [&](const Stage::Change& change) {
    return simulation_.steps() == 0 && has(simulation_.scene(), change);
  };
  if (std::all_of(stage.changes.begin(), stage.changes.end(), begun)) return;
  try {
    apply_changes();
  } catch (const Error& error) {
    throw error.at(fmt::format("stage '{}'", stage.name), error.status());
  }
}

void StageRunner::apply_changes() {
  for (const Stage::Change& change : stages_[current_].changes) {
    if (change.kind == SCREE_CONTACT_LAW) simulation_.reconfigure_law(change.name, change.parameters);
    if (change.kind == SCREE_BOUNDARY)
      simulation_.reconfigure_boundary(change.name, change.parameters, change.going_on);
    if (change.kind == SCREE_BODY_FORCE)
      simulation_.reconfigure_body_force(change.name, change.parameters, change.going_on);
  }
  simulation_.apply_reconfiguration();
}

std::uint64_t StageRunner::steps_in(double duration) const {
  return std::uint64_t(std::llround(duration / simulation_.step_length()));
}

std::uint64_t StageRunner::steps_of_limit(double at_most) const {
  return std::max<std::uint64_t>(steps_in(at_most), 1);
}

std::uint64_t StageRunner::steps_to_next_check() const {
  const Stage& stage = stages_[current_];
  const std::uint64_t steps = this->steps();
  const auto left = [&](std::uint64_t last) { return last > steps ? last - steps : 1; };
  const std::uint64_t due = columns_ ? left(columns_->next(simulation_, stage.name, steps)) : unlimited;
  if (stage.duration) return std::min(due, left(steps_in(*stage.duration)));
  const std::uint64_t next_test = condition_interval - steps % condition_interval;
  const std::uint64_t next = stage.until.reads_energies() || !columns_ ? std::min(due, next_test) : due;
  return stage.until.at_most ? std::min(next, left(steps_of_limit(*stage.until.at_most))) : next;
}

bool StageRunner::take_values() {
  bool taken = false;
  const Stage& stage = stages_[current_];
  for (std::size_t k = 0; k < values_.size(); ++k) {
    const Condition& condition = stage.until.conditions[k];
    if (condition.probe != Condition::energies) {
      if (const auto value = columns_->value(condition.probe, condition.column))
        values_[k].take(simulation_.time(), *value), taken = true;
    } else if (steps() % condition_interval == 0 && steps() >= steps_in(stage.until.at_least)) {
      values_[k].take(simulation_.time(), kinetic_over_elastic(simulation_));
      taken = true;
    }
  }
  return taken;
}

bool StageRunner::conditions_met() const {
  const auto met = [](const ConditionValues& values) { return values.met(); };
  return stages_[current_].until.any ? std::any_of(values_.begin(), values_.end(), met)
                                     : std::all_of(values_.begin(), values_.end(), met);
}

bool StageRunner::over() {
  const Stage& stage = stages_[current_];
  if (columns_) columns_->take(simulation_, stage.name, steps());
  if (stage.duration) return steps() >= steps_in(*stage.duration);
  // Only where a value was taken: how often this is called depends on outputs.
  return take_values() && steps() >= steps_in(stage.until.at_least) && conditions_met();
}

void StageRunner::check_next() {
  if (current_ + 1 >= stages_.size()) return;
  const Stage& next = stages_[current_ + 1];
  try {
    for (const Stage::Change& change : next.changes)
      if (change.kind == SCREE_BOUNDARY)
        simulation_.check_returning_walls(change.name, change.parameters, change.going_on);
  } catch (const Error& error) {
    next_is_refused_ = true;
    throw error.at(fmt::format("stage '{}'", next.name), ExitStatus::not_reached);
  }
}

void StageRunner::end_stage(StageEnd end) {
  check_next();
  last_end_ = end;
  ++current_;
  if (finished())
    values_.clear();
  else
    begin();
}

void StageRunner::fail() const {
  const Stage& stage = stages_[current_];
  std::vector<std::string> problems;
  for (const ConditionValues& values : values_)
    if (!values.met()) problems.push_back(values.problem());
  const auto moving = stage.until.reads_energies() ? movers(simulation_) : std::nullopt;
  // As a shell and an override take it.
  const bool plain =
      stage.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
      stage.name.npos;
  const std::string key = plain                ? "stage." + stage.name
                          : stages_.size() > 1 ? fmt::format("stage[{}]", current_)
                                               : "stage";
  throw Error(fmt::format("stage '{}': after {:g} s {}{}; {}, raise until.at_most (scree resume DIR --set "
                          "{}.until.at_most=<s> goes on from here), or set until.otherwise = \"go_on\"",
                          stage.name, simulation_.time() - began_, fmt::join(problems, ", and "),
                          moving ? ": " + moving->what : "",
                          moving                         ? moving->cure
                          : stage.until.reads_energies() ? "add damping"
                                                         : "check that it can be reached",
                          key),
              ExitStatus::not_reached);
}

std::string StageRunner::status() const {
  std::vector<std::string> parts;
  for (const ConditionValues& values : values_)
    if (values.latest()) parts.push_back(values.status());
  return fmt::format("{}", fmt::join(parts, "; "));
}

void StageRunner::step() {
  run(1, [] { return false; });
}

std::uint64_t StageRunner::run(std::uint64_t steps, const std::function<bool()>& proceed) {
  const Stage& stage = stages_[current_];
  if (columns_ && this->steps() == 0) columns_->take(simulation_, stage.name, 0);
  const std::uint64_t taken = simulation_.run(std::min(steps, steps_to_next_check()), proceed);
  const std::optional<double> at_most = stage.until.at_most;
  if (over()) {
    end_stage(stage.duration ? StageEnd::duration : StageEnd::condition);
  } else if (!stage.duration && at_most && this->steps() >= steps_of_limit(*at_most)) {
    if (!stage.until.goes_on) fail();
    end_stage(StageEnd::at_most);
  }
  return taken;
}

std::optional<double> StageRunner::progress() const {
  if (finished()) return 1;
  double left = began_ - simulation_.time();
  for (std::size_t k = current_; k < stages_.size(); ++k) {
    if (!stages_[k].duration) return std::nullopt;
    left += *stages_[k].duration;
  }
  const double done = simulation_.time();
  return done / (done + std::max(0.0, left));
}

std::size_t stage_of(const StateTransfer& state) {
  std::size_t stage = 0;
  state.value("stage", "", stage);
  return stage;
}

Scene scene_in_stage(Scene scene, const std::vector<Stage>& stages, std::size_t stage) {
  const auto set = [](auto& entries, const Stage::Change& change) {
    for (auto& entry : entries)
      if (entry.name == change.name) entry.parameters = change.parameters;
  };
  for (std::size_t k = 0; k < std::min(stage + 1, stages.size()); ++k)
    for (const Stage::Change& change : stages[k].changes) {
      if (change.kind == SCREE_CONTACT_LAW) set(scene.laws, change);
      if (change.kind == SCREE_BOUNDARY) set(scene.boundaries, change);
      if (change.kind == SCREE_BODY_FORCE) set(scene.body_forces, change);
    }
  return scene;
}

}  // namespace scree
