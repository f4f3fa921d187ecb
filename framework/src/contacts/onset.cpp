#include "contacts/onset.hpp"

#include <cmath>

namespace scree {

// Direct sum of 12 terms, then Euler-Maclaurin summation.
double hurwitz_zeta(double z, double a) {
  constexpr double bernoulli_over_factorial[] = {1.0 / 12, -1.0 / 720, 1.0 / 30240, -1.0 / 1209600,
                                                 1.0 / 47900160};
  constexpr int terms = 12;
  double sum = 0;
  for (int k = 0; k < terms; ++k) sum += std::pow(a + k, -z);
  const double x = a + terms;
  sum += std::pow(x, 1 - z) / (z - 1) + 0.5 * std::pow(x, -z);
  double factor = z * std::pow(x, -z - 1);
  int order = 1;
  for (const double b : bernoulli_over_factorial) {
    sum += b * factor;
    factor *= (z + order) * (z + order + 1) / (x * x);
    order += 2;
  }
  return sum;
}

OnsetWeights OnsetWeights::of_power(double power) {
  OnsetWeights w;
  if (power >= 1) return w;
  w.quarters = int(std::lround(4 * power));
  const double p = 0.25 * w.quarters;
  // w(1): the condition at s = 0, with ζ(−p, s) = s^p + ζ(−p, 1 + s).
  const double at_one = 1 - hurwitz_zeta(-p, 1);
  w.slope = at_one - 1;
  // c₀ + c₁ s + c₂ s² = w(s) s^p / s, interpolated through three points in (0, 1).
  const auto exact = [&](double s) {
    const double second = 1 + w.slope * (1 - s);
    return ((1 - second) * std::pow(1 + s, p) - hurwitz_zeta(-p, 1 + s)) / s;
  };
  const double s[] = {0.0669872981077807, 0.5, 0.9330127018922193};  // Chebyshev points
  const double y[] = {exact(s[0]), exact(s[1]), exact(s[2])};
  const double left = (y[1] - y[0]) / (s[1] - s[0]), right = (y[2] - y[1]) / (s[2] - s[1]);
  w.first[2] = (right - left) / (s[2] - s[0]);
  w.first[1] = left - w.first[2] * (s[0] + s[1]);
  w.first[0] = y[0] - s[0] * (w.first[1] + s[0] * w.first[2]);
  return w;
}

}  // namespace scree
