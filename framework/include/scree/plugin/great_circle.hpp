#pragma once

#include <scree/plugin/roots.hpp>
#include <scree/plugin/vec.hpp>

// Arcs of great circles of the unit sphere and rotations by quaternions, without trigonometric functions and
// without branches. An arc is a vector in the tangent plane of its first point, as long as its angle φ (rad).
// The polynomials interpolate at Chebyshev points for φ <= longest_arc, with relative errors of 1e-16 (arc),
// 2e-16 (end) and 1e-16 (shear); beyond it the results are smooth, but lose digits.

namespace scree {

inline constexpr double longest_arc = 0.4;  // (rad)

// Arc from one unit vector to another: (φ/sin φ)(to − cos φ from), the logarithm map.
template <class T>
inline Vec<3, T> arc_between(const Vec<3, T>& from, const Vec<3, T>& to) {
  const Vec<3, T> chord = to - from;
  const T versine = T(0.5) * dot(chord, chord);  // 1 − cos φ, without cancellation
  const T stretch = detail::polynomial(versine, 1, 0.3333333333333333, 0.1333333333333815, 0.0571428571300657,
                                       0.025396826689392735, 0.011543947529150448, 0.005329721477670891,
                                       0.0024610705617956557, 0.0013618570884250275);
  return stretch * fused(versine, from, chord);
}

// Unit vector at the end of an arc: cos φ from + (sin φ/φ) arc, the exponential map.
template <class T>
inline Vec<3, T> end_of_arc(const Vec<3, T>& from, const Vec<3, T>& arc) {
  const T square = dot(arc, arc);
  const T versine =
      square * detail::polynomial(square, 0.49999999999999956, -0.04166666666653335, 0.0013888888822222603,
                                  -2.4801470611766396e-05, 2.7473931384796286e-07);
  const T sinc = detail::polynomial(square, 1, -0.16666666666666663, 0.008333333333323076,
                                    -0.00019841269789973805, 2.7557229440036473e-06, -2.498795167765636e-08);
  return from + fused(-versine, from, sinc * arc);
}

// (1 − φ cot φ)/φ² of an arc with φ² = `square`: what an arc resists a shift of its first point less across
// than along, relative to φ².
template <class T>
inline T arc_shear(const T& square) {
  return detail::polynomial(square, 0.3333333333333333, 0.0222222222222175, 0.0021164021168736877,
                            0.00021164019398614095, 2.1378113471335028e-05, 2.161538502993758e-06,
                            2.321401373072035e-07);
}

// A vector turned by the shortest rotation that takes one unit vector to another.
inline Vec3 turned_between(const Vec3& v, const Vec3& from, const Vec3& to) {
  const Vec3 sum = from + to;
  return v - dot(sum, v) / (1 + dot(from, to)) * sum + 2 * dot(from, v) * to;
}

// A vector rotated by the unit quaternion (w, x, y, z).
template <class T>
inline Vec<3, T> rotated(const Vec<4, T>& quaternion, const Vec<3, T>& v) {
  const Vec<3, T> axis = {{quaternion[1], quaternion[2], quaternion[3]}};
  const Vec<3, T> twice = T(2) * cross(axis, v);
  return fused(quaternion[0], twice, v) + cross(axis, twice);
}
// By its inverse.
template <class T>
inline Vec<3, T> rotated_back(const Vec<4, T>& quaternion, const Vec<3, T>& v) {
  return rotated(Vec<4, T>{{quaternion[0], -quaternion[1], -quaternion[2], -quaternion[3]}}, v);
}
// ½ (0, r) q: change of the quaternion q of a body, to first order, as the body turns by a vector r (rad).
template <class T>
inline Vec<4, T> quaternion_change(const Vec<4, T>& quaternion, const Vec<3, T>& rotation) {
  const Vec<3, T> half = T(0.5) * rotation, axis = {{quaternion[1], quaternion[2], quaternion[3]}};
  const Vec<3, T> change = quaternion[0] * half + cross(half, axis);
  return {{-dot(half, axis), change[0], change[1], change[2]}};
}

}  // namespace scree
