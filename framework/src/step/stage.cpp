#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/energy.hpp>
#include <scree/error.hpp>
#include <scree/stage.hpp>

namespace scree {

namespace {

// Steps between tests of a condition on energies, which are sums over all bodies.
constexpr std::uint64_t condition_interval = 100;

}  // namespace

StageRunner::StageRunner(Simulation& simulation, std::vector<Stage> stages)
    : simulation_(simulation), stages_(std::move(stages)) {
  if (!finished()) begin();
}

void StageRunner::begin() {
  began_ = simulation_.time();
  began_step_ = simulation_.steps();
  kinetic_over_elastic_.reset();
  const Stage& stage = stages_[current_];
  if (stage.changes.empty()) return;
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
  const std::uint64_t steps = simulation_.steps() - began_step_;
  const auto left = [&](std::uint64_t last) { return last > steps ? last - steps : 1; };
  if (stage.duration) return left(steps_in(*stage.duration));
  const std::uint64_t next_test = condition_interval - steps % condition_interval;
  // One step early, because run() compares times, not step counts.
  return stage.at_most ? std::min(next_test, left(std::max<std::uint64_t>(steps_in(*stage.at_most), 1) - 1))
                       : next_test;
}

bool StageRunner::over() {
  const Stage& stage = stages_[current_];
  const std::uint64_t steps = simulation_.steps() - began_step_;
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

}  // namespace scree
