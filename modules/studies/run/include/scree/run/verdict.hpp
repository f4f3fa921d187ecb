#pragma once

#include <scree/scenario/plan.hpp>

namespace scree::run {

// Result of an expectation.
struct Verdict {
  scenario::Expectation expectation;
  double value = 0;
  bool met = false;
};

// Compares an expectation with the value of its quantity. NaN does not meet any.
Verdict judged(const scenario::Expectation& expectation, double value);

}  // namespace scree::run
