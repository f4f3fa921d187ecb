#include "expectations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace scree::scenario {

namespace {

double statistic_of(const std::vector<double>& values, const std::string& statistic) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (statistic == "first") return values.front();
  if (statistic == "min") return *std::min_element(values.begin(), values.end());
  if (statistic == "max") return *std::max_element(values.begin(), values.end());
  if (statistic == "mean") return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  return values.back();
}

double value_of(const std::string& quantity, const std::vector<std::pair<std::string, double>>& quantities,
                const SeriesColumn& column) {
  for (const auto& [name, value] : quantities)
    if (name == quantity) return value;
  const auto first = quantity.find('.'), last = quantity.rfind('.');
  return statistic_of(column(quantity.substr(0, first), quantity.substr(first + 1, last - first - 1)),
                      quantity.substr(last + 1));
}

}  // namespace

Verdict judge_expectation(const Expectation& e, const std::vector<std::pair<std::string, double>>& quantities,
                          const SeriesColumn& column) {
  Verdict verdict{e, value_of(e.quantity, quantities, column), false};
  const double x = verdict.value;
  const bool near = !e.reference || std::abs(x - *e.reference) <= *e.tolerance;
  const bool low = !e.at_most || x <= *e.at_most;
  const bool high = !e.at_least || x >= *e.at_least;
  verdict.met = near && low && high && !std::isnan(x);
  return verdict;
}

}  // namespace scree::scenario
