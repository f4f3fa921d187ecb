#pragma once

#include <cmath>

namespace scree {

// Vector of D components. T is double or a dual number. All operations are branch-free.
template <int D, class T = double>
struct Vec {
  T component[D];

  constexpr T& operator[](int k) { return component[k]; }
  constexpr const T& operator[](int k) const { return component[k]; }

  constexpr Vec& operator+=(const Vec& b) {
    for (int k = 0; k < D; ++k) component[k] += b[k];
    return *this;
  }
  constexpr Vec& operator-=(const Vec& b) {
    for (int k = 0; k < D; ++k) component[k] -= b[k];
    return *this;
  }
  friend constexpr Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend constexpr Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend constexpr Vec operator*(const T& s, Vec a) {
    for (int k = 0; k < D; ++k) a[k] = s * a[k];
    return a;
  }
  friend constexpr Vec operator*(const Vec& a, const T& s) { return s * a; }
  friend constexpr Vec operator-(const Vec& a) { return T(-1) * a; }
  friend constexpr bool operator==(const Vec&, const Vec&) = default;
};

using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

// Number of components of an angular velocity, torque or couple in D dimensions.
template <int D>
inline constexpr int spin_components = D == 2 ? 1 : 3;

// Number of components of an orientation in D dimensions: an angle in 2D, a quaternion (w, x, y, z) in 3D.
template <int D>
inline constexpr int orientation_components = D == 2 ? 1 : 4;

// Index of the first axis about which bodies turn in D dimensions: z in 2D, x in 3D.
template <int D>
inline constexpr int first_spin_axis = D == 2 ? 2 : 0;

// a b + c, rounded once: one instruction on processors since 2013; older ones compute the same bits in
// software, slowly. Written explicitly, because the compiler would fuse at some instruction levels and not at
// others.
template <class T>
inline T fused(const T& a, const T& b, const T& c) {
  using std::fma;
  return fma(a, b, c);
}
template <int D, class T>
inline Vec<D, T> fused(const T& s, const Vec<D, T>& a, Vec<D, T> b) {
  for (int k = 0; k < D; ++k) b[k] = fused(s, a[k], b[k]);
  return b;
}

template <int D, class T>
inline T dot(const Vec<D, T>& a, const Vec<D, T>& b) {
  T sum = a[0] * b[0];
  for (int k = 1; k < D; ++k) sum = fused(a[k], b[k], sum);
  return sum;
}

template <int D, class T>
T norm(const Vec<D, T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

template <class T>
inline Vec<3, T> cross(const Vec<3, T>& a, const Vec<3, T>& b) {
  return {{fused(a[1], b[2], -(a[2] * b[1])), fused(a[2], b[0], -(a[0] * b[2])),
           fused(a[0], b[1], -(a[1] * b[0]))}};
}

inline Vec3 vector_of(const double (&v)[3]) { return {{v[0], v[1], v[2]}}; }

// In 2D a spin is its z component: s × a and a × b.
template <class T>
constexpr Vec<2, T> cross(const Vec<1, T>& s, const Vec<2, T>& a) {
  return {{-s[0] * a[1], s[0] * a[0]}};
}
template <class T>
inline Vec<1, T> cross(const Vec<2, T>& a, const Vec<2, T>& b) {
  return {{fused(a[0], b[1], -(a[1] * b[0]))}};
}

// Component of a perpendicular to the unit vector n.
template <int D, class T>
inline Vec<D, T> tangential_part(const Vec<D, T>& a, const Vec<D, T>& n) {
  return fused(-dot(a, n), n, a);
}

}  // namespace scree
