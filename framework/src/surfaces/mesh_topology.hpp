#pragma once

#include "surfaces/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace scree {

// Which triangles meet at the edges of a mesh.
class MeshTopology {
 public:
  using Corners = std::array<std::uint32_t, 3>;  // numbers of points

  explicit MeshTopology(const std::vector<Corners>& corners);

  static constexpr std::uint32_t none = ~std::uint32_t(0);
  // Of each triangle, the one other triangle at each of its edges, or none.
  const std::vector<Corners>& beside() const { return beside_; }
  // Of each triangle, the number of the part of the mesh that it is joined to.
  std::vector<std::uint32_t> shells() const;
  // Counts edges, and turns triangles like the first one that they are joined to.
  void turn_alike(std::vector<Corners>& corners, MeshFindings& findings) const;

 private:
  // Visits all triangles from edge to edge: begin(t) for the first one of each part, then
  // meet(t, edge, other, is_new) for each pair of neighbours, from both.
  template <class Begin, class Meet>
  void walk(const Begin& begin, const Meet& meet) const;

  std::vector<Corners> beside_;
  std::size_t open_edges_ = 0, shared_edges_ = 0;
};

// Of each point, the first one that lies within a distance (m) of it, which may be itself.
std::vector<std::uint32_t> joined_points(const std::vector<Vec3>& points, double distance);

}  // namespace scree
