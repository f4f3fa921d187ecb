#include "settling.hpp"

#include "significance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree::cycles {

namespace {

constexpr std::size_t fewest_blocks = 8;
// Variance of a sum of |increments|, weighted by a slow function of the cycle, over that of independent ones.
// Increments of independent values have a correlation of -1/2 with the next, their absolute values (bivariate
// normal) one of 0.224, which counts twice.
constexpr double variance_of_neighbours = 1.45;

// |increments| between the means of consecutive blocks.
std::vector<double> increments_of(std::span<const double> values, std::size_t block) {
  std::vector<double> means, increments;
  for (std::size_t begin = 0; begin + block <= values.size(); begin += block) {
    double sum = 0;
    // Relative to the first value, so that small changes of large values keep their digits.
    for (std::size_t k = begin; k < begin + block; ++k) sum += values[k] - values[0];
    means.push_back(sum / double(block));
  }
  for (std::size_t j = 0; j + 1 < means.size(); ++j) increments.push_back(std::abs(means[j + 1] - means[j]));
  return increments;
}

// Rank correlation of values with their index; 0 if all are equal.
double correlation_with_place(const std::vector<double>& values) {
  const std::vector<double> ranks = ranks_of(values);
  const double m = double(ranks.size()), mean = 0.5 * (m + 1);
  double product = 0, squares = 0;
  for (std::size_t k = 0; k < ranks.size(); ++k) {
    product += (ranks[k] - mean) * (double(k + 1) - mean);
    squares += (ranks[k] - mean) * (ranks[k] - mean);
  }
  return squares > 0 ? product / std::sqrt(squares * m * (m * m - 1) / 12) : 0;
}

double probability_of(double correlation, std::size_t increments) {
  const double rest = 1 - correlation * correlation, degrees = double(increments) - 2;
  if (!(rest > 0)) return correlation < 0 ? 0 : 1;
  return tail_of_t(-correlation * std::sqrt(degrees / (rest * variance_of_neighbours)), degrees);
}

}  // namespace

Settling settling_of(std::span<const double> values) {
  Settling best;
  for (std::size_t block = 1; values.size() / block >= fewest_blocks; block *= 2) {
    const std::vector<double> increments = increments_of(values, block);
    const double correlation = correlation_with_place(increments);
    const double probability = probability_of(correlation, increments.size());
    ++best.lengths;
    if (best.block > 0 && probability >= best.probability) continue;
    best.block = block;
    best.correlation = correlation;
    best.probability = probability;
    best.increments = increments.size();
  }
  best.probability = std::min(1.0, best.probability * double(best.lengths));
  return best;
}

}  // namespace scree::cycles
