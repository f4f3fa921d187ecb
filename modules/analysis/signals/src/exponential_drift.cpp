#include "exponential_drift.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace scree::signals {

namespace {

constexpr std::size_t most_means = 2048;
constexpr double slowest = 0.5, fastest = 50;  // over the record
constexpr double least_f = 7;                  // F of 3 and many degrees of freedom: chance 1e-4 or less
constexpr Eigen::Index cubic = 4;
constexpr std::array relaxation_rates = {1.0, 1.0 / 3, 3.0, 9.0};  // over ExponentialDrift::rate
constexpr std::array<Eigen::Index, 3> relaxation_counts = {
    0, 2, Eigen::Index(relaxation_rates.size()) + 1};  // strengths of no relaxation, one, all

// A record averaged in groups of samples.
struct Means {
  Eigen::VectorXd times, values;  // times from 0 to 1

  Means(std::span<const double> all_times, std::span<const double> all) {
    const std::size_t group = (all.size() + most_means - 1) / most_means;
    const auto count = Eigen::Index((all.size() + group - 1) / group);
    times.resize(count), values.resize(count);
    const double duration = all_times.back() - all_times.front();
    for (Eigen::Index g = 0; g < count; ++g) {
      const std::size_t begin = std::size_t(g) * group, end = std::min(all.size(), begin + group);
      double time = 0, value = 0;
      for (std::size_t k = begin; k < end; ++k) time += all_times[k] - all_times[0], value += all[k] - all[0];
      times[g] = time / double(end - begin) / duration, values[g] = value / double(end - begin);
    }
  }
};

// s exp(-s) and exp(-r_k s) at s = rate * time.
Eigen::RowVectorXd relaxations(double s, Eigen::Index count) {
  Eigen::RowVectorXd values(count);
  for (Eigen::Index k = 1; k < count; ++k) values[k] = std::exp(-relaxation_rates[std::size_t(k - 1)] * s);
  if (count > 0) values[0] = s * values[1];
  return values;
}

struct Fit {
  Eigen::VectorXd strengths;
  double square = 0;  // sum of squares of the residual
};

Fit fit_of(const Means& means, double rate, Eigen::Index count) {
  Eigen::MatrixXd columns(means.times.size(), cubic + count);
  const Eigen::ArrayXd u = 2 * means.times.array() - 1;
  columns.col(0).setOnes();
  for (Eigen::Index k = 1; k < cubic; ++k) columns.col(k) = columns.col(k - 1).array() * u;
  for (Eigen::Index row = 0; count > 0 && row < means.times.size(); ++row)
    columns.row(row).tail(count) = relaxations(rate * means.times[row], count);
  const Eigen::VectorXd fit = columns.colPivHouseholderQr().solve(means.values);
  return {fit.tail(count), (means.values - columns * fit).squaredNorm()};
}

// The rate with the least residual: the best of a few, refined between its neighbours.
double best_rate(const Means& means, Eigen::Index count) {
  constexpr int steps = 12, halvings = 20;
  const double factor = std::pow(fastest / slowest, 1.0 / steps);
  double best = slowest, least = fit_of(means, slowest, count).square;
  const auto try_rate = [&](double rate) {
    if (const double square = fit_of(means, rate, count).square; square < least) least = square, best = rate;
  };
  for (int k = 1; k <= steps; ++k) try_rate(slowest * std::pow(factor, k));
  double step = std::sqrt(factor);
  for (int k = 0; k < halvings; ++k, step = std::sqrt(step))
    for (const double rate : {best / step, best * step}) try_rate(rate);
  return best;
}

}  // namespace

double ExponentialDrift::value(double time) const {
  const auto count = Eigen::Index(strengths.size());
  return relaxations(rate * (time - start), count)
      .dot(Eigen::Map<const Eigen::RowVectorXd>(strengths.data(), count));
}

ExponentialDrift exponential_drift(std::span<const double> times, std::span<const double> values) {
  const double duration = times.back() - times.front();
  const Means means(times, values);
  ExponentialDrift drift{1 / duration, times.front(), {}};
  double least = fit_of(means, 1, 0).square;
  for (std::size_t c = 1; c < relaxation_counts.size(); ++c) {
    const Eigen::Index count = relaxation_counts[c],
                       more = count - relaxation_counts[c - 1] + (c == 1);  // the rate
    const Eigen::Index spare = means.times.size() - cubic - count - 1;
    if (spare < cubic + count) break;
    const double rate = best_rate(means, count);
    const Fit fit = fit_of(means, rate, count);
    if (!(least - fit.square > least_f * double(more) * fit.square / double(spare))) break;
    least = fit.square;
    drift.rate = rate / duration;
    drift.strengths.assign(fit.strengths.begin(), fit.strengths.end());
  }
  return drift;
}

void add(const ExponentialDrift& drift, double sign, std::span<const double> times,
         std::vector<double>& values) {
  if (drift.strengths.empty()) return;
  for (std::size_t k = 0; k < times.size(); ++k) values[k] += sign * drift.value(times[k]);
}

}  // namespace scree::signals
