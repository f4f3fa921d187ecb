#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <scree/plugin/vec.hpp>

// Exact volumes of spheres and areas of discs in parts of space. Bounds may be infinite. Errors are of
// round-off of the whole sphere: some 1e-15 R³, and 1e-15 R² for discs.

namespace scree {

namespace detail {

inline double clamp_to(double x, double radius) { return std::clamp(x, -radius, radius); }

// Volume of a sphere of radius R at the origin in x > a.
inline double sphere_beyond(double radius, double a) {
  const double height = radius - clamp_to(a, radius);
  return std::numbers::pi * height * height * (radius - height / 3);
}

// ∫ A(x) dx from −q to x, up to a constant, with A the area of the section of a sphere at x in y > b, and
// q² = R² − b²:  (R²x − x³/3) acos(b/ρ) + ⅔R³ atan(bx/(Rs)) − ⅔bxs − (R²b − b³/3) asin(x/q),
// ρ² = R² − x²,  s² = q² − x².
inline double wedge_integral(double radius, double b, double x) {
  const double r2 = radius * radius, q = std::sqrt(std::max(0.0, r2 - b * b));
  const double s = std::sqrt(std::max(0.0, (q - x) * (q + x)));
  // acos(b/ρ) and asin(x/q) from the same s: errors of s cancel in the sum, however small b is.
  const double angle = s > 0 || b != 0 ? std::atan2(s, b) : 0.5 * std::numbers::pi;
  const double turn = std::atan2(x, s);
  return (r2 - x * x / 3) * x * angle + 2.0 / 3 * r2 * radius * std::atan2(b * x, radius * s) -
         2.0 / 3 * b * x * s - (r2 - b * b / 3) * b * turn;
}

// Volume of a sphere in from < x < to and y > b.
inline double sphere_wedge(double radius, double b, double from, double to) {
  from = clamp_to(from, radius);
  to = clamp_to(to, radius);
  if (!(from < to)) return 0;
  const auto slab = [&](double low, double high) {
    return low < high ? sphere_beyond(radius, low) - sphere_beyond(radius, high) : 0;
  };
  if (b >= radius) return 0;
  if (b <= -radius) return slab(from, to);
  // Beyond |x| = q a section is wholly on one side of y = b.
  const double q = std::sqrt(radius * radius - b * b);
  const double low = std::clamp(from, -q, q), high = std::clamp(to, -q, q);
  const double inner = low < high ? wedge_integral(radius, b, high) - wedge_integral(radius, b, low) : 0;
  return inner + (b < 0 ? slab(from, std::min(to, -q)) + slab(std::max(from, q), to) : 0);
}

// Volume of a sphere in x > a, y > b, z > c.
inline double sphere_in_octant(double radius, double a, double b, double c) {
  a = clamp_to(a, radius);
  b = clamp_to(b, radius);
  c = clamp_to(c, radius);
  const double h2 = radius * radius - b * b - c * c;
  const double h = h2 > 0 ? std::sqrt(h2) : 0;
  // For |x| < h the line y = b, z = c is within the section, whose area there is ½(A_b + A_c) − ¼πρ² + bc.
  const double low = std::clamp(a, -h, h);
  double volume = 0;
  if (low < h)
    volume = 0.5 * (sphere_wedge(radius, b, low, h) + sphere_wedge(radius, c, low, h)) + b * c * (h - low) -
             0.25 * (sphere_beyond(radius, low) - sphere_beyond(radius, h));
  // Elsewhere the two segments that are cut off are apart, or one holds the other.
  const auto outside = [&](double from, double to) {
    if (!(from < to) || (b >= 0 && c >= 0)) return 0.0;
    if (b < 0 && c < 0)
      return sphere_wedge(radius, b, from, to) + sphere_wedge(radius, c, from, to) -
             (sphere_beyond(radius, from) - sphere_beyond(radius, to));
    return sphere_wedge(radius, b < 0 ? c : b, from, to);
  };
  return volume + outside(a, std::min(radius, -h)) + outside(std::max(a, h), radius);
}

// Area of a disc of radius R at the origin in x > a.
inline double disc_beyond(double radius, double a) {
  a = clamp_to(a, radius);
  const double half_chord = std::sqrt((radius - a) * (radius + a));
  return radius * radius * std::atan2(half_chord, a) - a * half_chord;
}

// Area of a disc in x > a, y > b.
inline double disc_in_quadrant(double radius, double a, double b) {
  a = clamp_to(a, radius);
  b = clamp_to(b, radius);
  const double all = std::numbers::pi * radius * radius;
  const double beyond_a = disc_beyond(radius, a), beyond_b = disc_beyond(radius, b);
  if (a * a + b * b < radius * radius) return 0.5 * (beyond_a + beyond_b) - 0.25 * all + a * b;
  if (a >= 0 && b >= 0) return 0;
  if (a < 0 && b < 0) return beyond_a + beyond_b - all;
  return a < 0 ? beyond_b : beyond_a;
}

// α − sin α cos α, by its series where the difference would lose digits.
inline double angle_less_sine(double angle) {
  if (angle > 0.4) return angle - std::sin(angle) * std::cos(angle);
  // ½(y − sin y), y = 2α
  const double y = 2 * angle, y2 = y * y;
  double term = y * y2 / 6, sum = 0;
  for (int n = 4; n < 20; n += 2) {
    sum += term;
    term *= -y2 / (n * (n + 1));
  }
  return 0.5 * sum;
}

// Area that two discs have in common whose circles cross: a segment of each, on its side of their chord.
inline double crossing_discs(double radius_a, double radius_b, double distance) {
  const double a = std::min(radius_a, radius_b), b = std::max(radius_a, radius_b);
  const double gap = distance - b;
  const double from_a = (gap * (distance + b) + a * a) / (2 * distance), from_b = distance - from_a;
  const double square = (a + b + distance) * (a + gap) * (a - gap) * (distance + b - a);
  const double half_chord = std::sqrt(std::max(0.0, square)) / (2 * distance);
  return a * a * angle_less_sine(std::atan2(half_chord, from_a)) +
         b * b * angle_less_sine(std::atan2(half_chord, from_b));
}

}  // namespace detail

// Volume (m³) of a sphere of a radius (m) around `centre` in the box from `lower` to `upper`.
inline double sphere_in_box(const Vec3& centre, double radius, const Vec3& lower, const Vec3& upper) {
  std::array<double, 3> ends[2];
  for (std::size_t k = 0; k < 3; ++k) {
    ends[0][k] = lower[int(k)] - centre[int(k)];
    ends[1][k] = upper[int(k)] - centre[int(k)];
    if (!(ends[0][k] < ends[1][k]) || ends[0][k] >= radius || ends[1][k] <= -radius) return 0;
  }
  double volume = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
    volume +=
        ((x + y + z) % 2 ? -1 : 1) * detail::sphere_in_octant(radius, ends[x][0], ends[y][1], ends[z][2]);
  }
  return std::max(0.0, volume);
}

