#pragma once

#include <bit>
#include <cstdint>

#include <scree/plugin/vec.hpp>

namespace scree {

// Roots by multiplications and subtractions: several times faster than the processor's square root and
// division, which share one unit that is not pipelined, and with the same bits at every instruction level.
// Valid for finite x >= 0; an infinite x gives NaN.

namespace detail {

// First guess of x^p, −1 < p < 0: the bits of x, shifted right, subtracted from a magic number.
inline double guess_power(double x, int shift, std::uint64_t magic) {
  return std::bit_cast<double>(magic - (std::bit_cast<std::uint64_t>(x) >> shift));
}

// c₀ + c₁ e + c₂ e² + ...
template <class T>
inline T polynomial(const T&, double c) {
  return T(c);
}
template <class T, class... More>
inline T polynomial(const T& e, double c, More... more) {
  return fused(e, polynomial(e, more...), T(c));
}

}  // namespace detail

// 1/√x to one unit in the last place; finite at 0. Three stages: a guess y₀ that halves the exponent
// (relative error 13 %); times the best linear function of x y₀² on its range (6.5e-4); then the economised
// series of (1 − e)^(−1/2) in e = 1 − x y², |e| < 1.302e-3 (6e-17). Fewer operations than Newton's iteration,
// and fewer that depend on each other.
inline double inverse_sqrt(double x) {
  const double guess = detail::guess_power(x, 1, 0x5fe3f58e38590eb4u);
  const double y = guess * fused(-0.7075673662945378, x * guess * guess, 0.7075673662945378 * 2.3811);
  const double e = fused(-(x * y), y, 1.0);
  return fused(y * e, detail::polynomial(e, 0.49999999999977934, 0.375, 0.31250052107344606, 35.0 / 128), y);
}

// x^(−1/4) to one unit in the last place; finite at 0. The same stages: relative error 1.1e-3 after the
// linear function, then the series in e = 1 − x y⁴, |e| < 4.345e-3.
inline double inverse_fourth_root(double x) {
  const double guess = detail::guess_power(x, 2, 0x4fe9fdf3b645a1ccu);
  const double square_guess = guess * guess;
  const double y =
      guess * fused(-0.3086685529065161, x * square_guess * square_guess, 0.3086685529065161 * 4.2277);
  const double square = y * y, e = fused(-(x * square), square, 1.0);
  return fused(
      y * e, detail::polynomial(e, 0.25, 0.15624999998580244, 15.0 / 128, 0.09521684915668545, 663.0 / 8192),
      y);
}

// A square root and its reciprocal.
template <class T>
struct Root {
  T value, inverse;
};

// √x to one unit in the last place, and 1/√x as above.
template <class T>
inline Root<T> root_of(const T& x) {
  const T inverse = inverse_sqrt(x), value = x * inverse;
  return {fused(T(0.5) * inverse, fused(-value, value, x), value), inverse};
}

// |v| and 1/|v|.
template <int D, class T>
inline Root<T> length_of(const Vec<D, T>& v) {
  return root_of(dot(v, v));
}

}  // namespace scree
