#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <scree/plugin/quadrature.hpp>
#include <scree/plugin/sphere_volumes.hpp>

// Volumes of spheres in cylinders, cones and slices of spheres, as integrals of sections.

namespace scree {

// A round region beside a sphere at the origin: a cylinder or a cone along x, or another sphere. In two
// dimensions both spheres are discs, and sections are lines.
struct RoundRegion {
  int dimension = 3;
  bool cylinder = true;
  double radius = 0;  // (m) of a cone at x = 0, where it may be below 0
  double away = 0;    // (m) ≥ 0 distance of its centre or axis from the x axis
  double along = 0;   // (m) x of the centre of a sphere
  double slope = 0;   // of the radius of a cone along x, which is not below 0 where its volume is asked for
};

// Volume (m³) of a cone between two sections, given their radii (m).
inline double frustum(double radius, double other, double length) {
  return std::numbers::pi / 3 * length * (radius * radius + radius * other + other * other);
}

namespace detail {

// The sections across x of a sphere around the origin and of a region.
class RoundSections {
 public:
  RoundSections(double size, const RoundRegion& region) : size_(size), region_(region) {}

  double volume(double from, double to) const {
    from = std::max(from, -size_);
    to = std::min(to, size_);
    if (!region_.cylinder) {
      from = std::max(from, region_.along - region_.radius);
      to = std::min(to, region_.along + region_.radius);
    }
    if (!(from < to)) return 0;
    std::array<double, 6> cut = {from, to, to, to, to, to};
    touching_sections(cut);
    for (double& x : cut) x = std::clamp(x, from, to);
    std::sort(cut.begin(), cut.end());
    double sum = 0;
    for (std::size_t k = 0; k + 1 < cut.size(); ++k)
      if (cut[k] < cut[k + 1]) sum += between(cut[k], cut[k + 1]);
    return sum;
  }

 private:
  // Radius of the section of a sphere at a distance x from its centre.
  static double section(double radius, double x) {
    return std::sqrt(std::max(0.0, (radius - x) * (radius + x)));
  }
  double region_section(double x) const {
    if (region_.slope != 0) return std::max(0.0, region_.radius + region_.slope * x);
    return region_.cylinder ? region_.radius : section(region_.radius, x - region_.along);
  }

  // Where the circles of both sections touch each other, from within or from outside: cut[2] to cut[5].
  void touching_sections(std::array<double, 6>& cut) const {
    if (region_.cylinder) {
      for (const int side : {-1, 1}) {
        // R² − x² = (d ± (r + s x))².
        const double s = side * region_.slope, from_axis = region_.away + side * region_.radius;
        const double square = 1 + s * s, root = section(size_ * std::sqrt(square), from_axis);
        cut[side < 0 ? 2 : 4] = (-from_axis * s - root) / square;
        cut[side < 0 ? 3 : 5] = (-from_axis * s + root) / square;
      }
      return;
    }
    // The ends, along x, of the circle in which the surfaces of both spheres meet.
    const double distance = std::hypot(region_.along, region_.away);
    if (!(distance > 0)) return;
    const double height =
        ((distance - region_.radius) * (distance + region_.radius) + size_ * size_) / (2 * distance);
    const double middle = height * region_.along / distance;
    const double half = section(size_, height) * region_.away / distance;
    cut[2] = middle - half;
    cut[3] = middle + half;
  }

  // Between two such places the circles cross, or one holds the other, or they are apart, everywhere.
  double between(double from, double to) const {
    const double middle = 0.5 * (from + to);
    const double own = section(size_, middle), other = region_section(middle);
    if (own + other <= region_.away) return 0;
    if (own - other <= -region_.away) return slice(size_, from, to);
    if (own - other >= region_.away) {
      if (region_.slope != 0) return frustum(region_section(from), region_section(to), to - from);
      if (region_.cylinder) return std::numbers::pi * other * other * (to - from);
      return slice(region_.radius, from - region_.along, to - region_.along);
    }
    const auto common = [&](double x) {
      return common_section(region_.dimension, section(size_, x), region_section(x), region_.away);
    };
    // A section of a large region is known to round-off of its radius.
    const double radius =
        region_.slope != 0 ? std::max(region_section(from), region_section(to)) : region_.radius;
    const double smaller = std::min(size_, radius);
    const double tolerance =
        3e-16 * volume_of_sphere(region_.dimension, smaller) * std::max(1.0, 0.01 * radius / smaller);
    return integral_with_root_ends(common, from, to, tolerance);
  }
  double slice(double radius, double from, double to) const {
    if (region_.dimension == 2) return disc_beyond(radius, from) - disc_beyond(radius, to);
    return sphere_beyond(radius, from) - sphere_beyond(radius, to);
  }
  // What two sections have in common: an area, or in two dimensions a length.
  static double common_section(int dimension, double a, double b, double distance) {
    if (dimension == 3) return common_volume(2, a, b, distance);
    return std::max(0.0, std::min(a, distance + b) - std::max(-a, distance - b));
  }

  double size_;
  RoundRegion region_;
};

}  // namespace detail

// Volume (m³), in two dimensions area (m²), that a sphere of radius `size` (m) around the origin has in a
// region between from and to along x, which may be infinite. Errors: some 1e-13 of the smaller volume.
inline double sphere_in_round(double size, const RoundRegion& region, double from, double to) {
  return detail::RoundSections(size, region).volume(from, to);
}

}  // namespace scree
