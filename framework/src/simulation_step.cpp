#include "health.hpp"
#include "motion.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <scree/simulation.hpp>

namespace scree {

void Simulation::drift_bodies(double step) {
  Laps laps(profile_);
  integrator_->prepare(particles_, step);
  threads_->each(tiles_.parts(), [&](std::size_t part, unsigned) {
    const BodyRange bodies = tiles_.part(part);
    (part_sums_[part] = {}).square_speed = integrator_->drift(particles_, step, bodies);
    Forces::clear(particles_, bodies);
  });
  laps.lap(Profile::integrate);
}

void Simulation::settle(std::size_t part, const Moves& moves, Profile* profile) {
  Laps laps(profile);
  const BodyRange bodies = tiles_.part(part);
  PartSums& sums = part_sums_[part] = {};
  sums.momentum.add(particles_, bodies);
  laps.lap(Profile::books);
  body_terms_.apply(particles_, boundaries_.domain(), bodies, sums.bodies);
  laps.lap(Profile::body_forces);
  if (moves.kick && moves.drift) {
    const auto moved = integrator_->kick_and_drift(particles_, *moves.kick, *moves.drift, bodies);
    sums.finite = moved.finite;
    sums.square_speed = moved.square_speed;
    Forces::clear(particles_, bodies);
  } else if (moves.kick) {
    sums.finite = integrator_->kick(particles_, *moves.kick, bodies);
  }
  laps.lap(Profile::integrate);
}

bool Simulation::evaluate_forces(double step, const Moves& moves) {
  drifted_ = moves.drift.has_value();
  contact_sums_ = forces_.evaluate(
      particles_, contacts_, laws_, boundaries_.planes(), boundaries_.loads(), boundaries_.domain(), step,
      *threads_,
      [&](std::size_t part, unsigned worker) { settle(part, moves, worker == 0 ? profile_ : nullptr); },
      profile_);
  body_sums_ = {};
  MomentumAudit::Sums momentum;
  bool finite = true;
  for (const PartSums& sums : part_sums_) {
    body_sums_ += sums.bodies;
    momentum.add(sums.momentum);
    finite &= sums.finite;
  }
  momentum_audit_.add_step(step, momentum, boundaries_.loads());
  return finite;
}

void Simulation::evaluate_forces_afresh(double step) {
  Forces::clear(particles_, {0, particles_.size()});
  evaluate_forces(step, {});
}

void Simulation::step() { step(false); }

std::uint64_t Simulation::run(std::uint64_t steps, const std::function<bool()>& proceed) {
  std::uint64_t made = 0;
  for (bool more = steps > 0; more;) {
    more = ++made < steps && proceed();
    step(more);
  }
  return made;
}

void Simulation::step(bool more) {
  const std::span<const double> shares = integrator_->substeps();
  double largest = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    std::optional<double> next;
    if (k + 1 < shares.size() || more) next = shares[(k + 1) % shares.size()] * scene_.step;
    largest = advance(shares[k] * scene_.step, next);
  }
  ++steps_;
  time_ = double(steps_) * scene_.step;
  force_time_ = integrator_->evaluates_at_mid_step() ? time_ - 0.5 * scene_.step : time_;
  max_square_speed_ = std::max(max_square_speed_, largest);
  check_health(largest);
}

double Simulation::advance(double step, std::optional<double> next) {
  const bool mid_step = integrator_->evaluates_at_mid_step();
  const bool in_step = force_time_ == time_;
  const double elapsed = mid_step && in_step ? 0.5 * step : step;
  if (mid_step && !in_step) boundaries_.return_to_forces();
  Laps laps(profile_);
  boundaries_.drift(force_time_, elapsed);
  const double plane_speed = boundaries_.largest_speed();
  laps.lap(Profile::boundaries);
  if (!drifted_) drift_bodies(step);
  double square_speed = 0;
  for (const PartSums& sums : part_sums_) square_speed = std::max(square_speed, sums.square_speed);
  laps = Laps(profile_);
  if (!(std::isfinite(square_speed) && std::isfinite(plane_speed))) report_blow_up(*this, speed_limit_);
  neighbours_.update(std::sqrt(square_speed), plane_speed, std::abs(step), particles_, boundaries_, contacts_,
                     *threads_);
  laps.lap(Profile::neighbours);
  // What goes wrong is reported where it happened.
  if (too_fast(square_speed) || may_be_too_deep(std::max(std::sqrt(square_speed), plane_speed) * step))
    next.reset();
  const bool finite = evaluate_forces(elapsed, {.kick = step, .drift = next});
  laps = Laps(profile_);
  boundaries_.kick(force_time_, elapsed);
  laps.lap(Profile::boundaries);
  if (scene_.audit) audit_.add_step(elapsed, contact_sums_, body_sums_);
  force_time_ += elapsed;
  time_ += step;
  if (mid_step) boundaries_.run_ahead_of_forces(0.5 * step);
  return finite ? square_speed : infinity;
}

void Simulation::catch_up() {
  if (force_time_ == time_) return;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    for (int k = 0; k < scene_.dimension; ++k) particles_.mid_velocity()[k][i] = particles_.velocity()[k][i];
    for (int k = particles_.spin_axes().first; k < particles_.spin_axes().last; ++k)
      particles_.mid_spin()[k][i] = particles_.spin()[k][i];
  }
  const double behind = time_ - force_time_;
  boundaries_.return_to_forces();
  boundaries_.drift(force_time_, behind);
  evaluate_forces_afresh(behind);
  boundaries_.kick(force_time_, behind);
  if (scene_.audit) audit_.add_step(behind, contact_sums_, body_sums_);
  force_time_ = time_;
}

double Simulation::largest_square_speed() const {
  double largest = 0;
  for (const Body& body : scene_.bodies) largest = std::max(largest, dot(body.velocity, body.velocity));
  return largest;
}

bool Simulation::too_fast(double square_speed) const {
  return !(square_speed <= speed_limit_ * speed_limit_);
}

bool Simulation::may_be_too_deep(double way) const {
  return contact_sums_.max_overlap_ratio + 2 * std::abs(way) / smallest_radius_ > scene_.limits.overlap_ratio;
}

bool Simulation::too_deep() const { return contact_sums_.max_overlap_ratio > scene_.limits.overlap_ratio; }

void Simulation::check_health(double largest_square_speed) const {
  if (too_fast(largest_square_speed) || too_deep()) report_blow_up(*this, speed_limit_);
}

}  // namespace scree
