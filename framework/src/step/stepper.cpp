#include "step/stepper.hpp"

#include "motion/motion.hpp"
#include "ranks/rank_vote.hpp"
#include "step/simulation_parts.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <scree/state_transfer.hpp>

// Sequence of a substep from t to t + h (one per step; five in `fourth_order`):
//
//   bodies begin      Integrator::begin_step       positions to t + h, velocities predicted there
//                     DrivenBodies                 only if bodies are held in part, moved or loaded by a group
//                     Orientations::rotate         only if the scene carries them
//   walls begin       Boundaries::begin_step       planes to t + h, with the loads at t
//                     DisplacedLoads::load             only for boundaries that try displacements
//   search            NeighbourList::update        only when the skin may be used up
//                     SimulationParts::keep_neighbours_near   sorts bodies in memory, only when they have mixed
//   each tile         kernel::evaluate_tile        gather, geometry, law, scatter, block by block
//   each part         Forces::collect              adds loads computed by other tiles to its bodies
//                     MomentumAudit, BodyForces    gravity, drag, ...
//                     Integrator::finish_step      velocities at t + h
//                     Integrator::begin_step       of the next substep, unless the bodies are observed before
//   walls finish      Boundaries::finish_step      velocities and energies, with the loads at t + h
//   audit             EnergyAudit::add_step
//   health            Stepper::step                finite, speed and overlap within their limits
//
// `position_verlet` evaluates at t + h/2: forces, loads and springs between steps are then of mid-step,
// and wall positions are extrapolated by h/2 for output.

namespace scree {

Stepper::Stepper(SimulationParts& parts)
    : parts_(parts), tiles_(parts.particles.size()), part_sums_(tiles_.parts()) {
  take_own_parts();
}

void Stepper::take_own_parts() {
  own_parts_ = own_parts(tiles_, parts_.share ? parts_.share->owners : TileOwners(tiles_.count()));
  part_sums_.assign(tiles_.parts(), {});
}

bool Stepper::step(Next next, const std::function<void(double)>* after_substep) {
  const double h = parts_.scene.step;
  const std::span<const double> shares = parts_.integrator->substeps();
  double square_speed = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    substep_ = k;
    std::optional<double> following;
    const bool goes_on = k + 1 < shares.size() ? !after_substep : next == Next::follows;
    if (goes_on) following = shares[(k + 1) % shares.size()] * h;
    const std::optional<double> moved = substep(shares[k] * h, following);
    if (!moved) return false;
    if (after_substep) (*after_substep)(shares[k] * h);
    square_speed = *moved;
  }
  ++steps_;
  time_ = double(steps_) * h;
  force_time_ = forces_at_ == ForcesAt::middle_of_step ? time_ - 0.5 * h : time_;
  max_square_speed_ = std::max(max_square_speed_, square_speed);
  return !too_fast(square_speed) && !too_deep();
}

std::optional<double> Stepper::substep(double step, std::optional<double> next) {
  SimulationParts& p = parts_;
  p.forget_copies();
  const bool mid_step = p.integrator->evaluates_at_mid_step();
  const double elapsed = mid_step && forces_at_ == ForcesAt::end_of_step ? 0.5 * step : step;
  if (forces_at_ == ForcesAt::middle_of_step) p.boundaries.undo_extrapolation();
  const DrivenBodies::Times times = {time_, step, force_time_, elapsed, mid_step};
  if (!bodies_advanced_) begin_bodies(times);
  add_work_of_begun_step();
  const double square_speed = begun_square_speed_, speed = std::sqrt(square_speed);
  if (!std::isfinite(square_speed)) return std::nullopt;

  Laps laps(p.profile);
  if (const double displacement_speed = p.boundaries.displacement_speed(); displacement_speed > 0) {
    p.neighbours.extend(speed * std::abs(step), displacement_speed * std::abs(elapsed), p.particles,
                        p.boundaries, p.contacts, *p.threads);
    p.keep_neighbours_near();
  }
  laps.lap(Profile::neighbours);
  begin_walls(elapsed, step);
  const double plane_speed = p.boundaries.largest_speed();
  const double surface_speed = p.boundaries.largest_surface_speed(p.neighbours.surface_reach()),
               wall_speed = std::max(plane_speed, surface_speed);
  // A surface, which has bodies on both sides, may go through one that it passes within a step.
  if (!std::isfinite(wall_speed) || too_fast(surface_speed * surface_speed)) return std::nullopt;
  laps.lap(Profile::boundaries);

  p.neighbours.update(speed, plane_speed, surface_speed, std::abs(step), p.particles, p.boundaries,
                      p.contacts, *p.threads);
  p.keep_neighbours_near();
  laps.lap(Profile::neighbours);

  // Do not start the next step when a limit may be exceeded, so that errors are reported for the right time.
  if (too_fast(square_speed) || may_become_too_deep(std::max(speed, wall_speed) * step)) next.reset();
  if (p.driven.any()) plan_driven(times, next);
  const bool finite = evaluate_forces(elapsed, {.finish = step, .begin = next});

  laps = Laps(p.profile);
  finish_walls(elapsed);
  laps.lap(Profile::boundaries);
  if (p.scene.audit) p.audit.add_step(elapsed, p.contact_sums, p.body_sums);
  force_time_ += elapsed;
  time_ += step;
  forces_at_ = mid_step ? ForcesAt::middle_of_step : ForcesAt::end_of_step;
  if (mid_step) p.boundaries.extrapolate(0.5 * step);
  return finite ? square_speed : infinite_speed;
}

