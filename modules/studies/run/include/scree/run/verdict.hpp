#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <scree/scenario/plan.hpp>

namespace scree::run {

// Result of an expectation.
struct Verdict {
  scenario::Expectation expectation;
  double value = 0;
  bool met = false;
};

// Compares an expectation with the value of its quantity. NaN, as from an empty series, does not meet any.
Verdict judged(const scenario::Expectation& expectation, double value);

using SeriesColumn = std::function<std::vector<double>(const std::string& probe, const std::string& column)>;

// Compares an expectation with the results of a run: with one of its quantities, or with the statistic of a
// series.
Verdict judge_expectation(const scenario::Expectation& expectation,
                          const std::vector<std::pair<std::string, double>>& quantities,
                          const SeriesColumn& column);

// "expect" of a record.
nlohmann::ordered_json json_of(const std::vector<Verdict>& verdicts);

}  // namespace scree::run
