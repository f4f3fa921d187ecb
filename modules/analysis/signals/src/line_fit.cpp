#include "line_fit.hpp"

#include "scree/signals/lock_in.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/Dense>

namespace scree::signals {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr Eigen::Index columns_of_wave = 4;
using Terms = Eigen::Matrix<double, 8, 1>;
using Gram = Eigen::Matrix<double, 8, 8>;

// Least squares of a wave with its first-order change. With s the time over a scale, a change of frequency
// adds s (a cos - b sin) to a sin + b cos, a change of decay -s (a sin + b cos). Powers of u, from -1 to 1
// over the record, take up the drift. The scale is half the record about its middle, or 1 / decay from its
// beginning.
struct Expansion {
  double reference, scale;
  Gram gram = Gram::Zero();
  Terms fit;
  double square = 0;  // sum of squares of the residual

  Expansion(const Wave& wave, std::span<const double> times, std::span<const double> values) {
    const double half = 0.5 * (times.back() - times.front()), middle = times.front() + half;
    reference = wave.decay > 0 ? times.front() : middle;
    scale = wave.decay > 0 ? std::min(half, 1 / wave.decay) : half;
    Terms right = Terms::Zero();
    double all = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const double since = times[k] - reference, s = since / scale, u = (times[k] - middle) / half;
      const double turn = two_pi * wave.frequency * since;
      const double size = wave.decay > 0 ? std::exp(-wave.decay * since) : 1;
      const double sine = size * std::sin(turn), cosine = size * std::cos(turn),
                   value = values[k] - values[0];
      Terms terms;
      terms << sine, cosine, s * sine, s * cosine, 1, u, u * u, u * u * u;
      gram.selfadjointView<Eigen::Lower>().rankUpdate(terms);
      right += value * terms;
      all += value * value;
    }
    fit = gram.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    square = std::max(0.0, all - fit.dot(right));
  }
  // a + i b: the wave is the imaginary part of (a + i b) exp(i turn).
  std::complex<double> strength() const { return {fit[0], fit[1]}; }
  // Changes of -decay and of 2 pi frequency, as real and imaginary part; 0 without a sine.
  std::complex<double> change() const {
    return std::norm(strength()) > 0 ? std::complex(fit[2], fit[3]) / strength() / scale : 0;
  }
};

constexpr double small = 1e-4;  // change of phase (turns) over the record; the next one is its square

// Whether a fitted decay still belongs to the wave it started from: of three periods or more, within a width
// of its frequency.
bool is_of(const Wave& start, const Wave& wave, double duration) {
  constexpr double fewest_periods = 3, least_quality = 2, furthest = 2;  // (resolutions)
  return wave.frequency * duration > fewest_periods &&
         std::numbers::pi * wave.frequency > least_quality * wave.decay &&
         std::abs(wave.frequency - start.frequency) < furthest / duration + wave.decay / two_pi;
}

// Newton's method for the frequency and, with `decays`, the decay. Returns whether it came to rest.
bool improve(Wave& wave, bool decays, int most_rounds, std::span<const double> times,
             std::span<const double> values, const PassDone& pass_done) {
  const double duration = times.back() - times.front();
  const Wave start = wave;
  for (int k = 0; k < most_rounds; ++k) {
    const Expansion at(wave, times, values);
    if (pass_done) pass_done();
    std::complex<double> change = at.change();
    if (decays) {
      const double largest = std::max(wave.decay, 1 / duration);
      if (std::abs(change) > largest) change *= largest / std::abs(change);
      if (!(wave.decay - change.real() > 0)) return false;
      wave.decay -= change.real();
    } else {
      change = {0, change.imag()};
    }
    wave.frequency += change.imag() / two_pi;
    wave.reference = at.reference;
    wave.amplitude = std::abs(at.strength()), wave.phase = std::arg(at.strength());
    if (decays && !is_of(start, wave, duration)) return false;
    if (std::abs(change) * duration < two_pi * small) return true;
  }
  return !decays;
}

constexpr int most_rounds = 4;

