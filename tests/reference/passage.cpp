#include "passage.hpp"

#include <algorithm>
#include <stdexcept>

namespace reference {

namespace {

constexpr int most_steps = 400000;
// The part of the duration that is taken as a flight in the beginning.
constexpr double start_part = 1e-14;

double fourth_power(double x) { return x * x * x * x; }
double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }

}  // namespace

Passage::Passage(Motion& motion, Settings settings) : motion_(motion), settings_(std::move(settings)) {
  const double speed = settings_.approach_speed;
  duration_ = motion_.coefficients().duration(speed);
  force_scale_ = motion_.effective_mass() * speed / duration_;
  overlap_scale_ = speed * duration_ / 3;
}

void Passage::run() {
  begin();
  while (!ended_) {
    choose_clock();
    choose_relaxed();
    advance();
    if (++steps_ > most_steps) throw std::runtime_error("the contact does not end");
  }
  for (; next_sample_ < settings_.sample_times.size(); ++next_sample_) {
    if (settings_.sample_times[next_sample_] > state_[at::time]) break;
    records_.push_back({state_, branch_});
  }
}

void Passage::begin() {
  state_ = motion_.start();
  first_energy_ = motion_.kinetic_energy(state_);
  const double time = start_part * duration_;
  state_[at::time] = time;
  state_[at::overlap] = settings_.approach_speed * time;
  put(state_, at::displacement_a, time * get(state_, at::velocity_a));
  put(state_, at::displacement_b, time * get(state_, at::velocity_b));
  branch_.grip = motion_.law().friction == 0 ? Grip::open : Grip::stick;
  const Instant flight = motion_.instant(state_, branch_);
  speed_scale_ = std::max(settings_.approach_speed, norm(flight.tangential_velocity));
  if (std::isfinite(motion_.law().friction))
    motion_.set_lowest_limit(1e-12 * motion_.law().friction * force_scale_);
  // With k_t as the root of the overlap, q = ∫k_t v_t dt is two thirds of k_t v_t t.
  const bool rescaled = motion_.coefficients().hertz() && motion_.law().history == History::rescaled;
  put(state_, at::spring, (rescaled ? 2.0 / 3 : 1) * time * flight.tangential_velocity);
  begin_sliding_or_sticking(state_, motion_.instant(state_, branch_));
  mark_ = fourth_root(time);
  step_ = 0.5 * mark_;
}

// As the Coulomb limit begins to rise, with the spring that sticking has stretched until then.
void Passage::begin_sliding_or_sticking(State& state, const Instant& now) {
  if (branch_.grip == Grip::open) return;
  const bool total = motion_.total_rule();
  const Vector whole = now.spring_force + now.damping * now.tangential_velocity;
  const double pull = norm(total ? whole : now.spring_force);
  branch_.clipped = !total && now.damping > 0 && norm(whole) > now.limit;
  if (pull <= now.limit) return;
  put(state, at::spring, direction(whole));
  branch_.grip = Grip::relaxed;
  ++slides_;
  if (total) jump(state, now);
}

void Passage::advance() {
  step_ = std::min(step_, longest_step());
  const State first = rates(0, state_);
  const double wanted = step_;
  State end = try_step(first);
  if (clock_ == Clock::closing) end[at::overlap] = fourth_power(mark_ - step_);
  int signal = signals;
  const Piece done = locate(first, {step_, end}, signal);
  immediate_ = done.length > 0 ? 0 : immediate_ + 1;
  const bool whole = done.length == step_ && signal == signals;
  settle(done);
  if (signal != signals && !ended_) act(signal);
  if (whole && step_ == wanted) step_ *= 3;
  check_balance();
}

void Passage::settle(const Piece& piece) {
  state_ = piece.end;
  if (clock_ == Clock::opening) {
    mark_ += piece.length;
    state_[at::time] = fourth_power(mark_);
  } else if (clock_ == Clock::closing) {
    mark_ = std::max(mark_ - piece.length, 0.0);
    if (mark_ == 0) act(parting);
  }
  largest_overlap_ = std::max(largest_overlap_, state_[at::overlap]);
  if (branch_.grip == Grip::slide) put(state_, at::spring, direction(get(state_, at::spring)));
}

void Passage::check_balance() {
  const double lack = motion_.balance(state_, branch_) - (ended_ ? remaining_elastic_ : 0) - first_energy_;
  energy_residual_ = std::max(energy_residual_, std::abs(lack) / first_energy_);
}

void Passage::act(int signal) {
  switch (signal) {
    case parting:
      ended_ = true;
      if (branch_.pushing) pushing_time_ += state_[at::time] - pushing_since_;
      let_spring_go();
      break;
    case pushing:
      switch_pushing();
      break;
    case growing:
      branch_.growing = !branch_.growing;
      break;
    case grip:
      switch_grip();
      break;
    case clipping:
      branch_.clipped = !branch_.clipped;
      break;
    case sample:
      records_.push_back({state_, branch_});
      ++next_sample_;
      break;
    default:
      break;
  }
}

void Passage::switch_pushing() {
  if (branch_.pushing) {
    if (!motion_.total_rule()) let_spring_go();
    pushing_time_ += state_[at::time] - pushing_since_;
    branch_.pushing = branch_.clipped = false;
    branch_.grip = Grip::open;
    return;
  }
  pushing_since_ = state_[at::time];
  branch_.pushing = true;
  put(state_, at::spring, motion_.instant(state_, branch_).stretch);
  branch_.grip = motion_.law().friction == 0 ? Grip::open : Grip::stick;
  begin_sliding_or_sticking(state_, motion_.instant(state_, branch_));
}

void Passage::switch_grip() {
  const Instant now = motion_.instant(state_, branch_);
  ++switches_;
  if (branch_.grip == Grip::stick) {
    branch_.grip = Grip::slide;
    put(state_, at::spring, now.slide_direction);
    ++slides_;
    jump(state_, now);
  } else {
    branch_.grip = Grip::stick;
    put(state_, at::spring, now.stretch);
  }
}

// The spring jumps as sliding begins, with SlipRule::total or to a lower limit, which no force has worked
// for.
void Passage::jump(State& state, const Instant& before) const {
  const Instant after = motion_.instant(state, branch_);
  state[at::friction] +=
      0.5 * dot(before.spring_force, before.stretch) - 0.5 * dot(after.spring_force, after.stretch);
}

void Passage::let_spring_go() {
  const Instant now = motion_.instant(state_, branch_);
  remaining_elastic_ = 0.5 * dot(now.spring_force, now.stretch);
  state_[at::release] += remaining_elastic_;
}

}  // namespace reference
