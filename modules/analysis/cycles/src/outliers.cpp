#include "outliers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <scree/median.hpp>

namespace scree::cycles {

namespace {

constexpr std::size_t reach = 5;
constexpr double upper_quartile = 1.1503;  // of the absolute values of normal noise of standard deviation 1

double robust_deviation(std::vector<double> deviations) {
  const auto quartile = deviations.begin() + std::ptrdiff_t(3 * deviations.size() / 4);
  std::nth_element(deviations.begin(), quartile, deviations.end());
  return *quartile / upper_quartile;
}

struct Deviation {
  double of_pairs = 0, smaller = 0, mean = 0;  // mean: what the pairs say
};

// Of the first value and the last, which have values on one side only. What exceeds thrice the range of the next values counts: the first of a slope is 3/4 of
// it from their median, of a decay by a factor of e per cycle 2.6 times.
Deviation deviation_at_end(const std::vector<double>& values, std::size_t place) {
  const std::size_t count = std::min(reach, values.size() - 1);
  const auto begin = place == 0 ? values.begin() + 1 : values.end() - 1 - std::ptrdiff_t(count);
  const auto [low, high] = std::minmax_element(begin, begin + std::ptrdiff_t(count));
  const double median = upper_median({begin, begin + std::ptrdiff_t(count)});
  const double beyond = std::abs(values[place] - median) - 3 * (*high - *low);
  return {std::max(0.0, beyond), std::max(0.0, beyond), median};
}

Deviation deviation_at(const std::vector<double>& values, std::size_t place) {
  const std::size_t half = std::min({reach, place, values.size() - 1 - place});
  if (half == 0) return deviation_at_end(values, place);
  std::vector<double> around{values[place]}, means;
  for (std::size_t d = 1; d <= half; ++d) {
    const double before = values[place - d], after = values[place + d];
    around.insert(around.end(), {before, after});
    means.push_back(std::midpoint(before, after));
  }
  const double mean = upper_median(means), of_pairs = std::abs(values[place] - mean);
  return {of_pairs, std::min(of_pairs, std::abs(values[place] - upper_median(around))), mean};
}

bool is_smaller(const Deviation& a, const Deviation& b) { return a.smaller < b.smaller; }

}  // namespace

Outliers find_outliers(std::span<const double> series, double factor, double round_off) {
  std::vector<double> values(series.begin(), series.end()), of_pairs;
  std::vector<Deviation> deviations;
  for (std::size_t k = 0; k < values.size(); ++k) {
    deviations.push_back(deviation_at(values, k));
    of_pairs.push_back(deviations[k].of_pairs);
  }
  Outliers outliers;
  if (values.empty()) return outliers;
  outliers.deviation = robust_deviation(std::move(of_pairs));
  outliers.threshold = std::max(factor * outliers.deviation, round_off);
  std::vector<bool> found(values.size(), false);
  while (true) {
    const auto worst = std::max_element(deviations.begin(), deviations.end(), is_smaller);
    if (!(worst->smaller > outliers.threshold)) break;
    const std::size_t place = std::size_t(worst - deviations.begin());
    outliers.places.push_back(place);
    outliers.largest = std::max(outliers.largest, worst->smaller);
    found[place] = true;
    values[place] = worst->mean;
    const std::size_t end = std::min(values.size(), place + reach + 1);
    for (std::size_t k = place - std::min(place, reach); k < end; ++k)
      deviations[k] = found[k] ? Deviation{} : deviation_at(values, k);
  }
  std::sort(outliers.places.begin(), outliers.places.end());
  return outliers;
}

}  // namespace scree::cycles
