#include "expectations.hpp"

#include <cmath>

#include <scree/scenario/quantities.hpp>

namespace scree::run {

namespace {

double value_of(const std::string& quantity, const std::vector<std::pair<std::string, double>>& quantities,
                const SeriesColumn& column) {
  for (const auto& [name, value] : quantities)
    if (name == quantity) return value;
  const scenario::SeriesQuantity of = scenario::series_quantity(quantity);
  return scenario::series_statistic(column(of.probe, of.column), of.statistic);
}

}  // namespace

Verdict judge_expectation(const scenario::Expectation& e,
                          const std::vector<std::pair<std::string, double>>& quantities,
                          const SeriesColumn& column) {
  Verdict verdict{e, value_of(e.quantity, quantities, column), false};
  const double x = verdict.value;
  const bool near = !e.reference || std::abs(x - *e.reference) <= *e.tolerance;
  const bool low = !e.at_most || x <= *e.at_most;
  const bool high = !e.at_least || x >= *e.at_least;
  verdict.met = near && low && high && !std::isnan(x);
  return verdict;
}

}  // namespace scree::run
