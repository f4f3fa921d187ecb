#pragma once

#include <span>
#include <vector>

namespace scree::cycles {

// Probability that F of independent normal values is at least this large. above, below: degrees of freedom.
double tail_of_f(double f, double above, double below);

// Probability that t of independent normal values is at least this large.
double tail_of_t(double t, double degrees);

// Ranks from 1; equal values share their mean rank.
std::vector<double> ranks_of(std::span<const double> values);

}  // namespace scree::cycles