// The line of a wave that decays. A lock-in to the residual gives the noise near the line.
FoundLine decaying_line(const Wave& wave, std::span<const double> times, std::span<const double> values,
                        const LockInOptions& options) {
  const Expansion at(wave, times, values);
  std::vector<double> rest(values.begin(), values.end());
  add(wave, -1, times, rest);
  const double noise = lock_in(times, rest, options).lines[0].amplitude_error;
  const Gram inverse = Gram(at.gram.selfadjointView<Eigen::Lower>()).ldlt().solve(Gram::Identity());
  const Eigen::Matrix4d covariance =
      0.5 * double(times.size()) * noise * noise * inverse.topLeftCorner<columns_of_wave, columns_of_wave>();
  const double a = at.fit[0], b = at.fit[1], square = a * a + b * b, amplitude = std::sqrt(square);
  const auto error = [&](const Eigen::Vector4d& by) { return std::sqrt(by.dot(covariance * by)); };
  const Eigen::Vector4d of_decay = Eigen::Vector4d(0, 0, -a, -b) / (square * at.scale),
                        of_frequency = Eigen::Vector4d(0, 0, -b, a) / (square * at.scale * two_pi),
                        of_phase = Eigen::Vector4d(-b, a, 0, 0) / square;
  FoundLine line;
  line.frequency = wave.frequency, line.frequency_error = error(of_frequency);
  line.amplitude = wave.amplitude, line.amplitude_error = error(Eigen::Vector4d(a, b, 0, 0) / amplitude);
  line.phase = std::remainder(wave.phase - two_pi * wave.frequency * wave.reference, two_pi);
  line.phase_error = error(of_phase - two_pi * wave.reference * of_frequency);
  line.quality = std::numbers::pi * wave.frequency / wave.decay;
  line.quality_error =
      error(std::numbers::pi / wave.decay * of_frequency - line.quality / wave.decay * of_decay);
  line.noise_density = noise * noise * (times.back() - times.front());
  return line;
}

}  // namespace

double Wave::value(double time) const {
  const double since = time - reference, size = decay > 0 ? std::exp(-decay * since) : 1;
  return amplitude * size * std::sin(two_pi * frequency * since + phase);
}

void add(const Wave& wave, double sign, std::span<const double> times, std::vector<double>& values) {
  for (std::size_t k = 0; k < times.size(); ++k) values[k] += sign * wave.value(times[k]);
}

Wave fitted_wave(double frequency, std::span<const double> times, std::span<const double> values,
                 const PassDone& pass_done) {
  Wave wave;
  wave.frequency = frequency;
  improve(wave, false, most_rounds, times, values, pass_done);
  return wave;
}

void let_decay(Wave& wave, std::span<const double> times, std::span<const double> values,
               const PassDone& pass_done) {
  constexpr std::array decays = {1.0, 4.0, 16.0, 64.0, 256.0};  // over the record
  constexpr double least_change = 0.1;  // of the amplitude over half the record, to look for one
  constexpr int most_rounds_of_decay = 12;
  const double duration = times.back() - times.front();
  const Expansion steady(wave, times, values);
  const double change = -steady.change().real() * 0.5 * duration;
  if (wave.decay > 0 || (wave.amplitude > 0 && change < least_change)) return;
  Wave best = wave;
  double least = steady.square;
  for (const double decay : decays) {
    Wave candidate = wave;
    candidate.decay = decay / duration;
    const double square = Expansion(candidate, times, values).square;
    if (pass_done) pass_done();
    if (square < least) least = square, best = candidate;
  }
  if (best.decay > 0 && improve(best, true, most_rounds_of_decay, times, values, pass_done) &&
      Expansion(best, times, values).square < steady.square)
    wave = best;
}

void refit(Wave& wave, std::span<const double> times, std::span<const double> values,
           const PassDone& pass_done) {
  const Wave before = wave;
  improve(wave, wave.decay > 0, most_rounds, times, values, pass_done);
  if (wave.decay > 0 && !is_of(before, wave, times.back() - times.front())) wave = before;
}

FoundLine line_of(const Wave& wave, std::span<const double> times, std::span<const double> values) {
  constexpr double least_over_error = 5;  // of a decay
  const double duration = times.back() - times.front(), middle = times.front() + 0.5 * duration;
  Wave steady = wave;
  LockInOptions options;
  options.frequency = wave.frequency;
  options.harmonics = 1;
  options.drift_degree = 3;
  if (wave.decay > 0) {
    const FoundLine line = decaying_line(wave, times, values, options);
    if (!(line.quality < least_over_error * line.quality_error)) return line;
    steady.decay = 0;
    improve(steady, false, most_rounds, times, values, {});
    options.frequency = steady.frequency;
  }
  FoundLine line{lock_in(times, values, options).lines[0]};
  line.frequency_error = std::sqrt(3.0) * line.phase_error / (std::numbers::pi * duration);
  line.phase_error = std::hypot(line.phase_error, two_pi * middle * line.frequency_error);
  return line;
}

}  // namespace scree::signals
