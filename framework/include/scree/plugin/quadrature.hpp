#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

// Integrals of functions that have no antiderivative of elementary functions.

namespace scree {

namespace detail {

// Ten nodes of Gauss and Legendre, exact for polynomials up to degree 19 (Abramowitz and Stegun, table 25.4).
template <class Function>
double ten_nodes(const Function& f, double from, double to) {
  static constexpr double nodes[] = {0.148874338981631211, 0.433395394129247191, 0.679409568299024406,
                                     0.865063366688984511, 0.973906528517171720};
  static constexpr double weights[] = {0.295524224714752870, 0.269266719309996355, 0.219086362515982044,
                                       0.149451349150580593, 0.066671344308688138};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0;
  for (std::size_t n = 0; n < 5; ++n)
    sum += weights[n] * (f(middle - half * nodes[n]) + f(middle + half * nodes[n]));
  return half * sum;
}

// Halves an interval until both halves add up to the whole. An error of round-off does not fall by halving:
// `depth` ends that.
template <class Function>
double halved(const Function& f, double from, double to, double whole, double tolerance, int depth) {
  const double middle = 0.5 * (from + to);
  const double left = ten_nodes(f, from, middle), right = ten_nodes(f, middle, to);
  if (depth == 0 || !(std::abs(left + right - whole) > tolerance)) return left + right;
  return halved(f, from, middle, left, tolerance, depth - 1) +
         halved(f, middle, to, right, tolerance, depth - 1);
}

}  // namespace detail

// ∫ f(x) dx of a function that is smooth between `from` and `to`, and at these ends may be a smooth one of the
// root of the distance: x = middle − half cos θ makes it smooth in θ there. tolerance: absolute, by which an
// interval and the sum of its two halves may differ; where f is smooth that sum is some 2^20 times nearer.
template <class Function>
double integral_with_root_ends(const Function& f, double from, double to, double tolerance) {
  if (!(from < to)) return 0;
  const double half = 0.5 * (to - from), middle = 0.5 * (from + to);
  const auto turned = [&](double angle) {
    return f(middle - half * std::cos(angle)) * half * std::sin(angle);
  };
  const double whole = detail::ten_nodes(turned, 0, std::numbers::pi);
  return detail::halved(turned, 0, std::numbers::pi, whole, tolerance, 24);
}

}  // namespace scree
