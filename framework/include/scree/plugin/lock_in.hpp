#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include <scree/error.hpp>
#include <scree/plugin/cholesky_factor.hpp>
#include <scree/plugin/formatted.hpp>
#include <scree/plugin/lock_in_columns.hpp>

namespace scree {

// A lock-in fits, by least squares and sample by sample,
//   x(t) = drift + sum over h = 1..harmonics of A_h sin(2 pi h f (t - origin) + phi_h).
// Samples may have any distances in time, if they determine the terms.
//
// drift: a polynomial of degree d (Legendre polynomials of 2 (t - t0) / duration - 1), fitted with the rest,
// so that such a drift changes no amplitude. What a polynomial leaves of another drift, r(t), changes A_1 by
// at most
//   (2 max|r| + V(r)) / (pi f T),   T: length of the record, V: total variation of r,
// from (2/T) |integral of r exp(-2 pi i f t)| by parts, to first order in 1 / (f T). Any polynomial gives a
// bound.
//
// Errors are standard errors from the noise of the record near h f. Columns at h f ± k/T are fitted after the
// model; the energy that they take from the residual, per degree of freedom, is the noise per sample near h
// f, in the metric that scales the covariance of the fit. k = 1 is left out: the window of the record, and a
// slightly different frequency, put there what belongs to the line. k up to 6 is near enough for noise that
// follows 1/f: its mean over f ± k/T exceeds that at f by 18 / (f T)^2. Offsets beyond 0.4 f are not used:
// below f T = 5 there are none, and the noise comes from the whole residual, as if it were white.
//
// The mean of a fitted amplitude A with the error s is sqrt(A^2 + s^2): one of few errors may be noise alone.

// A sine in a record.
struct SpectralLine {
  double frequency = 0;        // (Hz)
  double amplitude = 0;        // (unit of x) 0 or more
  double phase = 0;            // (rad) of a sine, in (-pi, pi]
  double amplitude_error = 0;  // (unit of x) standard error; NaN if the record is too short for one
  double phase_error = 0;      // (rad) likewise; above about 1 the phase is unknown
  // (unit of x)^2/Hz, one-sided, near the line: amplitude_error^2 T for many periods.
  double noise_density = 0;
};

struct LockInResult {
  std::array<SpectralLine, 3> lines;  // of f, 2 f, 3 f; the first `harmonics` are filled
  std::size_t harmonics = 0;
  std::size_t samples = 0;
  double mean = 0;          // (unit of x) of the fitted drift over `duration`
  double residual_rms = 0;  // (unit of x) of x minus the fit, accurate to 1e-7 of the rms of x - x(t0)
};

// The memory is the caller's, so that a probe can keep it with the state of the run.
class LockIn {
 public:
  // Number of doubles that a lock-in keeps, whatever the length of the record: 24 to 1133. Throws Error as
  // below.
  static std::size_t state_size(const LockInOptions& options) {
    lock_in_columns::check(options);
    const std::size_t columns = lock_in_columns::of_all(options);
    return head + columns + CholeskyFactor::size(columns);
  }

  // Continues from `state`; all zeros: no sample yet. Throws Error for options out of range or another size.
  LockIn(const LockInOptions& options, std::span<double> state)
      : options_(options),
        state_(state),
        model_(lock_in_columns::of_model(options)),
        columns_(lock_in_columns::of_all(options)) {
    if (state.size() != state_size(options))
      throw Error(formatted("lock-in: a state of %zu numbers; give %zu", state.size(), state_size(options)));
  }

  // Adds a sample, at any time (s); value below 1e150 in size. Inlined, so that its loops have the flags of
  // the caller.
  [[gnu::always_inline]] void add(double time, double value) {
    if (state_[count] == 0) state_[start] = time, state_[reference] = value;
    state_[count] += 1;
    state_[last] = time;
    double column[lock_in_columns::most];
    lock_in_columns::fill(options_, time - state_[start], column);
    const double x = value - state_[reference];
    state_[square] += x * x;
    double* products = state_.data() + head;
    for (std::size_t i = 0; i < columns_; ++i) products[i] += column[i] * x;
    double* row = products + columns_;
    for (std::size_t i = 0; i < columns_; row += ++i)
      for (std::size_t j = 0; j <= i; ++j) row[j] += column[i] * column[j];
  }

  std::size_t samples() const { return std::size_t(state_[count]); }  // so far

  // Throws Error if there are too few samples or if their times do not determine the terms.
  LockInResult result() const {
    if (state_[count] < double(model_))
      throw Error(
          formatted("lock-in: %.10g samples for %zu unknowns; give more samples", state_[count], model_));
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

 private:
  // The state: these numbers, then the sums of columns times value, then the sums of columns times columns.
  enum Place : std::size_t { count, start, last, reference, square, head };

  // A phase in (-pi, pi].
  static double wrapped(double angle) {
    const double turn = 2 * std::numbers::pi;
    const double rest = std::remainder(angle, turn);
    return rest <= -std::numbers::pi ? rest + turn : rest;
  }

  // The least squares of a state. theta_: coefficients of the model; z_: of all columns made orthogonal in
  // order.
  class Fit {
   public:
    Fit(const LockInOptions& options, std::span<const double> state, std::size_t model, std::size_t columns)
        : options_(options),
          state_(state),
          model_(model),
          factor_(state.data() + head + columns, columns),
          z_(factor_.forward({state.data() + head, state.data() + head + columns})),
          theta_(factor_.backward(z_, model)) {
      for (std::size_t k = 0; k < model; ++k)
        if (!factor_.has(k))
          throw Error(formatted(
              "lock-in: the %.10g samples do not tell drift and %d harmonics of %.10g Hz apart; give more "
              "samples per period, a longer record or fewer terms",
              state[count], options.harmonics, options.frequency));
    }

    double residual() const {  // sum of squares
      double rest = state_[square];
      for (std::size_t k = 0; k < model_; ++k) rest -= z_[k] * z_[k];
      return std::max(rest, 0.0);
    }
    double mean() const { return state_[reference] + theta_[0]; }

    // noise: variance per sample.
    SpectralLine line(int harmonic, double noise) const {
      const std::size_t s = std::size_t(options_.drift_degree + 1 + 2 * (harmonic - 1)), c = s + 1;
      SpectralLine line;
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

    // Variance per sample of the noise near a harmonic. first: the first column beside it; moves on to the
    // next one's.
    double noise(int harmonic, std::size_t& first) const {
      double energy = 0;
      int freedom = 0;
      const std::size_t end = first + 4 * lock_in_columns::noise_offsets(options_, harmonic).size();
      for (; first < end; ++first) {
        energy += z_[first] * z_[first];
        freedom += factor_.has(first);
      }
      constexpr int least_freedom = 4;
      return freedom >= least_freedom ? energy / freedom : white_noise();
    }

   private:
    double white_noise() const {
      const double freedom = state_[count] - double(model_);
      return freedom > 0 ? residual() / freedom : std::numeric_limits<double>::quiet_NaN();
    }

    // Variance of a theta[s] + b theta[s + 1] for noise of variance 1.
    double variance(std::size_t s, double a, double b) const {
      std::vector<double> direction(model_);
      direction[s] = a, direction[s + 1] = b;
      double sum = 0;
      for (const double w : factor_.forward(direction)) sum += w * w;
      return sum;
    }

    const LockInOptions& options_;
    std::span<const double> state_;
    std::size_t model_;
    CholeskyFactor factor_;
    std::vector<double> z_, theta_;
  };

  LockInOptions options_;
  std::span<double> state_;
  std::size_t model_ = 0, columns_ = 0;
};

}  // namespace scree
