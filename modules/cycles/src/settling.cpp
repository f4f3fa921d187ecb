#include "settling.hpp"

#include "significance.hpp"

#include <cmath>
#include <vector>

namespace scree::cycles {

Settling settling_of(std::span<const double> values) {
  std::vector<double> increments;
  for (std::size_t k = 0; k + 1 < values.size(); k += 2)
    increments.push_back(std::abs(values[k + 1] - values[k]));
  Settling settling;
  settling.pairs = increments.size();
  const std::vector<double> ranks = ranks_of(increments);
  const double m = double(ranks.size()), mean = 0.5 * (m + 1);
  double product = 0, squares = 0;
  for (std::size_t k = 0; k < ranks.size(); ++k) {
    product += (ranks[k] - mean) * (double(k + 1) - mean);
    squares += (ranks[k] - mean) * (ranks[k] - mean);
  }
  if (squares == 0) return settling;
  settling.correlation = product / std::sqrt(squares * m * (m * m - 1) / 12);
  const double rest = 1 - settling.correlation * settling.correlation;
  settling.probability = rest > 0 ? tail_of_t(-settling.correlation * std::sqrt((m - 2) / rest), m - 2)
                         : settling.correlation < 0 ? 0
                                                    : 1;
  return settling;
}

}  // namespace scree::cycles