void Stepper::begin_walls(double step, double kick) {
  if (!parts_.share) return move_walls(step, kick);
  parts_.share->failure.guard([&] { move_walls(step, kick); });
  if (parts_.displaced_loads) parts_.displaced_loads->finish(parts_.scene.dimension);
}

// All ranks do the same: if one fails here, all do.
void Stepper::finish_walls(double step) {
  SimulationParts& p = parts_;
  if (!p.share) return p.boundaries.finish_step(force_time_, step);
  p.share->failure.guard([&] { p.boundaries.finish_step(force_time_, step); });
  if (p.share->failure.any()) p.share->failure.throw_on_all(p.share->ranks);
}

void Stepper::move_walls(double step, double kick) {
  SimulationParts& p = parts_;
  if (p.boundaries.displacement_speed() == 0) return p.boundaries.begin_step(force_time_, step);
  if (!p.displaced_loads) p.displaced_loads.emplace(p.forces.features(), p.share ? &*p.share : nullptr);
  p.boundaries.begin_step(force_time_, step, [&](std::size_t plane, const double* displacement) {
    return p.displaced_loads->load(
        {p.particles, p.contacts, p.laws, p.boundaries.planes(), p.boundaries.domain(), step, kick}, plane,
        displacement);
  });
}

void Stepper::begin_bodies(const DrivenBodies::Times& times) {
  SimulationParts& p = parts_;
  Laps laps(p.profile);
  const double step = times.step;
  if (p.driven.any()) {
    p.driven.plan_begin(times);
    p.driven.prepare(*p.integrator, p.particles, step, p.own_places());
  } else {
    p.integrator->prepare(p.particles, step, p.own_places());
  }
  p.threads->each(own_parts_.size(), [&](std::size_t k, unsigned) {
    const std::size_t part = own_parts_[k];
    const BodyRange bodies = tiles_.part(part);
    PartSums& sums = part_sums_[part] = {};
    if (p.driven.any_in(part)) return begin_driven(part, bodies, step, sums);
    sums.square_speed = p.integrator->begin_step(p.particles, step, bodies);
    if (p.particles.orientations) rotate(bodies, {.begin = step});
    Forces::clear(p.particles, bodies);
  });
  begun_square_speed_ = largest_of_parts();
  RankSums sums(p.ranks());
  sums.largest(begun_square_speed_);
  sums.close();
  laps.lap(Profile::integrate);
}

void Stepper::begin_driven(std::size_t part, BodyRange bodies, double step, PartSums& sums) {
  SimulationParts& p = parts_;
  sums.square_speed = p.driven.begin_step(*p.integrator, p.particles, step, bodies, part);
  if (p.particles.orientations) rotate(bodies, {.begin = step});
  sums.work_to_begin = p.driven.predict(p.particles, part);
  Forces::clear(p.particles, bodies);
}

void Stepper::move_driven(std::size_t part, BodyRange bodies, const Moves& moves, PartSums& sums) {
  SimulationParts& p = parts_;
  p.driven.add_loads(p.particles, part);
  sums.work = p.driven.work(p.particles, part);
  if (!moves.finish) return;
  sums.finite = p.driven.finish_step(*p.integrator, p.particles, *moves.finish, bodies, part);
  if (p.particles.orientations) rotate(bodies, {.finish = moves.finish});
  if (moves.begin) begin_driven(part, bodies, *moves.begin, sums);
}

