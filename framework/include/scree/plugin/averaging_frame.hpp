#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <scree/plugin/sphere_sections.hpp>
#include <scree/plugin/sphere_volumes.hpp>
#include <scree/plugin/vec.hpp>

namespace scree {

// A part of space at one time, and its bins of equal width.
struct AveragingFrame {
  // enclosed: what walls and periodic faces enclose; nothing lies outside.
  enum Region : int { enclosed, box, sphere, cylinder, cone };
  static constexpr int radial = 3;  // of `along`; else an axis

  int dimension = 3, along = 0, axis = 2, bins = 1;
  Region region = enclosed;
  Vec3 lower = {}, upper = {}, centre = {}, enclosed_length = {};  // (m)
  Vec3 period = {};                                                // (m) 0 along axes that are not periodic
  double radius = 0, length = 0;                                   // (m) radius of a cone: the larger one
  double radius_low = 0, radius_high = 0;  // (m) of a cone, at its ends along its axis
  double first_edge = 0, width = 0;        // (m) of the bins

  AveragingFrame with_edges() const {
    AveragingFrame f = *this;
    if (round()) {
      for (int k = 0; k < 3; ++k) {
        const double half = has_axis() && k == axis ? length / 2 : radius;
        f.lower[k] = centre[k] - half;
        f.upper[k] = centre[k] + half;
      }
    }
    f.first_edge = along == radial ? 0 : f.lower[along];
    f.width = (along == radial ? radius : f.upper[along] - f.lower[along]) / bins;
    return f;
  }

  // Volume of a bin (m³), in two dimensions its area (m²).
  double volume(int bin) const {
    const double low = first_edge + bin * width, high = low + width;
    if (region == enclosed || region == box) {
      double product = 1;
      for (int k = 0; k < dimension; ++k) product *= length_along(k) / (k == along ? bins : 1);
      return product;
    }
    if (along == radial) return within(high) - within(low);
    if (region == cylinder) return within(radius) / bins;
    if (region == cone)
      return bins == 1 ? frustum(radius_low, radius_high, length)
                       : frustum(radius_at(low), radius_at(high), width);
    const auto beyond = [&](double from) {
      return dimension == 2 ? detail::disc_beyond(radius, from - centre[along])
                            : detail::sphere_beyond(radius, from - centre[along]);
    };
    return beyond(low) - beyond(high);
  }

  // The periodic image of a point that is nearest to the middle of the region.
  Vec3 nearest_image(Vec3 x) const {
    for (int k = 0; region != enclosed && k < dimension; ++k)
      if (period[k] > 0) x[k] -= period[k] * std::round((x[k] - 0.5 * (lower[k] + upper[k])) / period[k]);
    return x;
  }

  // The bin of a point, or −1 if it lies outside.
  int bin_of(const Vec3& point) const {
    const Vec3 x = nearest_image(point);
    if (region == box || has_axis())
      for (int k = 0; k < dimension; ++k)
        if ((region == box || k == axis) && !(x[k] >= lower[k] && x[k] < upper[k])) return -1;
    if (round() && !(distance(x) < (region == cone ? radius_at(x[axis]) : radius))) return -1;
    const double u = along == radial ? distance(x) : x[along];
    if (bins == 1) return 0;
    return std::clamp(int(std::floor((u - first_edge) / width)), 0, bins - 1);
  }

  // Calls add(bin, share) for each bin that holds a part of the straight line from `start` to start + step;
  // share: length of that part over the length of the line.
  template <class Add>
  void split_line(const Vec3& start, const Vec3& step, const Add& add) const {
    if (region == enclosed && bins == 1) return add(0, 1.0);
    each_image(start, step, [&](const Vec3& from) { split_image(from, step, add); });
  }

  // Calls add(bin, volume) for each bin that has a part of a sphere or disc.
  template <class Add>
  void split_sphere(const Vec3& position, double size, const Add& add) const {
    const Vec3 reach = Vec3{{size, size, size}};
    each_image(position - reach, 2.0 * reach, [&](const Vec3& corner) {
      const Vec3 x = corner + reach;
      if (round() && along == radial) return split_by_shells(x, size, add);
      if (round() && bins == 1) return add_if_any(0, part_within(x, size, radius), add);
      if (round()) return split_by_slices(x, size, add);
      for (int bin = first_bin(x, size); bin <= last_bin(x, size); ++bin)
        add_if_any(bin, part_in_box(x, size, bin), add);
    });
  }

