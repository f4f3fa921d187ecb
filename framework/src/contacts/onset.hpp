#pragma once

namespace scree {

// Onset weights: factors for forces shortly after first touch, or before parting, which make their impulse
// correct to second order wherever in a step first touch or parting occurs.
//
// A force that begins as t^p is sampled at times (s + j) h after first touch, j = 0, 1, ..., 0 <= s < 1. The
// sum of the samples exceeds the integral by ζ(−p, s) h^(p+1), where ζ is Hurwitz' zeta function (Navot, J.
// Math. and Phys. 40, 271 (1961)): an error of order p + 1 only. Weights w(s) of the first sample and
// w(1 + s) of the second remove it,
//   w(s) s^p + w(1 + s) (1 + s)^p = s^p + (1 + s)^p − ζ(−p, s),
// with w(s) = s^(1−p) (c₀ + c₁ s + c₂ s²) on (0, 1), linear from there to w(2) = 1, and continuous. For a
// jump, p = 0, they are 3s/2 and 2 − s/2. Forces that begin as t or a higher power need no weights: w = 1.
struct OnsetWeights {
  int quarters = 4;             // 4 p; 4: no weights
  double first[3] = {1, 0, 0};  // c₀, c₁, c₂; for p > 0 accurate to 1e-3 of a sample
  double slope = 0;             // (w(1) − 1)

  // power: 0, 1/4, 1/2 or 3/4; 1 or more: no weights.
  static OnsetWeights of_power(double power);
};

// Hurwitz' zeta function ζ(z, a), z < 1, a > 0, to round-off.
double hurwitz_zeta(double z, double a);

}  // namespace scree
