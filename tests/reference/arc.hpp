#pragma once

#include "vector.hpp"

#include <cmath>

// Arcs of great circles of the unit sphere, with their derivatives.

namespace reference {

// φ/sin φ and its derivative with respect to cos φ.
struct Stretching {
  double value = 1, slope = -1.0 / 3;
};

inline Stretching stretching(double sine, double cosine) {
  if (sine < 1e-3) {  // next terms: φ⁴
    const double square = sine * sine;
    return {1 + square / 6, -1.0 / 3 - 2.0 / 15 * square};
  }
  const double arc = std::atan2(sine, cosine);
  return {arc / sine, (arc * cosine / sine - 1) / (sine * sine)};
}

// The arc from one unit vector to another, as a vector in the tangent plane of the first.
struct Arc {
  Arc(const Vector& from, const Vector& to)
      : begin(from), end(to), cosine(dot(from, to)), across(to - cosine * from) {
    stretch = stretching(norm(across), cosine);
    vector = stretch.value * across;
  }
  // Gradients of t·vector with t fixed in the tangent plane of begin.
  Vector gradient_at_end(const Vector& t) const {
    return stretch.slope * dot(end, t) * begin + stretch.value * t;
  }
  Vector gradient_at_begin(const Vector& t) const {
    return stretch.slope * dot(end, t) * end - stretch.value * cosine * t;
  }

  Vector begin, end;
  double cosine;
  Vector across, vector;
  Stretching stretch;
};

inline Vector end_of_arc(const Vector& begin, const Vector& arc) {
  const double length = norm(arc);
  return std::cos(length) * begin + std::sin(length) * direction(arc);
}

}  // namespace reference
