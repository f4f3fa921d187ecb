#include <algorithm>
#include <bit>
#include <cmath>

#include <scree/packing/random.hpp>

namespace scree::packing {

namespace {

// Next output of splitmix64 (Steele, Lea & Flood 2014).
std::uint64_t splitmix64(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

// Natural logarithm of a positive normal number; std::log differs between platforms in the last bit.
// With x = m·2^e, 1/√2 <= m < √2 and s = (m - 1)/(m + 1), |s| < 0.172: ln m = 2·(s + s³/3 + s⁵/5 + ...).
double logarithm(double x) {
  constexpr double ln_2 = 0.693147180559945309417;
  constexpr double half_root_2 = 0.707106781186547524401;
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < half_root_2) {
    m *= 2.0;
    --exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  double sum = 0.0;
  for (int odd = 23; odd >= 1; odd -= 2) sum = sum * (s * s) + 1.0 / odd;
  return exponent * ln_2 + 2.0 * s * sum;
}

}  // namespace

Random::Random(std::uint64_t seed) : state_{} {
  for (std::uint64_t& word : state_) word = splitmix64(seed);
}

std::uint64_t Random::bits() {
  auto& s = state_;
  const std::uint64_t result = std::rotl(s[0] + s[3], 23) + s[0];
  const std::uint64_t t = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = std::rotl(s[3], 45);
  return result;
}

double Random::uniform() { return double(bits() >> 11) * 0x1p-53; }

double Random::uniform(double minimum, double maximum) {
  return std::min(minimum + (maximum - minimum) * uniform(), maximum);  // rounding may exceed the maximum
}

// Polar method (Marsaglia & Bray 1964). Its second deviate is discarded, so state() is the complete state.
double Random::normal() {
  while (true) {
    const double u = 2.0 * uniform() - 1.0;
    const double v = 2.0 * uniform() - 1.0;
    const double q = u * u + v * v;
    if (q > 0.0 && q < 1.0) return u * std::sqrt(-2.0 * logarithm(q) / q);
  }
}

Vec3 Random::in_ball(double radius, int dimension) {
  while (true) {
    Vec3 point{};
    for (int k = 0; k < dimension; ++k) point[k] = 2.0 * uniform() - 1.0;
    if (dot(point, point) <= 1.0) return radius * point;
  }
}

}  // namespace scree::packing
