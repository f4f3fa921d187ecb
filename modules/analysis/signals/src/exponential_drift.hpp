#pragma once

#include <span>
#include <vector>

namespace scree::signals {

// A drift that no cubic follows, as after a step of the load: relaxations (a_0 + b s) exp(-s) + sum of a_k
// exp(-r_k s) with s = rate (t - start) and r_k = 1/3, 3, 9, which also approximate power laws and
// logarithms.
struct ExponentialDrift {
  double rate = 0, start = 0;     // (1/s) (s)
  std::vector<double> strengths;  // b, a_0, a_k; empty: no relaxation, two numbers: one
  double value(double time) const;
};

// The drift that fits a record best beside a cubic, with a rate of 0.5 to 50 over the record: no relaxation,
// one, or all. More of them are taken if that improves the fit by F > 7, which noise does once in ten
// thousand times.
ExponentialDrift exponential_drift(std::span<const double> times, std::span<const double> values);

// Adds a drift to a record, or subtracts it (sign -1).
void add(const ExponentialDrift& drift, double sign, std::span<const double> times,
         std::vector<double>& values);

}  // namespace scree::signals
