#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <scree/run/run.hpp>

namespace scree::run {

using SeriesColumn = std::function<std::vector<double>(const std::string& probe, const std::string& column)>;

// Compares an expectation with the results of a run. NaN, as from an empty series, does not meet any.
Verdict judge_expectation(const scenario::Expectation& expectation,
                          const std::vector<std::pair<std::string, double>>& quantities,
                          const SeriesColumn& column);

}  // namespace scree::run
