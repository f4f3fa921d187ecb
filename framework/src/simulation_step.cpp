#include "health.hpp"
#include "motion.hpp"

#include <algorithm>
#include <cmath>

#include <scree/simulation.hpp>

namespace scree {

double Simulation::drift_bodies(double step) {
  integrator_->prepare(particles_, step);
  threads_->each(tiles_.count(), [&](std::size_t tile, unsigned worker) {
    Laps laps(worker == 0 ? profile_ : nullptr);
    tile_sums_[tile].square_speed = 0;
    tiles_.each_few(tile, [&](BodyRange bodies) {
      const double largest = integrator_->drift(particles_, step, bodies);
      tile_sums_[tile].square_speed = std::max(tile_sums_[tile].square_speed, largest);
    });
    laps.lap(Profile::drift);
  });
  double largest = 0;
  for (const TileSums& sums : tile_sums_) largest = std::max(largest, sums.square_speed);
  return largest;
}

bool Simulation::evaluate_forces(double step, std::optional<double> kick) {
  Laps laps(profile_);
  contact_sums_ = forces_.evaluate(particles_, contacts_, laws_, boundaries_.planes(), boundaries_.loads(),
                                   boundaries_.domain(), step, *threads_);
  laps.lap(Profile::contacts);
  threads_->each(tiles_.count(), [&](std::size_t tile, unsigned worker) {
    Laps tile_laps(worker == 0 ? profile_ : nullptr);
    TileSums& sums = tile_sums_[tile] = {};
    forces_.collect(particles_, tile);
    tile_laps.lap(Profile::sums);
    tiles_.each_few(tile, [&](BodyRange bodies) {
      sums.momentum.add(particles_, bodies);
      tile_laps.lap(Profile::books);
      body_terms_.apply(particles_, boundaries_.domain(), bodies, sums.bodies);
      tile_laps.lap(Profile::body_forces);
      if (kick) sums.finite &= integrator_->kick(particles_, *kick, bodies);
      tile_laps.lap(Profile::kick);
    });
  });
  body_sums_ = {};
  MomentumAudit::Sums momentum;
  bool finite = true;
  for (const TileSums& sums : tile_sums_) {
    body_sums_ += sums.bodies;
    momentum.add(sums.momentum);
    finite &= sums.finite;
  }
  momentum_audit_.add_step(step, momentum, boundaries_.loads());
  return finite;
}

void Simulation::step() {
  double largest = 0;
  for (const double share : integrator_->substeps()) largest = advance(share * scene_.step);
  ++steps_;
  time_ = double(steps_) * scene_.step;
  force_time_ = integrator_->evaluates_at_mid_step() ? time_ - 0.5 * scene_.step : time_;
  max_square_speed_ = std::max(max_square_speed_, largest);
  check_health(largest);
}

double Simulation::advance(double step) {
  const bool mid_step = integrator_->evaluates_at_mid_step();
  const bool in_step = force_time_ == time_;
  const double elapsed = mid_step && in_step ? 0.5 * step : step;
  if (mid_step && !in_step) boundaries_.return_to_forces();
  Laps laps(profile_);
  boundaries_.drift(force_time_, elapsed);
  const double plane_speed = boundaries_.largest_speed();
  laps.lap(Profile::boundaries);
  const double square_speed = drift_bodies(step);
  laps = Laps(profile_);
  if (!(std::isfinite(square_speed) && std::isfinite(plane_speed))) report_blow_up(*this, speed_limit_);
  neighbours_.update(std::sqrt(square_speed), plane_speed, std::abs(step), particles_, boundaries_,
                     contacts_);
  laps.lap(Profile::neighbours);
  const bool finite = evaluate_forces(elapsed, step);
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
  evaluate_forces(behind);
  boundaries_.kick(force_time_, behind);
  if (scene_.audit) audit_.add_step(behind, contact_sums_, body_sums_);
  force_time_ = time_;
}

double Simulation::largest_square_speed() const {
  double largest = 0;
  for (const Body& body : scene_.bodies) largest = std::max(largest, dot(body.velocity, body.velocity));
  return largest;
}

void Simulation::check_health(double largest_square_speed) const {
  const bool too_fast = !(largest_square_speed <= speed_limit_ * speed_limit_);
  const bool too_deep = contact_sums_.max_overlap_ratio > scene_.limits.overlap_ratio;
  if (too_fast || too_deep) report_blow_up(*this, speed_limit_);
}

}  // namespace scree
