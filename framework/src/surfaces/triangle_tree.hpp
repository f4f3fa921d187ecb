#pragma once

#include "surfaces/triangle.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <scree/column.hpp>

namespace scree {

// A triangle and its distance (m) from a point.
struct NearTriangle {
  std::uint32_t triangle;
  double distance;
  Vec3 away = {};  // unit, from the triangle to the point; 0 if these are so close that round-off hides it

  // A lower bound of the distance from a point that lies `moved` (m) beside the first one, up to round-off:
  // triangles are convex, and so is the distance from them.
  double least_distance(const Vec3& moved) const { return distance + dot(away, moved); }
};

// Triangles that are found by place, in an order in which neighbours are near each other in memory.
class TriangleTree {
 public:
  // Sorts triangles by place; order: set to their former numbers.
  TriangleTree(const std::vector<Triangle>& triangles, std::vector<std::uint32_t>& order);
  TriangleTree() = default;

  // Replaces `near` by the triangles within a distance (m) of x, the nearest first. Distances below `hidden`
  // of this have no direction.
  static constexpr double hidden = 1e-6;
  void find_near(const Vec3& x, double reach, std::vector<NearTriangle>& near) const;
  // The nearest triangle; of several, the one with the lowest number. most: (m) distance beyond which none is
  // looked for; it is then the distance.
  NearTriangle nearest(const Vec3& x, double most = std::numeric_limits<double>::infinity()) const;
  // Replaces `triangles` by triangles, and others, that a line from one point to another may meet.
  void find_along(const Vec3& from, const Vec3& to, std::vector<std::uint32_t>& triangles) const;

  std::size_t size() const { return triangles_.size(); }
  const Triangle& operator[](std::size_t t) const { return triangles_[t]; }

 private:
  struct Node {
    Bounds bounds;
    std::uint32_t first, count;  // triangles of a leaf; count 0: first is the first of two children
  };
  // Loops that are compiled for every instruction level.
  struct Loops;
  void grow(const std::vector<Triangle>& triangles, std::uint32_t node, std::uint32_t begin,
            std::uint32_t end, std::vector<std::uint32_t>& order);

  Column<Triangle> triangles_;
  Column<Node> nodes_;
};

}  // namespace scree
