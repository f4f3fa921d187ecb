#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/energy.hpp>
#include <scree/error.hpp>
#include <scree/scene_record.hpp>
#include <scree/stage.hpp>
#include <scree/told_apart.hpp>

namespace scree {

namespace {

// Steps between tests of a condition on energies, which are sums over all bodies.
constexpr std::uint64_t condition_interval = 100;

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

}  // namespace

double duration_of(const std::vector<Stage>& stages) {
  double sum = stages.empty() ? NAN : 0;
  for (const Stage& stage : stages) sum += stage.duration.value_or(NAN);
  return sum;
}

StageRunner::StageRunner(Simulation& simulation, std::vector<Stage> stages)
    : simulation_(simulation), stages_(std::move(stages)) {
  if (!finished()) begin();
}

StageRunner::StageRunner(Simulation& simulation, std::vector<Stage> stages, const StateTransfer& state)
    : simulation_(simulation), stages_(std::move(stages)) {
  if (stages_.empty()) state.refuse("stage", "is one of a scenario without stages");
  transfer(state);
  if (began_step_ > simulation_.steps()) state.refuse("began_step", "is after the step of the state");
  const Stage& last = stages_.back();
  if (finished() && last.duration && steps_in(*last.duration) > steps()) --current_;
  if (!finished()) check_resumed();
}

void StageRunner::check_resumed() const {
  const Stage& stage = stages_[current_];
  if (!stage.duration || steps_in(*stage.duration) > steps()) return;
  const auto [taken, duration] = told_apart(simulation_.time() - began_, *stage.duration);
  throw Error(fmt::format("stage '{}' has already taken {} s, and its duration is {} s; give a longer one",
                          stage.name, taken, duration));
}

void StageRunner::save(const StateTransfer& state) const { StageRunner(*this).transfer(state); }

void StageRunner::transfer(const StateTransfer& state) {
  state.value("stage", "", current_, stored::at_most(stages_.size()));
  state.value("began", "s", began_);
  state.value("began_step", "1", began_step_);
  double ratio = kinetic_over_elastic_.value_or(-1);
  state.value("kinetic_over_elastic", "1", ratio, stored::any);
  kinetic_over_elastic_ = ratio >= 0 ? std::optional(ratio) : std::nullopt;
}

void StageRunner::begin() {
  began_ = simulation_.time();
  began_step_ = simulation_.steps();
  kinetic_over_elastic_.reset();
  const Stage& stage = stages_[current_];
  // What the scene has had from t = 0 is not set again.
  const auto begun = [&](const Stage::Change& change) {
    return simulation_.steps() == 0 && has(simulation_.scene(), change);
  };
  if (std::all_of(stage.changes.begin(), stage.changes.end(), begun)) return;
  for (const Stage::Change& change : stage.changes) {
    if (change.kind == SCREE_CONTACT_LAW) simulation_.reconfigure_law(change.name, change.parameters);
    if (change.kind == SCREE_BOUNDARY) simulation_.reconfigure_boundary(change.name, change.parameters);
    if (change.kind == SCREE_BODY_FORCE) simulation_.reconfigure_body_force(change.name, change.parameters);
  }
  simulation_.apply_reconfiguration();
}

std::uint64_t StageRunner::steps_in(double duration) const {
  return std::uint64_t(std::llround(duration / simulation_.step_length()));
}

std::uint64_t StageRunner::steps_to_next_check() const {
  const Stage& stage = stages_[current_];
  const std::uint64_t steps = this->steps();
  const auto left = [&](std::uint64_t last) { return last > steps ? last - steps : 1; };
  if (stage.duration) return left(steps_in(*stage.duration));
  const std::uint64_t next_test = condition_interval - steps % condition_interval;
  // One step early, because run() compares times, not step counts.
  return stage.at_most ? std::min(next_test, left(std::max<std::uint64_t>(steps_in(*stage.at_most), 1) - 1))
                       : next_test;
}

bool StageRunner::over() {
  const Stage& stage = stages_[current_];
  const std::uint64_t steps = this->steps();
  if (stage.duration) return steps >= steps_in(*stage.duration);
  if (!stage.kinetic_over_elastic || steps % condition_interval || steps < steps_in(stage.at_least))
    return false;
  const scree_energy energy = simulation_.energy();
  const double elastic = elastic_energy(energy);
  kinetic_over_elastic_ = elastic > 0 ? kinetic_energy(energy) / elastic : INFINITY;
  return elastic > 0 && kinetic_energy(energy) < *stage.kinetic_over_elastic * elastic;
}

void StageRunner::step() {
  run(1, [] { return false; });
}

std::uint64_t StageRunner::run(std::uint64_t steps, const std::function<bool()>& proceed) {
  const std::uint64_t taken = simulation_.run(std::min(steps, steps_to_next_check()), proceed);
  const Stage& stage = stages_[current_];
  if (over()) {
    ++current_;
    if (!finished()) begin();
  } else if (stage.at_most && simulation_.time() - began_ >= *stage.at_most) {
    const scree_energy energy = simulation_.energy();
    const double elastic = elastic_energy(energy);
    throw Error(
        fmt::format(
            "stage '{}': kinetic/elastic energy is {:.3g} after {:g} s and has not fallen below {:g}; "
            "raise until.at_most or until.kinetic_over_elastic, or add damping",
            stage.name, elastic > 0 ? kinetic_energy(energy) / elastic : INFINITY,
            simulation_.time() - began_, *stage.kinetic_over_elastic),
        ExitStatus::failure);
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
