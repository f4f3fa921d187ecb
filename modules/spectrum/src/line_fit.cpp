#include "line_fit.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace scree::spectrum {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// By how much the frequency of a sine near to `frequency` differs from it (Hz), in first order: with u from -1 to 1 over the record,
// a sin + b cos turns in u (a cos - b sin). Sines that grow with u take up a change of amplitude, powers of u the drift.
double correction(double frequency, std::span<const double> times, std::span<const double> values) {
  using Column = Eigen::Matrix<double, 8, 1>;
  const double half = 0.5 * (times.back() - times.front()), middle = times.front() + half;
  Eigen::Matrix<double, 8, 8> gram = Eigen::Matrix<double, 8, 8>::Zero();
  Column right = Column::Zero();
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double since = times[k] - middle, u = since / half, turn = two_pi * frequency * since;
    const double sine = std::sin(turn), cosine = std::cos(turn);
    const Column column = (Column() << sine, cosine, u * sine, u * cosine, 1, u, u * u, u * u * u).finished();
    gram.selfadjointView<Eigen::Lower>().rankUpdate(column);
    right += (values[k] - values[0]) * column;
  }
  const Column fit = gram.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  const double square = fit[0] * fit[0] + fit[1] * fit[1];
  // Without a sine no frequency is nearer.
  return square > 0 ? (fit[0] * fit[3] - fit[1] * fit[2]) / square / (two_pi * half) : 0;
}

std::vector<double> without_others(std::span<const double> times, std::span<const double> values,
                                   const std::vector<FoundLine>& lines, std::size_t number) {
  std::vector<double> rest(values.begin(), values.end());
  for (std::size_t n = 0; n < lines.size(); ++n)
    if (n != number) subtract(lines[n], times, rest);
  return rest;
}

}  // namespace

void subtract(const FoundLine& line, std::span<const double> times, std::vector<double>& values) {
  for (std::size_t k = 0; k < times.size(); ++k)
    values[k] -= line.amplitude * std::sin(two_pi * line.frequency * times[k] + line.phase);
}

FoundLine fitted_line(double frequency, std::span<const double> times, std::span<const double> values) {
  const double duration = times.back() - times.front(), middle = times.front() + 0.5 * duration;
  constexpr int most_rounds = 4;  // each squares what is left, in units of 1 / duration
  constexpr double small = 1e-4;
  for (int k = 0; k < most_rounds; ++k) {
    const double change = correction(frequency, times, values);
    frequency += change;
    if (std::abs(change) * duration < small) break;
  }
  LockInOptions options;
  options.frequency = frequency;
  options.harmonics = 1;
  options.drift_degree = 3;
  FoundLine line{lock_in(times, values, options).lines[0]};
  line.frequency_error = std::sqrt(3.0) * line.phase_error / (std::numbers::pi * duration);
  line.phase_error = std::hypot(line.phase_error, two_pi * middle * line.frequency_error);
  return line;
}

void fit_together(std::span<const double> times, std::span<const double> values,
                  std::vector<FoundLine>& lines, const std::function<void(double)>& on_progress) {
  const std::size_t count = lines.size();
  for (std::size_t round = 0; round < rounds_together && count > 1; ++round)
    for (std::size_t n = 0; n < count; ++n) {
      on_progress(double(round * count + n) / double(rounds_together * count));
      lines[n] = fitted_line(lines[n].frequency, times, without_others(times, values, lines, n));
    }
}

}  // namespace scree::spectrum
