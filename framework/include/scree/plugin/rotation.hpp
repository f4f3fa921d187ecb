#pragma once

#include <cmath>

#include <scree/plugin/vec.hpp>

namespace scree {

// cos(|r|/2) − 1 and sin(|r|/2)/|r| r of a rotation vector r (rad).
struct HalfAngle {
  double cosine_minus_one;
  Vec3 sine;
};

namespace detail {

// Taylor series in the square of the half angle; relative error below 2e-17 up to half angles of 1/2. Not the
// library's sine and cosine, whose last bits differ between machines.
inline HalfAngle half_angle_of_small(const Vec3& rotation) {
  const double square = 0.25 * dot(rotation, rotation);
  double sine = 1, cosine = 1;  // sin(a)/a and 2 (1 − cos(a))/a²
  for (int k = 14; k > 0; k -= 2) {
    sine = 1 - square * sine / double(k * (k + 1));
    cosine = 1 - square * cosine / double((k + 1) * (k + 2));
  }
  return {-0.5 * square * cosine, 0.5 * sine * rotation};
}

}  // namespace detail

// Halves the rotation until the series holds, then doubles it. No rotation if it is not finite, which halving
// would not change.
inline HalfAngle half_angle_of(Vec3 rotation) {
  for (const double component : rotation.component)
    if (!std::isfinite(component)) return {0, {}};
  int halvings = 0;
  for (; dot(rotation, rotation) > 1; ++halvings) rotation = 0.5 * rotation;
  HalfAngle half = detail::half_angle_of_small(rotation);
  for (; halvings > 0; --halvings) {
    const double cosine = half.cosine_minus_one;
    half = {2 * cosine * (cosine + 2), 2 * (1 + cosine) * half.sine};
  }
  return half;
}

// A rotation as a unit quaternion.
struct Rotation {
  double real = 1;
  Vec3 axis = {};

  // By a rotation vector (rad).
  static Rotation by(const Vec3& rotation) {
    const HalfAngle half = half_angle_of(rotation);
    return {1 + half.cosine_minus_one, half.sine};
  }
  // The shortest one that turns z into a unit vector; by π about x for −z.
  static Rotation from_z_to(const Vec3& direction) {
    const Vec3 across = {{-direction[1], direction[0], 0}};
    if (direction[2] >= 0) {
      const double half = std::sqrt(0.5 * (1 + direction[2]));
      return {half, 0.5 / half * across};
    }
    // 1 + z would be round-off near −z.
    const double sine = std::sqrt(0.5 * (1 - direction[2])), length = norm(across);
    if (!(length > 0)) return {0, {{1, 0, 0}}};
    return {0.5 * length / sine, sine / length * across};
  }

  // Turns x and z into two unit vectors that are perpendicular to each other.
  static Rotation to_axes(const Vec3& x, const Vec3& z) {
    const Rotation upright = from_z_to(z);
    const Vec3 before = upright(Vec3{{1, 0, 0}});
    const double cosine = dot(before, x), sine = dot(cross(before, x), z);
    const double larger = std::sqrt(0.5 * (1 + std::fabs(cosine))), smaller = 0.5 * sine / larger;
    const Rotation about_z = cosine >= 0 ? Rotation{larger, smaller * z} : Rotation{smaller, larger * z};
    return about_z * upright;
  }

  Rotation back() const { return {real, -axis}; }
  Vec3 operator()(const Vec3& v) const {
    const Vec3 twice = 2.0 * cross(axis, v);
    return v + real * twice + cross(axis, twice);
  }
  // First b, then a; of unit length again.
  friend Rotation operator*(const Rotation& a, const Rotation& b) {
    Rotation both = {a.real * b.real - dot(a.axis, b.axis),
                     a.real * b.axis + b.real * a.axis + cross(a.axis, b.axis)};
    const double excess = both.real * both.real + dot(both.axis, both.axis) - 1;
    both.real -= 0.5 * excess * both.real;
    both.axis -= 0.5 * excess * both.axis;
    return both;
  }
};

}  // namespace scree
