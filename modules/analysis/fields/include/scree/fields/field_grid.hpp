#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <scree/plugin/vec.hpp>

namespace scree::fields {

// A part of a grid between two numbers along one axis: [begin, end).
struct GridSlab {
  std::size_t axis, begin, end;
};

// Points on which fields are computed, in the middle of cells that fill a box; x varies fastest.
struct FieldGrid {
  int dimension = 3;
  Vec3 first = {}, spacing = {{1, 1, 1}};  // (m) the first point, and from point to point
  std::array<std::size_t, 3> count = {1, 1, 1};
  Vec3 period = {};  // (m) 0 along axes that are not periodic

  std::size_t size() const { return count[0] * count[1] * count[2]; }
  Vec3 point(std::size_t number) const {
    const std::size_t at[] = {number % count[0], number / count[0] % count[1], number / count[0] / count[1]};
    Vec3 x = first;
    for (int k = 0; k < 3; ++k) x[k] += double(at[k]) * spacing[k];
    return x;
  }
  // Volume of a cell (m³), in 2D its area (m²).
  double cell() const { return spacing[0] * spacing[1] * (dimension == 2 ? 1 : spacing[2]); }
  // Along the axis with the most points, in at most `parts` slabs of nearly equal size.
  std::size_t longest_axis() const {
    return std::size_t(std::max_element(count.begin(), count.end()) - count.begin());
  }
  GridSlab slab(std::size_t part, std::size_t parts) const {
    const std::size_t axis = longest_axis(), n = count[axis];
    return {axis, n * part / parts, n * (part + 1) / parts};
  }

  // Calls visit(number, point − start) for each point of a slab, and each periodic image of it, that may be
  // within `reach` (m) of the line from start to start + line. Points along each axis ascend.
  template <class Visit>
  void each_near(const Vec3& start, const Vec3& line, double reach, const GridSlab& slab,
                 const Visit& visit) const {
    Images images[3];
    for (int k = 0; k < 3; ++k) {
      const bool used = k < dimension;
      const double low = used ? std::min(start[k], start[k] + line[k]) - reach : first[k];
      const double high = used ? std::max(start[k], start[k] + line[k]) + reach : first[k];
      images[k] = images_of(k, low, high);
    }
    for (std::int64_t x = images[0].from; x <= images[0].to; ++x)
      for (std::int64_t y = images[1].from; y <= images[1].to; ++y)
        for (std::int64_t z = images[2].from; z <= images[2].to; ++z) {
          const std::int64_t image[] = {x, y, z};
          visit_image(start, images, image, slab, visit);
        }
  }

 private:
  // The images of the grid, shifted by that many periods, which may have points between low and high (m).
  struct Images {
    std::int64_t from = 0, to = 0;
    double low = 0, high = 0;
  };
  struct Range {
    std::size_t begin, end;
  };

  Images images_of(int k, double low, double high) const {
    Images images = {0, 0, low, high};
    if (k >= dimension || !(period[k] > 0)) return images;
    const double last = first[k] + double(count[std::size_t(k)] - 1) * spacing[k];
    images.from = std::int64_t(std::ceil((low - last) / period[k]));
    images.to = std::int64_t(std::floor((high - first[k]) / period[k]));
    return images;
  }
  Range range(int k, double shift, double low, double high, const GridSlab& slab) const {
    const bool cut = slab.axis == std::size_t(k);
    const double least = double(cut ? slab.begin : 0), most = double(cut ? slab.end : count[std::size_t(k)]);
    const double origin = first[k] + shift;
    const double from = std::clamp(std::ceil((low - origin) / spacing[k]), least, most);
    const double to = std::clamp(std::floor((high - origin) / spacing[k]) + 1, least, most);
    return {std::size_t(from), std::size_t(std::max(from, to))};
  }
  template <class Visit>
  void visit_image(const Vec3& start, const Images (&images)[3], const std::int64_t (&image)[3],
                   const GridSlab& slab, const Visit& visit) const {
    Range ranges[3];
    Vec3 origin = first - start;
    for (int k = 0; k < 3; ++k) {
      const double shift = double(image[k]) * period[k];
      ranges[k] = range(k, shift, images[k].low, images[k].high, slab);
      if (ranges[k].begin == ranges[k].end) return;
      origin[k] += shift;
    }
    for (std::size_t z = ranges[2].begin; z < ranges[2].end; ++z)
      for (std::size_t y = ranges[1].begin; y < ranges[1].end; ++y)
        for (std::size_t x = ranges[0].begin; x < ranges[0].end; ++x)
          visit((z * count[1] + y) * count[0] + x,
                Vec3{{origin[0] + double(x) * spacing[0], origin[1] + double(y) * spacing[1],
                      origin[2] + double(z) * spacing[2]}});
  }
};

}  // namespace scree::fields
