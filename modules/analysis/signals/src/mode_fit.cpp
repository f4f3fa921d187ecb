#include "mode_fit.hpp"

#include "mode_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::signals {

namespace {

// Normal equations with columns of length 1, so that the scales of the parameters do not count. A parameter
// that is fixed has a column of length 0.
struct ScaledEquations {
  Eigen::VectorXd scale;
  Eigen::MatrixXd matrix;  // unit diagonal
  Eigen::VectorXd gradient;

  ScaledEquations(const Eigen::MatrixXd& derivatives, const Eigen::VectorXd& rest)
      : scale(derivatives.colwise().norm()) {
    for (double& length : scale)
      if (!(length > 0)) length = 1;
    const Eigen::MatrixXd unit = derivatives * scale.cwiseInverse().asDiagonal();
    matrix = unit.transpose() * unit;
    for (Eigen::Index k = 0; k < matrix.rows(); ++k)
      if (!(matrix(k, k) > 0)) matrix(k, k) = 1;
    gradient = unit.transpose() * rest;
  }
  Eigen::VectorXd step(double damping) const {
    Eigen::MatrixXd damped = matrix;
    damped.diagonal() *= 1 + damping;
    return -damped.ldlt().solve(gradient).cwiseQuotient(scale);
  }
};

bool is_valid(const ModeModel& model, const Eigen::VectorXd& at) {
  for (Eigen::Index p = 0; p < model.of_poles(); p += 4)
    if (!(at[p] > 0 && at[p + 1] > 0)) return false;
  return at.allFinite();
}

// Descends from `at`. Returns whether it came to rest.
bool descend(const ModeModel& model, Eigen::VectorXd& at) {
  constexpr int most_steps = 300;
  constexpr double least_damping = 1e-14, most_damping = 1e12, at_rest = 1e-15;
  Eigen::MatrixXd derivatives;
  Eigen::VectorXd rest = model.evaluate(at, &derivatives);
  double damping = 1e-3;
  for (int k = 0; k < most_steps; ++k) {
    const ScaledEquations equations(derivatives, rest);
    bool better = false;
    double change = 0;
    while (!better && damping < most_damping) {
      const Eigen::VectorXd next = at + equations.step(damping);
      const Eigen::VectorXd candidate =
          is_valid(model, next) ? model.evaluate(next, nullptr) : Eigen::VectorXd(rest * 2);
      better = candidate.squaredNorm() < rest.squaredNorm();  // not if it is NaN
      damping = better ? std::max(least_damping, damping / 10) : damping * 10;
      if (!better) continue;
      change = (next - at).cwiseProduct(equations.scale).norm() / at.cwiseProduct(equations.scale).norm();
      at = next;
    }
    if (!better || change < at_rest) return true;  // no step goes down further
    rest = model.evaluate(at, &derivatives);
  }
  return false;
}

// Akaike's criterion for normal residuals, corrected for few of them. All fits below round-off are equal.
double criterion_of(double residual, double square, double count, double parameters) {
  constexpr double round_off = 1e-26;
  const double spare = count - parameters - 2;
  if (spare < 1) return std::numeric_limits<double>::infinity();
  return count * std::log((residual + round_off * square) / count) + 2 * parameters +
         2 * parameters * (parameters + 1) / spare;
}

// Starts with poles alone, so that |H|^2 is positive.
void drop_background(const ModeModel& model, const ResponseSpectrum& response, Eigen::VectorXd& at) {
  at.tail(model.background()).setZero();
  double highest = 0;
  for (std::size_t k = 0; k < response.values.size(); ++k)
    highest = std::max(highest, std::norm(response.values[k] / response.factor(response.frequencies[k])));
  for (Eigen::Index p = 0; p < model.of_poles(); p += 4)
    at[p + 2] = highest * at[p] * at[p] * at[p + 1] * at[p + 1], at[p + 3] = 0;
}

double correlation_of(const Eigen::VectorXd& rest, Eigen::Index distance) {
  const Eigen::Index count = rest.size() - distance;
  return rest.head(count).dot(rest.tail(count)) / rest.squaredNorm();
}

// Number of residuals for each independent one: 1 + 2 times the sum of their correlations, up to the first
// distance at which chance explains it.
double correlated_residuals(const Eigen::VectorXd& rest, Eigen::Index stride) {
  const double by_chance = 2 / std::sqrt(double(rest.size()));
  double sum = 1;
  for (Eigen::Index distance = stride; distance < rest.size(); distance += stride) {
    const double correlation = correlation_of(rest, distance);
    if (!(correlation > by_chance)) break;
    sum += 2 * correlation;
  }
  return sum;
}

constexpr double least_share = 0.25;  // of a pole, over the change by the others

// R, or |R| of amplitudes.
std::complex<double> strength_of(const Pole& pole, bool only_amplitudes) {
  return only_amplitudes ? std::sqrt(std::max(pole.strength.real(), 0.0)) : pole.strength;
}

// d/df of R / (f0^2 - f^2 + i f w).
std::complex<double> slope(const Pole& pole, double f, bool only_amplitudes) {
  const std::complex<double> divisor((pole.frequency - f) * (pole.frequency + f), f * pole.width);
  return strength_of(pole, only_amplitudes) * std::complex(2 * f, -pole.width) / (divisor * divisor);
}

}  // namespace

