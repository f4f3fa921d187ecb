#include "repetition.hpp"

#include "significance.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace scree::cycles {

namespace {

constexpr std::size_t longest = 1000;  // the time to try all periods grows with their number

// F of the phases of one period.
double folded_f(const std::vector<double>& ranks, double variation, std::size_t period) {
  const double n = double(ranks.size()), mean = 0.5 * (n + 1);
  double between = 0;
  for (std::size_t phase = 0; phase < period; ++phase) {
    double sum = 0, count = 0;
    for (std::size_t k = phase; k < ranks.size(); k += period, ++count) sum += ranks[k] - mean;
    between += sum * sum / count;
  }
  const double within = variation - between, degrees = double(period - 1);
  // Below the round-off of the sums the repetition is exact.
  if (within <= 1e-12 * variation) return std::numeric_limits<double>::infinity();
  return (between / degrees) / (within / (n - degrees - 1));
}

}  // namespace

Repetition best_repetition(std::span<const double> values) {
  const std::vector<double> ranks = ranks_of(values);
  const double n = double(ranks.size()), mean = 0.5 * (n + 1);
  double variation = 0;
  for (const double rank : ranks) variation += (rank - mean) * (rank - mean);
  Repetition best;
  if (variation == 0) return best;
  for (std::size_t period = 2; period <= std::min(values.size() / 3, longest); ++period) {
    const double f = folded_f(ranks, variation, period);
    const double probability = tail_of_f(f, double(period - 1), n - double(period));
    ++best.periods;
    // A multiple of the period repeats too; of equal ones the shortest is meant.
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
