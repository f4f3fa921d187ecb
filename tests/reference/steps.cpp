// The part of Passage that makes a step on a smooth branch of the law.

#include "passage.hpp"

#include <algorithm>
#include <stdexcept>

namespace reference {

namespace {

// The part of the duration after which the forces are smooth.
constexpr double opening_part = 0.1;

double fourth_power(double x) { return x * x * x * x; }
double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }

}  // namespace

void Passage::choose_clock() {
  const Instant now = motion_.instant(state_, branch_);
  const double leaving = now.normal_velocity * duration_ / now.overlap;  // overlaps per duration
  if (clock_ == Clock::opening && state_[at::time] > opening_part * duration_) set_clock(Clock::running, now);
  if (clock_ == Clock::running && !branch_.growing && now.overlap < 0.3 * largest_overlap_ && leaving > 0.3)
    set_clock(Clock::closing, now);
  if (clock_ == Clock::closing && leaving < 0.1) set_clock(Clock::running, now);
}

void Passage::set_clock(Clock clock, const Instant& now) {
  step_ *= time_per_clock(now, 0);
  clock_ = clock;
  if (clock == Clock::closing) closing_begin_ = mark_ = fourth_root(now.overlap);
  step_ /= time_per_clock(now, 0);
}

double Passage::time_per_clock(const Instant& now, double elapsed) const {
  if (clock_ == Clock::opening) return 4 * std::pow(mark_ + elapsed, 3);
  if (clock_ == Clock::closing) return 4 * std::pow(mark_ - elapsed, 3) / now.normal_velocity;
  return 1;
}

double Passage::longest_step() const {
  if (clock_ == Clock::opening) return 0.1 * fourth_root(opening_part * duration_);
  if (clock_ == Clock::closing) return std::min(0.1 * closing_begin_, mark_);
  return 0.02 * duration_;
}

// While the Coulomb limit is so low that an error of the direction hardly matters, the equation of the
// direction is stiff.
void Passage::choose_relaxed() {
  if (branch_.grip != Grip::slide && branch_.grip != Grip::relaxed) return;
  Branch relaxed = branch_;
  relaxed.grip = Grip::relaxed;
  const Instant now = motion_.instant(state_, relaxed);
  const double speed = norm(now.tangential_velocity);
  // The time in which the direction follows, and so its lag in parts of the turning of the velocity, of which
  // the first order is known as long as the limit changes slowly. With SlipRule::total it is not, and the
  // direction takes part in the energy of the spring that the dashpot stretches.
  const double pull = now.stiffness * speed;
  const double lag = now.limit / (pull * duration_);
  const bool total = motion_.total_rule();
  const double weight = total ? 100 * (1 + now.damping * speed_scale_ / force_scale_) : 1;
  const double error = total ? weight * lag : lag * (lag + std::abs(now.limit_rate) / pull);
  const double most = settings_.relaxed_limit * motion_.law().friction * force_scale_ / now.limit;
  if (branch_.grip == Grip::relaxed) {
    if (error < 2 * most) return;
    branch_.grip = Grip::slide;
    put(state_, at::spring, now.slide_direction);
  } else if (now.limit_rate < 0 && error < most) {
    const double deviation = norm(get(state_, at::spring) - now.slide_direction);
    if (weight * deviation * (total ? 1 : std::min(lag, 1.0)) < most) branch_ = relaxed;
  }
}

State Passage::rates(double elapsed, State state) const {
  if (clock_ == Clock::closing) {
    const double root = mark_ - elapsed;
    if (root <= 0) return {};  // every rate has a factor of the overlap
    state[at::overlap] = fourth_power(root);
  }
  const Instant now = motion_.instant(state, branch_);
  State rates = motion_.rates(now, state, branch_);
  const double factor = time_per_clock(now, elapsed);
  for (double& rate : rates) rate *= factor;
  return rates;
}

// How much an error of the sliding direction matters, at most one: as much as the limit, which is its force;
// with SlipRule::total also to the energy of the spring that the dashpot stretches, with a margin as it
// drives the spring.
double Passage::direction_weight() const {
  const Instant now = motion_.instant(state_, branch_);
  double weight = now.limit / (motion_.law().friction * force_scale_);
  if (motion_.total_rule()) weight *= 1000 * (1 + now.damping * speed_scale_ / force_scale_);
  return std::clamp(weight, 1e-12, 1.0);
}

State Passage::error_scales(const State& end) const {
  const double m = motion_.effective_mass(), v = std::max(settings_.approach_speed, 1e-4 * speed_scale_);
  State scales;
  const auto fill = [&](std::size_t first, std::size_t count, double scale) {
    std::fill_n(scales.begin() + static_cast<std::ptrdiff_t>(first), count, scale);
  };
  const auto larger = [&](std::size_t i) { return std::max(norm(get(state_, i)), norm(get(end, i))); };
  fill(at::time, 1, duration_);
  fill(at::overlap, 1, std::max(state_[at::overlap], end[at::overlap]) + 1e-9 * overlap_scale_);
  fill(at::displacement_a, 6, overlap_scale_);
  const Body a = motion_.body_a(state_);
  const std::variant<Body, Wall> other = motion_.other(state_);
  const Body b = std::holds_alternative<Body>(other) ? std::get<Body>(other) : a;
  fill(at::velocity_a, 3, v * m / a.mass);
  fill(at::velocity_b, 3, v * m / b.mass);
  fill(at::spin_a, 3, v * m / (a.mass * a.radius));
  fill(at::spin_b, 3, v * m / (b.mass * b.radius));
  fill(at::spring, 3, larger(at::spring) + 1e-9 * overlap_scale_);
  if (branch_.grip == Grip::slide) fill(at::spring, 3, 1 / direction_weight());
  fill(at::normal_impulse, 4, m * v);
  fill(at::normal, 5, m * v * speed_scale_);
  for (double& scale : scales) scale *= settings_.tolerance;
  return scales;
}

double Passage::error(const RungeKuttaStep<std::tuple_size_v<State>>& step) const {
  const State scales = error_scales(step.end);
  double fifth = 0, third = 0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double a = step.fifth_order_error[i] / scales[i], b = step.third_order_error[i] / scales[i];
    if (!std::isfinite(a) || !std::isfinite(b)) return 1e100;
    fifth = std::max(fifth, std::abs(a));
    third = std::max(third, std::abs(b));
  }
  return fifth == 0 ? 0 : fifth * fifth / std::sqrt(fifth * fifth + 0.01 * third * third);
}

// The end of the longest step that is exact enough, and a proposal for the next.
State Passage::try_step(const State& first) {
  for (int i = 0; i < 200; ++i) {
    const auto rates = [&](double elapsed, const State& state) { return this->rates(elapsed, state); };
    const auto step = dormand_prince_step(state_, first, step_, rates);
    const double size = error(step);
    if (size <= 1) return step.end;
    step_ *= std::max(0.1, 0.9 * std::pow(size, -0.125));
  }
  throw std::runtime_error("no step is exact enough");
}

}  // namespace reference