ModeFit fit_modes(const ResponseSpectrum& response, const std::vector<Pole>& start, int degree) {
  const ModeModel model(response, start.size(), degree);
  Eigen::VectorXd at = model.start(start);
  if (!model.evaluate(at, nullptr).allFinite()) drop_background(model, response, at);
  ModeFit fit;
  fit.converged = is_valid(model, at) && descend(model, at);
  Eigen::MatrixXd derivatives;
  const Eigen::VectorXd rest = model.evaluate(at, &derivatives);
  fit.residual = rest.squaredNorm();
  const Eigen::Index stride = response.only_amplitudes ? 1 : 2;
  fit.correlation = correlation_of(rest, stride);
  double square = 0;
  for (const auto& value : response.values) square += std::norm(value);
  const double count = double(model.residuals()), parameters = double(model.free_parameters());
  fit.criterion = criterion_of(fit.residual, square, count, parameters);
  const double variance =
      count > parameters ? fit.residual / (count - parameters) : std::numeric_limits<double>::quiet_NaN();
  const double independent = count / correlated_residuals(rest, stride);
  if (independent < count) fit.excess = (count - parameters) / std::max(1.0, independent - parameters);
  const ScaledEquations equations(derivatives, rest);
  const Eigen::Index last = model.of_poles();
  const Eigen::MatrixXd inverse =
      equations.matrix.ldlt().solve(Eigen::MatrixXd::Identity(model.parameters(), model.parameters()));
  const auto lengths = equations.scale.cwiseInverse().asDiagonal();
  fit.covariance = (variance * (lengths * inverse * lengths)).topLeftCorner(last, last);
  for (Eigen::Index p = 0; p < last; p += 4) fit.poles.push_back({at[p], at[p + 1], {at[p + 2], at[p + 3]}});
  return fit;
}

FittedMode mode_of(const ModeFit& fit, std::size_t number, const ResponseSpectrum& response) {
  const bool only_amplitudes = response.only_amplitudes;
  const Pole& pole = fit.poles[number];
  const auto first = Eigen::Index(4 * number);
  const Eigen::Matrix4d covariance = fit.covariance.block<4, 4>(first, first);
  const auto error = [&](double f, double w, double re, double im) {
    const Eigen::Vector4d by(f, w, re, im);
    return std::sqrt(by.dot(covariance * by));
  };
  FittedMode mode;
  mode.frequency = pole.frequency, mode.frequency_error = error(1, 0, 0, 0);
  mode.width = pole.width, mode.width_error = error(0, 1, 0, 0);
  mode.quality = pole.frequency / pole.width;
  mode.quality_error = error(1 / pole.width, -mode.quality / pole.width, 0, 0);
  const std::complex<double> factor = response.factor(pole.frequency);
  const double area = pole.frequency * pole.width / std::abs(factor);
  const double size = std::abs(strength_of(pole, only_amplitudes));
  mode.amplitude = size / area;
  const std::complex<double> by_strength =
      only_amplitudes ? 0.5 / (size * area) : pole.strength / (size * area);
  mode.amplitude_error = error((response.derivative - 1) * mode.amplitude / pole.frequency,
                               -mode.amplitude / pole.width, by_strength.real(), by_strength.imag());
  mode.phase = only_amplitudes ? 0 : std::arg(pole.strength * factor);
  mode.together = fit.poles.size();
  mode.points = response.values.size();
  return mode;
}

bool stands_out(const ModeFit& fit, std::size_t number, bool only_amplitudes) {
  const Pole& pole = fit.poles[number];
  std::complex<double> others = 0;
  for (std::size_t k = 0; k < fit.poles.size(); ++k)
    if (k != number) others += slope(fit.poles[k], pole.frequency, only_amplitudes);
  const double height = std::abs(strength_of(pole, only_amplitudes)) / (pole.frequency * pole.width);
  return height >= least_share * pole.width * std::abs(others);
}

}  // namespace scree::signals
