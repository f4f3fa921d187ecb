#include "repetition.hpp"

#include "significance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::cycles {

namespace {

constexpr std::size_t longest = 1000;  // the time to try all periods grows with their number

// Means of values k, k + period, ...
std::vector<double> phase_means(const std::vector<double>& values, std::size_t period) {
  std::vector<double> means(period, 0.0);
  for (std::size_t k = 0; k < values.size(); ++k) means[k % period] += values[k];
  for (std::size_t phase = 0; phase < period; ++phase) {
    const std::size_t count = (values.size() - phase + period - 1) / period;
    means[phase] /= double(count);
  }
  return means;
}

// The correlation of neighbours among the deviations from the means of the phases.
double memory_of(const std::vector<double>& values, std::size_t period) {
  const std::vector<double> means = phase_means(values, period);
  double products = 0, squares = 0, before = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double rest = values[k] - means[k % period];
    products += rest * before;
    squares += rest * rest;
    before = rest;
  }
  return squares > 0 ? products / squares : 0;
}

// Each value but the first, less a share of the one before.
std::vector<double> without_memory(const std::vector<double>& values, double memory) {
  std::vector<double> fresh;
  for (std::size_t k = 1; k < values.size(); ++k) fresh.push_back(values[k] - memory * values[k - 1]);
  return fresh;
}

double folded_f(const std::vector<double>& values, std::size_t period) {
  const std::vector<double> means = phase_means(values, period);
  const double n = double(values.size()), degrees = double(period - 1);
  double sum = 0, between = 0, within = 0;
  for (const double value : values) sum += value;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double mean = means[k % period], rest = values[k] - mean;
    between += (mean - sum / n) * (mean - sum / n);
    within += rest * rest;
  }
  // Within the round-off of the sums the repetition is exact.
  if (within <= 1e-12 * (between + within)) return between > 0 ? std::numeric_limits<double>::infinity() : 0;
  return (between / degrees) / (within / (n - degrees - 1));
}

}  // namespace

Repetition best_repetition(std::span<const double> values) {
  const std::vector<double> ranks = ranks_of(values);
  Repetition best;
  for (std::size_t period = 2; period <= std::min(values.size() / 3, longest); ++period) {
    const std::vector<double> fresh = without_memory(ranks, memory_of(ranks, period));
    const double f = std::min(folded_f(ranks, period), folded_f(fresh, period));
    const double probability = tail_of_f(f, double(period - 1), double(fresh.size() - period - 1));
    ++best.periods;
    // Multiples of the period repeat too; of equal probabilities the shortest period counts.
    if (probability < best.probability) {
      best.period = period;
      best.f = f;
      best.probability = probability;
    }
  }
  best.probability = std::min(1.0, best.probability * double(best.periods));
  return best;
}

}  // namespace scree::cycles
