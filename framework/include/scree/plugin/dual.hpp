#pragma once

#include <cmath>

#include <scree/plugin/roots.hpp>

namespace scree {

// A number and its derivative along one direction: x + x′ε with ε² = 0. Comparisons compare values, so that a
// selection takes the derivative of the branch that is in force. Functions are found without `std::`.
struct Dual {
  double value = 0, derivative = 0;

  constexpr Dual() = default;
  constexpr Dual(double v, double d = 0) : value(v), derivative(d) {}

  constexpr Dual& operator+=(const Dual& b) { return *this = *this + b; }
  constexpr Dual& operator-=(const Dual& b) { return *this = *this - b; }
  constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }
  constexpr Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend constexpr Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.derivative + b.derivative};
  }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.derivative - b.derivative};
  }
  friend constexpr Dual operator-(const Dual& a) { return {-a.value, -a.derivative}; }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.derivative * b.value + a.value * b.derivative};
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.derivative - quotient * b.derivative) / b.value};
  }
  friend constexpr auto operator<=>(const Dual& a, const Dual& b) { return a.value <=> b.value; }
  friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
};

namespace detail {

// f(x), given f and f′ at the value of x. A constant argument has derivative 0 even where f′ is infinite.
inline Dual chain(const Dual& x, double f, double slope) {
  return {f, x.derivative == 0 ? 0 : slope * x.derivative};
}

}  // namespace detail

inline Dual fma(const Dual& a, const Dual& b, const Dual& c) {
  return {std::fma(a.value, b.value, c.value),
          std::fma(a.derivative, b.value, std::fma(a.value, b.derivative, c.derivative))};
}
inline Dual abs(const Dual& x) { return x.value < 0 ? -x : x; }
inline Dual sqrt(const Dual& x) {
  const double root = std::sqrt(x.value);
  return detail::chain(x, root, 0.5 / root);
}
inline Dual cbrt(const Dual& x) {
  const double root = std::cbrt(x.value);
  return detail::chain(x, root, 1 / (3 * root * root));
}
inline Dual exp(const Dual& x) {
  const double power = std::exp(x.value);
  return detail::chain(x, power, power);
}
inline Dual log(const Dual& x) { return detail::chain(x, std::log(x.value), 1 / x.value); }
inline Dual sin(const Dual& x) { return detail::chain(x, std::sin(x.value), std::cos(x.value)); }
inline Dual cos(const Dual& x) { return detail::chain(x, std::cos(x.value), -std::sin(x.value)); }
inline Dual tanh(const Dual& x) {
  const double t = std::tanh(x.value);
  return detail::chain(x, t, 1 - t * t);
}
inline Dual atan(const Dual& x) { return detail::chain(x, std::atan(x.value), 1 / (1 + x.value * x.value)); }
inline Dual pow(const Dual& x, double p) {
  return detail::chain(x, std::pow(x.value, p), p * std::pow(x.value, p - 1));
}

// As in roots.hpp. At 0, where these are finite bounds of an infinite limit, the derivative
// is 0.
inline Dual inverse_sqrt(const Dual& x) {
  const double y = inverse_sqrt(x.value);
  return {y, x.value > 0 ? -0.5 * (y / x.value) * x.derivative : 0};
}
inline Dual inverse_fourth_root(const Dual& x) {
  const double y = inverse_fourth_root(x.value);
  return {y, x.value > 0 ? -0.25 * (y / x.value) * x.derivative : 0};
}

}  // namespace scree