 private:
  bool round() const { return region == sphere || has_axis(); }
  bool has_axis() const { return region == cylinder || region == cone; }
  double slope() const { return region == cone ? (radius_high - radius_low) / length : 0; }
  // Of a cone at a height along its axis (m); below 0 beyond its apex.
  double radius_at(double height) const { return radius_low + slope() * (height - lower[axis]); }
  double length_along(int k) const { return region == enclosed ? enclosed_length[k] : upper[k] - lower[k]; }

  // Volume of the region within a distance of the centre or axis.
  double within(double distance) const {
    if (region == cylinder) return std::numbers::pi * distance * distance * length;
    return volume_of_sphere(dimension, distance);
  }
  // From the centre, or from the axis of a cylinder.
  double distance(const Vec3& x) const {
    double sum = 0;
    for (int k = 0; k < dimension; ++k)
      if (!has_axis() || k != axis) sum += (x[k] - centre[k]) * (x[k] - centre[k]);
    return std::sqrt(sum);
  }
  // Calls visit(start) for each periodic image of a line that may reach into the region.
  template <class Visit>
  void each_image(const Vec3& start, const Vec3& step, const Visit& visit) const {
    const Vec3 half = 0.5 * step, nearest = nearest_image(start + half) - half;
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int k = 0; region != enclosed && k < dimension; ++k) {
      const double reach = std::abs(half[k]), middle = nearest[k] + half[k];
      if (!(period[k] > 0)) {
        if (middle + reach < lower[k] || middle - reach > upper[k]) return;
        continue;
      }
      low[k] = middle + reach - period[k] > lower[k] ? -1 : 0;
      high[k] = middle - reach + period[k] < upper[k] ? 1 : 0;
    }
    Vec3 shift = {};
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) {
          shift = {{x * period[0], y * period[1], z * period[2]}};
          visit(nearest + shift);
        }
  }

  struct Interval {
    double from, to;
    double size() const { return std::max(0.0, to - from); }
    Interval cut(const Interval& other) const { return {std::max(from, other.from), std::min(to, other.to)}; }
  };
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  // Where a line lies between two heights along an axis, in parts of the line.
  static Interval between(double start, double step, double low, double high) {
    if (step == 0) return start >= low && start < high ? Interval{-infinite, infinite} : Interval{0, -1};
    const double a = (low - start) / step, b = (high - start) / step;
    return {std::min(a, b), std::max(a, b)};
  }
  // Where it lies within a distance of the centre or axis.
  Interval inside(const Vec3& start, const Vec3& step, double limit) const {
    double a = 0, b = 0, c = -limit * limit;
    for (int k = 0; k < dimension; ++k) {
      if (has_axis() && k == axis) continue;
      const double off = start[k] - centre[k];
      a += step[k] * step[k];
      b += step[k] * off;
      c += off * off;
    }
    if (region == cone) return inside_cone(a, b, c + limit * limit, start, step);
    if (a == 0) return c < 0 ? Interval{-infinite, infinite} : Interval{0, -1};
    const double root = b * b - a * c;
    if (!(root > 0)) return {0, -1};
    return {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
  }

  // Where the squared distance a t² + 2 b t + c of a line from the axis is below the cone's, within its ends.
  Interval inside_cone(double a, double b, double c, const Vec3& start, const Vec3& step) const {
    const double radius_here = radius_at(start[axis]), growth = slope() * step[axis];
    a -= growth * growth, b -= radius_here * growth, c -= radius_here * radius_here;
    if (a == 0) {
      if (b == 0) return c < 0 ? Interval{-infinite, infinite} : Interval{0, -1};
      return b > 0 ? Interval{-infinite, -0.5 * c / b} : Interval{-0.5 * c / b, infinite};
    }
    const double square = b * b - a * c;
    if (!(square > 0)) return a > 0 ? Interval{0, -1} : Interval{-infinite, infinite};
    const double root = std::sqrt(square);
    if (a > 0) return {(-b - root) / a, (-b + root) / a};
    // Steeper than the cone: it enters it once, and its mirror image beyond the apex at the other place.
    return growth > 0 ? Interval{(-b - root) / a, infinite} : Interval{-infinite, (-b + root) / a};
  }

  template <class Add>
  void split_image(const Vec3& start, const Vec3& step, const Add& add) const {
    Interval line = {0, 1};
    for (int k = 0; k < dimension; ++k)
      if (region == box || (has_axis() && k == axis))
        line = line.cut(between(start[k], step[k], lower[k], upper[k]));
    if (region == sphere || region == cone || (region == cylinder && along != radial))
      line = line.cut(inside(start, step, radius));
    if (!(line.from < line.to)) return;
    if (bins == 1 && along != radial) return add(0, line.size());
    if (along == radial) {
      double before = 0;
      for (int bin = 0; bin < bins; ++bin) {
        const double now = line.cut(inside(start, step, (bin + 1) * width)).size();
        if (now > before) add(bin, now - before);
        before = now;
      }
      return;
    }
    const double a = start[along] + line.from * step[along], b = start[along] + line.to * step[along];
    for (int bin = bin_at(std::min(a, b)); bin <= bin_at(std::max(a, b)); ++bin)
      if (const double part =
              line.cut(between(start[along], step[along], low_edge(bin), high_edge(bin))).size();
          part > 0)
        add(bin, part);
  }
  int bin_at(double height) const {
    return int(std::clamp(std::floor((height - first_edge) / width), 0.0, double(bins - 1)));
  }
  // The outer bins of an enclosed scene hold what lies in its walls too.
  double low_edge(int bin) const {
    return region == enclosed && bin == 0 ? -infinite : first_edge + bin * width;
  }
  double high_edge(int bin) const {
    return region == enclosed && bin == bins - 1 ? infinite : first_edge + (bin + 1) * width;
  }

  int first_bin(const Vec3& x, double size) const { return bins == 1 ? 0 : bin_at(x[along] - size); }
  int last_bin(const Vec3& x, double size) const { return bins == 1 ? 0 : bin_at(x[along] + size); }
  double part_in_box(const Vec3& x, double size, int bin) const {
    Vec3 low = lower, high = upper;
    for (int k = 0; k < 3; ++k) {
      if (region != enclosed && k < dimension) continue;
      low[k] = -infinite;
      high[k] = infinite;
    }
    if (bins > 1) {
      low[along] = low_edge(bin);
      high[along] = high_edge(bin);
    }
    return dimension == 2 ? disc_in_rectangle(x, size, low, high) : sphere_in_box(x, size, low, high);
  }
  template <class Add>
  static void add_if_any(int bin, double part, const Add& add) {
    if (part > 0) add(bin, part);
  }
  // Part of a sphere within a distance of the centre or axis of the region.
  double part_within(const Vec3& x, double size, double limit) const {
    if (region == sphere) return common_volume(dimension, size, limit, distance(x));
    const double radius_here = region == cone ? radius_at(x[axis]) : limit;
    return sphere_in_round(size, {3, true, radius_here, distance(x), 0, slope()}, lower[axis] - x[axis],
                           upper[axis] - x[axis]);
  }
  template <class Add>
  void split_by_shells(const Vec3& x, double size, const Add& add) const {
    double before = 0;
    for (int bin = 0; bin < bins; ++bin) {
      const double now = part_within(x, size, (bin + 1) * radius / bins);
      add_if_any(bin, now - before, add);
      before = now;
    }
  }
  template <class Add>
  void split_by_slices(const Vec3& x, double size, const Add& add) const {
    const Vec3 off = x - centre;
    double square = 0;
    for (int k = 0; k < dimension; ++k)
      if (k != along) square += off[k] * off[k];
    const double radius_here = region == cone ? radius_at(x[axis]) : radius;
    const RoundRegion beside = {dimension, has_axis(), radius_here, std::sqrt(square), -off[along], slope()};
    for (int bin = first_bin(x, size); bin <= last_bin(x, size); ++bin)
      add_if_any(bin, sphere_in_round(size, beside, low_edge(bin) - x[along], high_edge(bin) - x[along]),
                 add);
  }
};

}  // namespace scree
