#include "mode_fit.hpp"

#include "mode_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::signals {

namespace {

// Columns of length 1 keep the scales of parameters out of the equations; what is fixed has length 0.
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

// Goes down from `at`; whether it came to rest.
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
      const Eigen::VectorXd trial =
          is_valid(model, next) ? model.evaluate(next, nullptr) : Eigen::VectorXd(rest * 2);
      better = trial.squaredNorm() < rest.squaredNorm();  // not if it is NaN
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

// Akaike's criterion for normal residuals, corrected for few of them. Below round-off all fits are equal.
double criterion_of(double residual, double square, double count, double parameters) {
  constexpr double round_off = 1e-26;
  const double spare = count - parameters - 2;
  if (spare < 1) return std::numeric_limits<double>::infinity();
  return count * std::log((residual + round_off * square) / count) + 2 * parameters +
         2 * parameters * (parameters + 1) / spare;
}

// A start where |H|^2 is positive: poles alone.
void drop_background(const ModeModel& model, const Response& response, Eigen::VectorXd& at) {
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

// How many residuals are as good as one that is independent: 1 + 2 times the sum of correlations up to the first that chance explains.
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

}  // namespace

ModeFit fit_modes(const Response& response, const std::vector<Pole>& start, int degree) {
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

}  // namespace scree::signals
