#pragma once

#include "touching_pair.hpp"

namespace scree::test {

// Unit quaternion of a rotation vector (rad).
inline Vec<4> quaternion_of(const Vec3& rotation) {
  const double angle = norm(rotation), share = angle > 0 ? std::sin(0.5 * angle) / angle : 0.5;
  return {{std::cos(0.5 * angle), share * rotation[0], share * rotation[1], share * rotation[2]}};
}
// The rotation `second` after the rotation `first`.
inline Vec<4> after(const Vec<4>& second, const Vec<4>& first) {
  const Vec3 u = {{second[1], second[2], second[3]}}, v = {{first[1], first[2], first[3]}};
  const Vec3 w = second[0] * v + first[0] * u + cross(u, v);
  return {{second[0] * first[0] - dot(u, v), w[0], w[1], w[2]}};
}
// A vector rotated by a rotation vector (rad).
inline Vec3 turned(const Vec3& rotation, const Vec3& v) {
  const double angle = norm(rotation);
  if (angle == 0) return v;
  const Vec3 axis = (1 / angle) * rotation;
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) +
         ((1 - std::cos(angle)) * dot(axis, v)) * axis;
}

struct SpherePose {
  Vec3 a = {}, b = {};  // centres (m); of a wall its point
  Vec<4> quaternion_a = {{1, 0, 0, 0}}, quaternion_b = {{1, 0, 0, 0}};

  const Vec<4>& orientation_a() const { return quaternion_a; }
  const Vec<4>& orientation_b() const { return quaternion_b; }
  // The same with both bodies rotated as one rigid body, about the origin.
  SpherePose rotated(const Vec3& rotation) const {
    const Vec<4> q = quaternion_of(rotation);
    return {turned(rotation, a), turned(rotation, b), after(q, quaternion_a), after(q, quaternion_b)};
  }
};

// A pair of spheres, or a sphere and a wall.
class SpherePair : public TouchingPair<3, SpherePose> {
 public:
  using TouchingPair::TouchingPair;

  Vec3 spring() const { return history("spring_"); }
  Vec3 painted_a() const { return history("painted_a_"); }
  Vec3 painted_b() const { return history("painted_b_"); }

 private:
  Vec3 history(const std::string& name) const {
    return {{law().history(name + "x"), law().history(name + "y"), law().history(name + "z")}};
  }
};

}  // namespace scree::test
