#include "surfaces/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace scree {

namespace {

struct EdgeOfTriangle {
  std::uint32_t low, high, triangle;
  int edge;
};

// Whether an edge runs from the lower to the higher point.
bool runs_up(const MeshTopology::Corners& c, int e) {
  return c[std::size_t(e)] < c[std::size_t((e + 1) % 3)];
}

}  // namespace

MeshTopology::MeshTopology(const std::vector<Corners>& corners)
    : beside_(corners.size(), {none, none, none}) {
  std::vector<EdgeOfTriangle> edges;
  for (std::uint32_t t = 0; t < corners.size(); ++t)
    for (int e = 0; e < 3; ++e) {
      const auto [low, high] = std::minmax(corners[t][std::size_t(e)], corners[t][std::size_t((e + 1) % 3)]);
      edges.push_back({low, high, t, e});
    }
  std::sort(edges.begin(), edges.end(), [](const EdgeOfTriangle& a, const EdgeOfTriangle& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t end = k + 1;
    while (end < edges.size() && edges[end].low == edges[k].low && edges[end].high == edges[k].high) ++end;
    open_edges_ += end == k + 1;
    shared_edges_ += end > k + 2;
    if (end == k + 2) {
      beside_[edges[k].triangle][std::size_t(edges[k].edge)] = edges[k + 1].triangle;
      beside_[edges[k + 1].triangle][std::size_t(edges[k + 1].edge)] = edges[k].triangle;
    }
    k = end;
  }
}

template <class Begin, class Meet>
void MeshTopology::walk(const Begin& begin, const Meet& meet) const {
  std::vector<bool> seen(beside_.size(), false);
  std::vector<std::uint32_t> next;
  for (std::uint32_t first = 0; first < beside_.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    begin(first);
    for (next.push_back(first); !next.empty();) {
      const std::uint32_t t = next.back();
      next.pop_back();
      for (int e = 0; e < 3; ++e) {
        const std::uint32_t other = beside_[t][std::size_t(e)];
        if (other == none) continue;
        meet(t, e, other, !seen[other]);
        if (!seen[other]) seen[other] = true, next.push_back(other);
      }
    }
  }
}

std::vector<std::uint32_t> MeshTopology::shells() const {
  std::vector<std::uint32_t> shell(beside_.size(), none);
  std::uint32_t count = 0;
  walk([&](std::uint32_t first) { shell[first] = count++; },
       [&](std::uint32_t t, int, std::uint32_t other, bool) { shell[other] = shell[t]; });
  return shell;
}

void MeshTopology::turn_alike(std::vector<Corners>& corners, MeshFindings& findings) const {
  std::vector<bool> turned(corners.size(), false);
  const auto edge_to = [&](std::uint32_t t, std::uint32_t other) {
    return int(std::find(beside_[t].begin(), beside_[t].end(), other) - beside_[t].begin());
  };
  walk([](std::uint32_t) {},
       [&](std::uint32_t t, int e, std::uint32_t other, bool is_new) {
         // Two triangles that are alike run along their edge in opposite directions.
         const bool alike = runs_up(corners[t], e) != runs_up(corners[other], edge_to(other, t));
         const bool wanted = turned[t] == alike;
         if (is_new)
           turned[other] = wanted;
         else if (turned[other] != wanted)
           findings.one_sided = true;
       });
  for (std::size_t t = 0; t < corners.size(); ++t)
    if (turned[t]) std::swap(corners[t][1], corners[t][2]), ++findings.turned;
  findings.open_edges = open_edges_;
  findings.shared_edges = shared_edges_;
}

namespace {

using Cell = std::array<std::int64_t, 3>;
struct HashOfCell {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t k : cell)
      hash = (hash ^ std::uint64_t(k)) * 0x9E3779B97F4A7C15u, hash ^= hash >> 29;
    return std::size_t(hash);
  }
};

}  // namespace

std::vector<std::uint32_t> joined_points(const std::vector<Vec3>& points, double distance) {
  const double width = 4 * distance;
  const auto cell_of = [&](const Vec3& x, const Vec3& shift) {
    Cell cell;
    for (int k = 0; k < 3; ++k) cell[std::size_t(k)] = std::int64_t(std::floor((x[k] + shift[k]) / width));
    return cell;
  };
  std::unordered_map<Cell, std::vector<std::uint32_t>, HashOfCell> cells;
  std::vector<std::uint32_t> joined(points.size());
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    std::uint32_t first = p;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 shift = {{corner & 1 ? distance : -distance, corner & 2 ? distance : -distance,
                           corner & 4 ? distance : -distance}};
      const auto found = cells.find(cell_of(points[p], shift));
      if (found == cells.end()) continue;
      for (const std::uint32_t other : found->second)
        if (norm(points[other] - points[p]) <= distance) first = std::min(first, other);
    }
    joined[p] = first;
    if (first == p) cells[cell_of(points[p], {})].push_back(p);
  }
  return joined;
}

}  // namespace scree
