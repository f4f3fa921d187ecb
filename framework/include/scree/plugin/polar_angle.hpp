#pragma once

#include <cmath>
#include <numbers>

#include <scree/plugin/roots.hpp>
#include <scree/plugin/vec.hpp>

namespace scree {

// arcsin x for |x| <= sin(π/8), to one unit in the last place: the Chebyshev approximation of (arcsin x −
// x)/x³ in x² (relative error of the result 2e-17).
template <class T>
inline T small_arcsine(const T& x) {
  const T square = x * x;
  const T rest = detail::polynomial(square, 0.16666666666666654, 0.075000000000171006, 0.044642857104453644,
                                    0.030381947779903184, 0.022372012509623364, 0.017356446193822464,
                                    0.013908959824591178, 0.012070300491340377, 0.0069245691267002918,
                                    0.016468645712014277);
  return fused(x * square, rest, x);
}

// Angle of a unit vector from the x axis (rad), in [−π, π]: branch-free, with the same bits at every
// instruction level. The vector is mirrored into the first quadrant and turned to within π/8 of the x axis.
template <class T>
inline T polar_angle(const Vec<2, T>& unit) {
  using std::abs;
  constexpr double pi = std::numbers::pi, root_half = std::numbers::sqrt2 / 2;
  constexpr double tan_eighth = std::numbers::sqrt2 - 1;  // tan(π/8)
  const T x = abs(unit[0]), y = abs(unit[1]);
  const bool low = y < T(tan_eighth) * x, high = x < T(tan_eighth) * y;
  const T cosine = low ? T(1) : high ? T(0) : T(root_half), sine = low ? T(0) : high ? T(1) : T(root_half);
  const T middle = low ? T(0) : high ? T(pi / 2) : T(pi / 4);
  const T first_quadrant = middle + small_arcsine(fused(y, cosine, -(x * sine)));
  const T upper = unit[0] < T(0) ? T(pi) - first_quadrant : first_quadrant;
  return unit[1] < T(0) ? -upper : upper;
}

}  // namespace scree
