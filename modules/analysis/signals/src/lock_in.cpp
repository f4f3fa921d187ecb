#include "lock_in_columns.hpp"
#include "triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::signals {

namespace {

// The state: these numbers, then sums of columns times value, then those of columns times columns.
enum Entry : std::size_t { count, start, last, reference, square, head };

// A phase in (-pi, pi].
double wrapped(double angle) {
  const double turn = 2 * std::numbers::pi;
  const double rest = std::remainder(angle, turn);
  return rest <= -std::numbers::pi ? rest + turn : rest;
}

// The fit of a state: what result() computes from it.
class Fit {
 public:
  Fit(const LockInOptions& options, std::span<const double> state, std::size_t model, std::size_t columns)
      : options_(options),
        state_(state),
        model_(model),
        triangle_(state.data() + head + columns, columns),
        z_(triangle_.forward({state.data() + head, state.data() + head + columns})),
        theta_(triangle_.backward(z_, model)) {
    for (std::size_t k = 0; k < model; ++k)
      if (!triangle_.has(k))
        throw Error(
            fmt::format("lock-in: the {} samples do not tell drift and {} harmonics of {} Hz apart; give "
                        "more samples per period, a longer record or fewer terms",
                        state[count], options.harmonics, options.frequency));
  }

  double residual() const {  // sum of squares
    double rest = state_[square];
    for (std::size_t k = 0; k < model_; ++k) rest -= z_[k] * z_[k];
    return std::max(rest, 0.0);
  }
  double mean() const { return state_[reference] + theta_[0]; }

  Line line(int harmonic, double noise) const {
    const std::size_t s = std::size_t(options_.drift_degree + 1 + 2 * (harmonic - 1)), c = s + 1;
    Line line;
    line.frequency = harmonic * options_.frequency;
    line.amplitude = std::hypot(theta_[s], theta_[c]);
    const double at_start = std::atan2(theta_[c], theta_[s]);
    const double turns = line.frequency * (options_.origin - state_[start]);
    line.phase = wrapped(at_start + 2 * std::numbers::pi * (turns - std::floor(turns)));
    const double cosine = std::cos(at_start), sine = std::sin(at_start);
    line.amplitude_error = std::sqrt(noise * variance(s, cosine, sine));
    const double across = std::sqrt(noise * variance(s, -sine, cosine));
    line.phase_error = line.amplitude > 0 || std::isnan(across) ? across / line.amplitude
                                                                : std::numeric_limits<double>::infinity();
    line.noise_density = 2 * noise * (state_[last] - state_[start]) / state_[count];
    return line;
  }

  // Variance of the noise per sample, as far as it lies near a harmonic; `first`: its columns, advanced to the next.
  double noise(int harmonic, std::size_t& first) const {
    double energy = 0;
    int freedom = 0;
    const std::size_t end = first + 4 * noise_offsets(options_, harmonic).size();
    for (; first < end; ++first) {
      energy += z_[first] * z_[first];
      freedom += triangle_.has(first);
    }
    constexpr int least_freedom = 4;
    return freedom >= least_freedom ? energy / freedom : white_noise();
  }

 private:
  double white_noise() const {
    const double freedom = state_[count] - double(model_);
    return freedom > 0 ? residual() / freedom : std::numeric_limits<double>::quiet_NaN();
  }

  // Of a theta[s] + b theta[s + 1] for noise of variance 1.
  double variance(std::size_t s, double a, double b) const {
    std::vector<double> direction(model_);
    direction[s] = a, direction[s + 1] = b;
    double sum = 0;
    for (const double w : triangle_.forward(direction)) sum += w * w;
    return sum;
  }

  const LockInOptions& options_;
  std::span<const double> state_;
  std::size_t model_;
  Triangle triangle_;
  std::vector<double> z_, theta_;
};

}  // namespace

std::size_t LockIn::state_size(const LockInOptions& options) {
  check(options);
  const std::size_t columns = all_columns(options);
  return head + columns + Triangle::size(columns);
}

LockIn::LockIn(const LockInOptions& options, std::span<double> state)
    : options_(options), state_(state), model_(model_columns(options)), columns_(all_columns(options)) {
  if (state.size() != state_size(options))
    throw Error(fmt::format("lock-in: a state of {} numbers; give {}", state.size(), state_size(options)));
}

void LockIn::add(double time, double value) {
  if (state_[count] == 0) state_[start] = time, state_[reference] = value;
  state_[count] += 1;
  state_[last] = time;
  double column[most_columns];
  fill_columns(options_, time - state_[start], column);
  const double x = value - state_[reference];
  state_[square] += x * x;
  double* products = state_.data() + head;
  for (std::size_t i = 0; i < columns_; ++i) products[i] += column[i] * x;
  double* row = products + columns_;
  for (std::size_t i = 0; i < columns_; row += ++i)
    for (std::size_t j = 0; j <= i; ++j) row[j] += column[i] * column[j];
}

std::size_t LockIn::samples() const { return std::size_t(state_[count]); }

LockInResult LockIn::result() const {
  if (state_[count] < double(model_))
    throw Error(fmt::format("lock-in: {} samples for {} unknowns; give more samples", state_[count], model_));
  if (!std::isfinite(state_[square]))
    throw Error("lock-in: a value is not finite or beyond 1e150; leave it out, or give another unit");
  const Fit fit(options_, state_, model_, columns_);
  LockInResult result;
  result.harmonics = std::size_t(options_.harmonics);
  result.samples = samples();
  result.mean = fit.mean();
  result.residual_rms = std::sqrt(fit.residual() / state_[count]);
  std::size_t column = model_;
  for (int h = 1; h <= options_.harmonics; ++h) {
    const double noise = fit.noise(h, column);
    result.lines[std::size_t(h - 1)] = fit.line(h, noise);
  }
  return result;
}

}  // namespace scree::signals
