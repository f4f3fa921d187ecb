#include "expectations.hpp"

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
  return judged(e, value_of(e.quantity, quantities, column));
}

}  // namespace scree::run
