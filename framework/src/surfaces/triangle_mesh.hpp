#pragma once

#include "surfaces/triangle.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <scree/plugin/abi.h>

namespace scree {

// What was found in the triangles of a mesh, and repaired where that is safe.
struct MeshFindings {
  std::size_t degenerate = 0;    // triangles without area, left out
  std::size_t duplicate = 0;     // triangles that were there before, left out
  std::size_t turned = 0;        // triangles whose corners ran against the triangles beside them, turned
  std::size_t open_edges = 0;    // edges of one triangle
  std::size_t shared_edges = 0;  // edges of three triangles and more
  bool nested = false;           // shells lie within the bounds of other shells
  bool one_sided = false;        // triangles cannot all be turned alike, as of a Moebius strip

  // "2 edges of one triangle, 1 triangle without area"; empty if it has none of these.
  std::string text() const;
  bool closed() const { return open_edges == 0 && shared_edges == 0 && !one_sided; }
};

// A triangulated surface in its own frame, and a tree in which its triangles are found by place.
class TriangleMesh {
 public:
  // numbers: as of a parameter of the type SCREE_MESH_FILE; lengths are multiplied by `scale`. Throws Error
  // without a cure if they are no mesh: "the mesh has no triangles".
  TriangleMesh(std::span<const double> numbers, double scale);

  struct Near {
    std::uint32_t triangle;
    double distance;  // (m)
  };
  // Replaces `near` by the triangles within a distance (m) of x, the nearest first.
  void find_near(const Vec3& x, double reach, std::vector<Near>& near) const;
  // The nearest triangle; of several, the one with the lowest number. most: (m) distance beyond which none is
  // looked for; it is then the distance.
  Near nearest(const Vec3& x, double most = std::numeric_limits<double>::infinity()) const;

  // A point in which two triangles without a common corner cross, and one where the mesh folds back on
  // itself; none if there is none.
  std::optional<Vec3> crossing() const;
  std::optional<Vec3> fold() const;

  std::size_t size() const { return triangles_.size(); }
  const Triangle& triangle(std::size_t t) const { return triangles_[t]; }
  // Sum of the normals of the triangles that meet in a part of a triangle, weighted with their angles: it
  // points to the side on which x is if the part is nearest to x (Baerentzen and Aanaes 2005).
  Vec3 outwards(std::size_t t, TrianglePart part) const;
  // Whether a triangle has an edge at which there is no other, or more than one.
  bool at_border(std::size_t t) const;
  // Points that lie nearer to each other are one (m): round-off of files with single precision.
  double tolerance() const { return tolerance_; }
  const Bounds& bounds() const { return bounds_; }
  double reach() const { return reach_; }  // (m) largest distance of a corner from the origin
  const MeshFindings& findings() const { return findings_; }

 private:
  using Corners = std::array<std::uint32_t, 3>;  // numbers of points
  struct Node {
    Bounds bounds;
    std::uint32_t first, count;  // triangles of a leaf; count 0: first is the first of two children
  };
  // In the order of the tree.
  void add_near(const Vec3& x, double reach, std::vector<Near>& near) const;
  void find_along(const Vec3& from, const Vec3& to, std::vector<std::uint32_t>& triangles) const;
  void turn_outwards(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& shell_of);
  std::vector<Corners> usable(const std::vector<Vec3>& points, const std::vector<Corners>& all);
  void sum_angles(std::size_t points);
  void grow(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  std::vector<Triangle> triangles_;
  std::vector<Corners> corners_, beside_;  // of each triangle, see MeshTopology
  std::vector<Vec3> at_point_;             // normals by their angles
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> in_tree_;  // numbers of triangles in the order of the leaves
  Bounds bounds_ = {};
  double tolerance_ = 0, reach_ = 0;
  MeshFindings findings_;
};

// A mesh of these numbers, see TriangleMesh; the last few are kept, since a scene is set up several times.
std::shared_ptr<const TriangleMesh> shared_mesh(std::span<const double> numbers, double scale);

}  // namespace scree
