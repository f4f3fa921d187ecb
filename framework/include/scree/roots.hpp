#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include <scree/vec.hpp>

namespace scree {

// Roots as multiplications and subtractions: several times faster than the processor's square root and
// division, of which there is one unit that does not pipeline, and with the same bits at every instruction
// level. For x >= 0; an infinite x gives no number.

namespace detail {

// A guess at a power of x between −1 and 0: its exponent, shifted right, taken from a magic number.
template <class T>
inline T guess_power(const T& x, int shift, std::uint64_t magic, std::uint32_t magic_single) {
  using Bits = std::conditional_t<std::is_same_v<T, double>, std::uint64_t, std::uint32_t>;
  const Bits from = std::is_same_v<T, double> ? Bits(magic) : Bits(magic_single);
  return std::bit_cast<T>(Bits(from - (std::bit_cast<Bits>(x) >> shift)));
}

// Iterations that take such a guess to round-off.
template <class T>
inline constexpr int newton_iterations = std::is_same_v<T, double> ? 4 : 3;

}  // namespace detail

// 1/√x to 1.5 units in the last place; finite at 0. A guess that halves the exponent, then Newton's
// iteration, which squares the error: 3.4 %, 1.8e-3, 4.7e-6, 3.3e-11, round-off.
template <class T>
inline T inverse_sqrt(const T& x) {
  T y = detail::guess_power(x, 1, 0x5fe6eb50c7b537a9u, 0x5f375a86u);
  const T half = T(0.5) * x;
  for (int k = 0; k < detail::newton_iterations<T>; ++k) y *= fused(-half * y, y, T(1.5));
  return y;
}

// x^(−1/4) to 2 units in the last place; finite at 0. Likewise: 3.2 %, 2.4e-3, 1.5e-5, 5.5e-10, round-off.
template <class T>
inline T inverse_fourth_root(const T& x) {
  T y = detail::guess_power(x, 2, 0x4feb083126e978d6u, 0x4f584189u);
  const T quarter = T(0.25) * x;
  for (int k = 0; k < detail::newton_iterations<T>; ++k) {
    const T square = y * y;
    y *= fused(-quarter * square, square, T(1.25));
  }
  return y;
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

template <int D, class T>
inline Root<T> length_of(const Vec<D, T>& v) {
  return root_of(dot(v, v));
}

}  // namespace scree
