// The part of Passage that locates the switches of the law within a step.

#include "passage.hpp"

#include <algorithm>

namespace reference {

namespace {

// Where rounding makes two switches call each other at one point, the motion goes on after these.
constexpr int most_immediate_switches = 6;

}  // namespace

Passage::Signals Passage::signals_of(const State& state) const {
  const Instant now = motion_.instant(state, branch_);
  Signals result;
  result.fill(-1);
  if (clock_ != Clock::closing) result[parting] = -state[at::overlap];
  result[pushing] = branch_.pushing ? -now.law_force : now.law_force;
  result[growing] = branch_.growing ? now.normal_velocity : -now.normal_velocity;
  const bool total = motion_.total_rule();
  const Vector whole = now.spring_force + now.damping * now.tangential_velocity;
  if (branch_.grip == Grip::stick)
    result[grip] = norm(total ? whole : now.spring_force) - now.limit;
  else if (branch_.grip != Grip::open)
    result[grip] = -now.slip_speed;
  if (branch_.grip != Grip::open && !total && now.damping > 0) {
    // While it slides, |C d + γ_t v_t| > C without the difference of nearly equal numbers.
    const double excess = branch_.grip == Grip::stick
                              ? norm(whole) - now.limit
                              : 2 * now.limit * dot(now.slide_direction, now.tangential_velocity) +
                                    now.damping * dot(now.tangential_velocity, now.tangential_velocity);
    result[clipping] = branch_.clipped ? -excess : excess;
  }
  if (next_sample_ < settings_.sample_times.size())
    result[sample] = state[at::time] - settings_.sample_times[next_sample_];
  return result;
}

int Passage::first_positive(const Signals& values, int except) const {
  for (int i = 0; i < signals; ++i)
    if (i != except && values[i] > 0) return i;
  return signals;
}

Passage::Piece Passage::piece(const State& first, double length) const {
  const auto rates = [&](double elapsed, const State& state) { return this->rates(elapsed, state); };
  Piece result{length, dormand_prince_step(state_, first, length, rates).end};
  if (clock_ == Clock::closing) {
    const double root = std::max(mark_ - length, 0.0);
    result.end[at::overlap] = root * root * root * root;
  }
  return result;
}

// The step, or the first part of it within which a switch comes and goes again; looked for on a cubic through
// it.
Passage::Piece Passage::first_suspect(const State& first, Piece whole) const {
  const State last = rates(whole.length, whole.end);
  for (const double x : {0.25, 0.5, 0.75}) {
    const double y = 1 - x;
    State middle;
    for (std::size_t i = 0; i < middle.size(); ++i)
      middle[i] = y * y * (1 + 2 * x) * state_[i] + x * x * (1 + 2 * y) * whole.end[i] +
                  x * y * whole.length * (y * first[i] - x * last[i]);
    if (clock_ == Clock::closing) {
      const double root = mark_ - x * whole.length;
      middle[at::overlap] = root * root * root * root;
    }
    if (first_positive(signals_of(middle), signals) == signals) continue;
    const Piece part = piece(first, x * whole.length);
    if (first_positive(signals_of(part.end), signals) != signals) return part;
  }
  return whole;
}

// The piece up to the first switch, and which; without one the whole.
Passage::Piece Passage::locate(const State& first, Piece whole, int& signal) const {
  if (immediate_ > most_immediate_switches) return whole;
  Piece found = first_suspect(first, whole);
  for (int i = 0; i < signals; ++i) {
    const int next = first_positive(signals_of(found.end), signal);
    if (next == signals) break;
    signal = next;
    found = root(first, found, signal);
    if (found.length == 0) break;
  }
  return found;
}

// The signal is positive at the upper end. At the lower it may be rounding, where the last switch has made it
// zero.
Passage::Piece Passage::root(const State& first, Piece upper, int signal) const {
  const double begin = signals_of(state_)[signal];
  if (begin < 0) return shrink(first, 0, begin, upper, signal);
  for (const double part : {0.5, 0.25, 0.0625, 1.0 / 256, 1.0 / 65536}) {
    const Piece lower = piece(first, part * upper.length);
    const double value = signals_of(lower.end)[signal];
    if (value < 0) return shrink(first, lower.length, value, upper, signal);
  }
  return {0, state_};
}

// False position with the Illinois rule, and at times bisection, against rounding that stops it.
Passage::Piece Passage::shrink(const State& first, double lower, double lower_value, Piece upper,
                               int signal) const {
  double upper_value = signals_of(upper.end)[signal];
  const double exact = 4e-16 * upper.length;
  int side = 0;
  for (int i = 1; i < 100 && upper.length - lower > exact; ++i) {
    double length = upper.length - upper_value * (upper.length - lower) / (upper_value - lower_value);
    if (i % 6 == 0) length = 0.5 * (lower + upper.length);
    length = std::clamp(length, lower + 0.5 * exact, upper.length - 0.5 * exact);
    Piece middle = piece(first, length);
    const double value = signals_of(middle.end)[signal];
    if (value == 0) return middle;
    if (value > 0) {
      upper = middle;
      upper_value = value;
      if (side > 0) lower_value *= 0.5;
      side = 1;
    } else {
      lower = length;
      lower_value = value;
      if (side < 0) upper_value *= 0.5;
      side = -1;
    }
  }
  return upper;
}

}  // namespace reference