void Stepper::plan_driven(const DrivenBodies::Times& now, std::optional<double> next) {
  SimulationParts& p = parts_;
  p.driven.plan_finish(now);
  if (!next) return;
  const Clock clock = clock_after_substep(now.step, now.elapsed);
  p.driven.plan_begin({clock.time, *next, clock.force_time, *next, now.mid_step});
}

Stepper::Clock Stepper::clock_after_substep(double step, double elapsed) const {
  const SimulationParts& p = parts_;
  if (substep_ + 1 < p.integrator->substeps().size()) return {time_ + step, force_time_ + elapsed};
  const double time = double(steps_ + 1) * p.scene.step;
  return {time, p.integrator->evaluates_at_mid_step() ? time - 0.5 * p.scene.step : time};
}

void Stepper::clear_loads() {
  for (const BodyRange& range : parts_.own_places()) Forces::clear(parts_.particles, range);
}

void Stepper::reevaluate_forces(double elapsed) {
  clear_loads();
  parts_.driven.plan_finish({time_, 0, time_, 0, false});
  evaluate_forces(elapsed, {});
}

void Stepper::synchronise() {
  if (forces_at_ == ForcesAt::end_of_step) return;
  SimulationParts& p = parts_;
  for (const BodyRange& range : p.own_places())
    for (std::size_t i = range.begin; i < range.end; ++i) {
      for (int k = 0; k < p.scene.dimension; ++k)
        p.particles.mid_velocity()[k][i] = p.particles.velocity()[k][i];
      for (int k = p.particles.spin_axes().first; k < p.particles.spin_axes().last; ++k)
        p.particles.mid_spin()[k][i] = p.particles.spin()[k][i];
    }
  const double behind = time_ - force_time_;
  const DrivenBodies::Times times = {time_, 0, force_time_, behind, true};
  p.driven.plan_begin(times);
  for (const std::uint32_t part : own_parts_)
    part_sums_[part].work_to_begin = p.driven.predict(p.particles, part);
  add_work_of_begun_step();
  p.boundaries.undo_extrapolation();
  begin_walls(behind, 0);
  clear_loads();
  p.driven.plan_finish(times);
  evaluate_forces(behind, {});
  finish_walls(behind);
  if (p.scene.audit) p.audit.add_step(behind, p.contact_sums, p.body_sums);
  force_time_ = time_;
  forces_at_ = ForcesAt::end_of_step;
}

bool Stepper::initial_state_is_sound() const {
  double largest = 0;
  for (const Body& body : parts_.scene.bodies) largest = std::max(largest, dot(body.velocity, body.velocity));
  return !too_fast(largest) && !too_deep();
}

double Stepper::max_speed() const { return std::sqrt(max_square_speed_); }

bool Stepper::too_fast(double square_speed) const {
  return !(square_speed <= parts_.speed_limit * parts_.speed_limit);
}

bool Stepper::too_deep() const {
  return parts_.contact_sums.max_overlap_ratio > parts_.scene.limits.overlap_ratio;
}

bool Stepper::may_become_too_deep(double distance) const {
  return parts_.contact_sums.max_overlap_ratio + 2 * std::abs(distance) / parts_.facts.smallest_radius >
         parts_.scene.limits.overlap_ratio;
}

void Stepper::transfer(const StateTransfer& state) {
  constexpr std::uint64_t most_steps = std::uint64_t(1)
                                       << 53;  // times are exact multiples of the step up to here
  state.value("time", "s", time_);
  state.value("steps", "1", steps_, stored::at_most(most_steps));
  state.value("force_time", "s", force_time_);
  state.value("forces_at", "", forces_at_, stored::at_most(std::uint64_t(ForcesAt::middle_of_step)));
  state.value("max_square_speed", "m^2/s^2", max_square_speed_, stored::non_negative);
}

double Stepper::forces_behind(const State& state) {
  const StateTransfer clock = StateTransfer::restoring_from(state).below("clock");
  double time = 0, force_time = 0;
  clock.value("time", "s", time);
  clock.value("force_time", "s", force_time);
  return time - force_time;
}

void Stepper::set_time(double time) {
  const double step = parts_.scene.step;
  steps_ = std::uint64_t(std::llround(time / step));
  time_ = force_time_ = double(steps_) * step;
}

void Stepper::begin_anew() {
  force_time_ -= time_;
  time_ = 0;
  steps_ = 0;
}

}  // namespace scree