// Area (m²) of a disc in the rectangle from `lower` to `upper`; z is ignored.
inline double disc_in_rectangle(const Vec3& centre, double radius, const Vec3& lower, const Vec3& upper) {
  std::array<double, 2> ends[2];
  for (std::size_t k = 0; k < 2; ++k) {
    ends[0][k] = lower[int(k)] - centre[int(k)];
    ends[1][k] = upper[int(k)] - centre[int(k)];
    if (!(ends[0][k] < ends[1][k]) || ends[0][k] >= radius || ends[1][k] <= -radius) return 0;
  }
  double area = 0;
  for (int corner = 0; corner < 4; ++corner) {
    const int x = corner & 1, y = corner >> 1;
    area += ((x + y) % 2 ? -1 : 1) * detail::disc_in_quadrant(radius, ends[x][0], ends[y][1]);
  }
  return std::max(0.0, area);
}

// Volume (m³) that two spheres have in common, or, in two dimensions, area (m²) of two discs.
inline double common_volume(int dimension, double radius_a, double radius_b, double distance) {
  const double smaller = std::min(radius_a, radius_b);
  if (distance >= radius_a + radius_b) return 0;
  if (distance <= std::abs(radius_a - radius_b))
    return dimension == 2 ? std::numbers::pi * smaller * smaller
                          : 4.0 / 3 * std::numbers::pi * smaller * smaller * smaller;
  if (dimension == 2) return detail::crossing_discs(radius_a, radius_b, distance);
  // The plane of the circle in which the surfaces meet cuts a cap off each.
  const double from_a =
      (distance * distance + (radius_a - radius_b) * (radius_a + radius_b)) / (2 * distance);
  const double from_b = distance - from_a;
  return detail::sphere_beyond(radius_a, from_a) + detail::sphere_beyond(radius_b, from_b);
}

// Volume (m³) of a sphere, or area (m²) of a disc.
inline double volume_of_sphere(int dimension, double radius) {
  return dimension == 2 ? std::numbers::pi * radius * radius
                        : 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

}  // namespace scree
