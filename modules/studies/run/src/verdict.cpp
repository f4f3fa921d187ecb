#include <cmath>

#include <nlohmann/json.hpp>

#include <scree/run/verdict.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::run {

Verdict judged(const scenario::Expectation& e, double value) {
  const bool near = !e.reference || std::abs(value - *e.reference) <= *e.tolerance;
  const bool low = !e.at_most || value <= *e.at_most;
  const bool high = !e.at_least || value >= *e.at_least;
  return {e, value, near && low && high && !std::isnan(value)};
}

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

nlohmann::ordered_json json_of(const std::vector<Verdict>& verdicts) {
  auto all = nlohmann::ordered_json::array();
  for (const Verdict& v : verdicts) {
    nlohmann::ordered_json json = {{"requirement", v.expectation.requirement},
                                   {"quantity", v.expectation.quantity},
                                   {"value", v.value},
                                   {"met", v.met}};
    const auto add = [&](const char* key, const std::optional<double>& number) {
      if (number) json[key] = *number;
    };
    add("reference", v.expectation.reference);
    add("tolerance", v.expectation.tolerance);
    add("at_most", v.expectation.at_most);
    add("at_least", v.expectation.at_least);
    all.push_back(std::move(json));
  }
  return all;
}

}  // namespace scree::run
