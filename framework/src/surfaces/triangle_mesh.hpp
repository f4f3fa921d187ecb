#pragma once

#include "surfaces/triangle_tree.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
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

// A triangulated surface in its own frame.
class TriangleMesh {
 public:
  // numbers: as of a parameter of the type SCREE_MESH_FILE; lengths are multiplied by `scale`. Throws Error
  // without a cure if they are no mesh: "the mesh has no triangles".
  TriangleMesh(std::span<const double> numbers, double scale);

  // A point in which two triangles without a common corner cross, and one where the mesh folds back on
  // itself; none if there is none.
  std::optional<Vec3> crossing() const;
  std::optional<Vec3> fold() const;

  const TriangleTree& triangles() const { return triangles_; }
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
  void turn_outwards(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& shell_of);
  std::vector<Corners> usable(const std::vector<Vec3>& points, const std::vector<Corners>& all);
  void sum_angles(std::size_t points);
  void sort_by_place(const std::vector<Vec3>& points);

  TriangleTree triangles_;
  std::vector<Corners> corners_, beside_;  // of each triangle, see MeshTopology
  std::vector<Vec3> at_point_;             // normals by their angles
  Bounds bounds_ = {};
  double tolerance_ = 0, reach_ = 0;
  MeshFindings findings_;
};

// A mesh of these numbers, see TriangleMesh; the last few are kept, since a scene is set up several times.
std::shared_ptr<const TriangleMesh> shared_mesh(std::span<const double> numbers, double scale);

}  // namespace scree
