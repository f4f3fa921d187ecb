#pragma once

namespace scree {

// How forces around the moment of first touch, or of parting, are weighted so that their impulse is right
// wherever in a step that moment lies.
//
// A force that begins as t^p is sampled at (s + j) h, j = 0, 1, ..., where s h < h has passed since the
// touch. The sum of samples exceeds the integral by ζ(−p, s) h^(p+1), with Hurwitz' zeta function (Navot, J.
// Math. and Phys. 40, 271 (1961)): of order p + 1 only. The weights w(s) of the first sample and w(1 + s) of
// the second take that away,
//   w(s) s^p + w(1 + s) (1 + s)^p = s^p + (1 + s)^p − ζ(−p, s),
// with w(s) = s^(1−p) (c₀ + c₁ s + c₂ s²) on (0, 1), linear from there to w(2) = 1, and continuous. For p =
// 0, a jump, they are 3s/2 and 2 − s/2. Forces that begin as t or later need none: w = 1.
struct OnsetWeights {
  int quarters = 4;             // 4 p, 4 for no weights
  double first[3] = {1, 0, 0};  // c₀, c₁, c₂, to 1e-3 of a sample where p > 0
  double slope = 0;             // (w(1) − 1)

  // power: 0, 1/4, 1/2, 3/4, or 1 and more for no weights.
  static OnsetWeights of_power(double power);
};

// Hurwitz' zeta function ζ(z, a), z < 1, a > 0, to round-off.
double hurwitz_zeta(double z, double a);

}  // namespace scree
