#include "surfaces/triangle_tree.hpp"

#include "machine/instruction_levels.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace scree {

namespace {

constexpr std::uint32_t triangles_in_leaf = 2;
using Waiting = std::array<std::uint32_t, 64>;  // a tree of 2^32 triangles is 31 deep

Bounds bounds_of(const Triangle& triangle) {
  Bounds bounds = Bounds::nowhere();
  for (const Vec3& corner : triangle.corner) bounds.include(corner);
  return bounds;
}

double distance_from(const Triangle& triangle, const Vec3& x) {
  return norm(x - nearest_on(triangle, x).point);
}

// least: (m) distance from which on there is a direction.
NearTriangle near_triangle(const TriangleTree& tree, std::uint32_t t, const Vec3& x, double least) {
  const Vec3 away = x - nearest_on(tree[t], x).point;
  const double distance = norm(away);
  return {t, distance, distance > least ? 1 / distance * away : Vec3{}};
}

}  // namespace

TriangleTree::TriangleTree(const std::vector<Triangle>& triangles, std::vector<std::uint32_t>& order) {
  order.resize(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  nodes_.emplace_back();
  grow(triangles, 0, 0, std::uint32_t(triangles.size()), order);
  for (const std::uint32_t t : order) triangles_.push_back(triangles[t]);
}

// Halves the triangles of a node by the middles of their bounds along its longest axis.
void TriangleTree::grow(const std::vector<Triangle>& triangles, std::uint32_t node, std::uint32_t begin,
                        std::uint32_t end, std::vector<std::uint32_t>& order) {
  Bounds bounds = Bounds::nowhere(), middles = Bounds::nowhere();
  const auto middle_of = [&](std::uint32_t t) {
    const Bounds of = bounds_of(triangles[t]);
    return 0.5 * (of.lower + of.upper);
  };
  for (std::uint32_t k = begin; k < end; ++k) {
    for (const Vec3& corner : triangles[order[k]].corner) bounds.include(corner);
    middles.include(middle_of(order[k]));
  }
  nodes_[node] = {bounds, begin, end - begin};
  if (end - begin <= triangles_in_leaf) return;
  const Vec3 extent = middles.upper - middles.lower;
  const int axis = int(std::max_element(extent.component, extent.component + 3) - extent.component);
  const std::uint32_t middle = (begin + end) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](std::uint32_t s, std::uint32_t t) {
                     return std::make_tuple(middle_of(s)[axis], s) < std::make_tuple(middle_of(t)[axis], t);
                   });
  const auto children = std::uint32_t(nodes_.size());
  nodes_[node] = {bounds, children, 0};
  nodes_.resize(nodes_.size() + 2);
  grow(triangles, children, begin, middle, order);
  grow(triangles, children + 1, middle, end, order);
}

// Private to this file, see SCREE_EVERY_LEVEL.
struct TriangleTree::Loops {
  SCREE_EVERY_LEVEL_INLINED static void add_near(const TriangleTree& tree, const Vec3& x, double reach,
                                                 std::vector<NearTriangle>& near) {
    Waiting waiting = {0};
    for (std::size_t count = 1; count > 0;) {
      const Node& node = tree.nodes_[waiting[--count]];
      if (node.bounds.square_to(x) > reach * reach) continue;
      if (node.count == 0) {
        waiting[count++] = node.first + 1, waiting[count++] = node.first;
        continue;
      }
      for (std::uint32_t t = node.first; t < node.first + node.count; ++t)
        if (const NearTriangle triangle = near_triangle(tree, t, x, hidden * reach);
            triangle.distance <= reach)
          near.push_back(triangle);
    }
  }

  SCREE_EVERY_LEVEL_INLINED static NearTriangle nearest(const TriangleTree& tree, const Vec3& x,
                                                        double most) {
    NearTriangle best = {0, most};
    Waiting waiting = {0};
    for (std::size_t count = 1; count > 0;) {
      const Node& node = tree.nodes_[waiting[--count]];
      if (node.bounds.square_to(x) > best.distance * best.distance) continue;
      if (node.count == 0) {
        // The nearer child is visited first.
        const bool first =
            tree.nodes_[node.first].bounds.square_to(x) <= tree.nodes_[node.first + 1].bounds.square_to(x);
        waiting[count++] = node.first + first, waiting[count++] = node.first + !first;
        continue;
      }
      for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
        const double distance = distance_from(tree[t], x);
        if (std::tie(distance, t) < std::tie(best.distance, best.triangle)) best = {t, distance};
      }
    }
    return best;
  }
};

void TriangleTree::find_near(const Vec3& x, double reach, std::vector<NearTriangle>& near) const {
  near.clear();
  Loops::add_near(*this, x, reach, near);
  std::sort(near.begin(), near.end(), [](const NearTriangle& a, const NearTriangle& b) {
    return std::tie(a.distance, a.triangle) < std::tie(b.distance, b.triangle);
  });
}

NearTriangle TriangleTree::nearest(const Vec3& x, double most) const {
  return Loops::nearest(*this, x, most);
}

void TriangleTree::find_along(const Vec3& from, const Vec3& to, std::vector<std::uint32_t>& triangles) const {
  triangles.clear();
  Waiting waiting = {0};
  for (std::size_t count = 1; count > 0;) {
    const Node& node = nodes_[waiting[--count]];
    if (!node.bounds.meets(from, to)) continue;
    if (node.count == 0)
      waiting[count++] = node.first + 1, waiting[count++] = node.first;
    else
      for (std::uint32_t k = 0; k < node.count; ++k) triangles.push_back(node.first + k);
  }
}

}  // namespace scree
