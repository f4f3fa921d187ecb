#include "surfaces/triangle_mesh.hpp"

#include "surfaces/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>

namespace scree {

namespace {

// A vertex, and a triangle, for messages.
[[noreturn]] void refuse(const std::string& problem) { throw Error(problem); }

std::vector<Vec3> points_of(std::span<const double> numbers, double scale) {
  const double count = numbers.empty() ? 0 : numbers[0];
  if (!(count >= 3) || count != std::floor(count) || 1 + 3 * count > double(numbers.size()))
    refuse("the mesh has fewer than three points");
  std::vector<Vec3> points(static_cast<std::size_t>(count));
  for (std::size_t p = 0; p < points.size(); ++p)
    for (int k = 0; k < 3; ++k) {
      points[p][k] = scale * numbers[1 + 3 * p + std::size_t(k)];
      if (!std::isfinite(points[p][k])) refuse(fmt::format("point {} of the mesh is not finite", p + 1));
    }
  return points;
}

std::vector<std::array<std::uint32_t, 3>> corners_of(std::span<const double> numbers, std::size_t points) {
  const std::span<const double> all = numbers.subspan(1 + 3 * points);
  if (all.empty() || all.size() % 3 != 0) refuse("the mesh has no triangles");
  std::vector<std::array<std::uint32_t, 3>> corners(all.size() / 3);
  for (std::size_t t = 0; t < corners.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const double number = all[3 * t + k];
      if (!(number >= 0 && number < double(points)) || number != std::floor(number))
        refuse(fmt::format("triangle {} of the mesh has a corner that is none of its points", t + 1));
      corners[t][k] = std::uint32_t(number);
    }
  return corners;
}

Vec3 area_vector(const std::vector<Vec3>& points, const std::array<std::uint32_t, 3>& c) {
  return cross(points[c[1]] - points[c[0]], points[c[2]] - points[c[0]]);
}

// Smallest height of a triangle (m).
double height_of(const std::vector<Vec3>& points, const std::array<std::uint32_t, 3>& c) {
  const double longest = std::max({norm(points[c[1]] - points[c[0]]), norm(points[c[2]] - points[c[1]]),
                                   norm(points[c[0]] - points[c[2]])});
  return norm(area_vector(points, c)) / longest;
}

}  // namespace

TriangleMesh::TriangleMesh(std::span<const double> numbers, double scale) {
  const std::vector<Vec3> points = points_of(numbers, scale);
  bounds_ = Bounds::nowhere();
  for (const Vec3& point : points) bounds_.include(point), reach_ = std::max(reach_, norm(point));
  // Of files with single precision near their origin, and of double precision.
  constexpr double of_files = 4 * double(std::numeric_limits<float>::epsilon()),
                   of_numbers = 4 * std::numeric_limits<double>::epsilon();
  tolerance_ = of_files * norm(bounds_.upper - bounds_.lower) + of_numbers * reach_;
  corners_ = usable(points, corners_of(numbers, points.size()));
  if (corners_.empty()) refuse("no triangle of the mesh has an area");
  const MeshTopology topology(corners_);
  topology.turn_alike(corners_, findings_);
  if (findings_.closed()) turn_outwards(points, topology.shells());
  sort_by_place(points);
  beside_ = MeshTopology(corners_).beside();
  sum_angles(points.size());
}

// Each shell has its outside outside; one within another one is told by its bounds.
void TriangleMesh::turn_outwards(const std::vector<Vec3>& points,
                                 const std::vector<std::uint32_t>& shell_of) {
  std::vector<Bounds> bounds;
  std::vector<double> volume;
  for (std::size_t t = 0; t < corners_.size(); ++t) {
    const std::size_t shell = shell_of[t];
    bounds.resize(std::max(bounds.size(), shell + 1), Bounds::nowhere()), volume.resize(bounds.size(), 0);
    const auto& [a, b, c] = corners_[t];
    for (const std::uint32_t p : corners_[t]) bounds[shell].include(points[p]);
    volume[shell] += dot(points[a] - points[0], cross(points[b] - points[0], points[c] - points[0]));
  }
  for (std::size_t t = 0; t < corners_.size(); ++t)
    if (volume[shell_of[t]] < 0) std::swap(corners_[t][1], corners_[t][2]);
  for (const Bounds& inner : bounds)
    for (const Bounds& outer : bounds)
      findings_.nested = findings_.nested || (&inner != &outer && outer.square_to(inner.lower) == 0 &&
                                              outer.square_to(inner.upper) == 0);
}

// Triangles with an area, each once, by points that are joined.
std::vector<TriangleMesh::Corners> TriangleMesh::usable(const std::vector<Vec3>& points,
                                                        const std::vector<Corners>& all) {
  const std::vector<std::uint32_t> joined = joined_points(points, tolerance_);
  std::set<Corners> known;
  std::vector<Corners> corners;
  for (Corners c : all) {
    for (std::uint32_t& point : c) point = joined[point];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0] || !(height_of(points, c) > tolerance_)) {
      ++findings_.degenerate;
      continue;
    }
    Corners sorted = c;
    std::sort(sorted.begin(), sorted.end());
    known.insert(sorted).second ? corners.push_back(c) : void(++findings_.duplicate);
  }
  return corners;
}

void TriangleMesh::sort_by_place(const std::vector<Vec3>& points) {
  std::vector<Triangle> triangles;
  for (const Corners& of : corners_) triangles.emplace_back(points[of[0]], points[of[1]], points[of[2]]);
  std::vector<std::uint32_t> order;
  triangles_ = TriangleTree(triangles, order);
  const std::vector<Corners> unsorted = std::move(corners_);
  corners_.clear();
  for (const std::uint32_t t : order) corners_.push_back(unsorted[t]);
}

void TriangleMesh::sum_angles(std::size_t points) {
  at_point_.assign(points, Vec3{});
  for (std::size_t t = 0; t < corners_.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Triangle& of = triangles_[t];
      const Vec3 u = of.corner[(k + 1) % 3] - of.corner[k], v = of.corner[(k + 2) % 3] - of.corner[k];
      at_point_[corners_[t][std::size_t(k)]] += std::atan2(norm(cross(u, v)), dot(u, v)) * of.normal;
    }
}

Vec3 TriangleMesh::outwards(std::size_t t, TrianglePart part) const {
  if (part == TrianglePart::face) return triangles_[t].normal;
  if (part >= TrianglePart::corner_0)
    return at_point_[corners_[t][std::size_t(part) - std::size_t(TrianglePart::corner_0)]];
  const std::uint32_t beside = beside_[t][std::size_t(part) - std::size_t(TrianglePart::edge_0)];
  return triangles_[t].normal + (beside == MeshTopology::none ? Vec3{} : triangles_[beside].normal);
}

bool TriangleMesh::at_border(std::size_t t) const {
  return std::find(beside_[t].begin(), beside_[t].end(), MeshTopology::none) != beside_[t].end();
}

namespace {

// Where an edge goes through the inside of a triangle.
std::optional<Vec3> piercing(const Triangle& triangle, const Vec3& from, const Vec3& to) {
  const double before = dot(from - triangle.corner[0], triangle.normal),
               behind = dot(to - triangle.corner[0], triangle.normal);
  if (!(before * behind < 0)) return {};
  const Vec3 point = from + before / (before - behind) * (to - from);
  for (int e = 0; e < 3; ++e) {
    const Vec3 edge = triangle.corner[(e + 1) % 3] - triangle.corner[e];
    if (!(dot(cross(edge, point - triangle.corner[e]), triangle.normal) > 0)) return {};
  }
  return point;
}

}  // namespace

// Where two triangles lie on each other beside their common edge.
std::optional<Vec3> TriangleMesh::fold() const {
  constexpr double nearly_opposite = -1 + 1e-6;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t e = 0; e < 3; ++e)
      if (const std::uint32_t beside = beside_[t][e];
          beside != MeshTopology::none &&
          dot(triangles_[t].normal, triangles_[beside].normal) < nearly_opposite)
        return triangles_[t].corner[e];
  return {};
}

std::optional<Vec3> TriangleMesh::crossing() const {
  std::vector<std::uint32_t> along;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (int e = 0; e < 3; ++e) {
      const Vec3 &from = triangles_[t].corner[e], &to = triangles_[t].corner[(e + 1) % 3];
      triangles_.find_along(from, to, along);
      for (const std::uint32_t n : along) {
        const Corners& other = corners_[n];
        const auto has = [&](std::uint32_t point) {
          return std::find(other.begin(), other.end(), point) != other.end();
        };
        if (has(corners_[t][0]) || has(corners_[t][1]) || has(corners_[t][2])) continue;
        if (const auto point = piercing(triangles_[n], from, to)) return point;
      }
    }
  return {};
}

std::string MeshFindings::text() const {
  std::string all;
  const auto add = [&](std::size_t count, const char* one, const char* what) {
    if (count > 0) all += fmt::format("{}{} of {}", all.empty() ? "" : ", ", counted(count, one), what);
  };
  add(open_edges, "edge", "one triangle");
  add(shared_edges, "edge", "three triangles or more");
  if (one_sided) all += fmt::format("{}no inside and outside", all.empty() ? "" : ", ");
  add(degenerate, "triangle", "no area, left out");
  add(duplicate, "triangle", "the same corners as another, left out");
  add(turned, "triangle", "the other sense than those beside it, turned");
  return all;
}

std::shared_ptr<const TriangleMesh> shared_mesh(std::span<const double> numbers, double scale) {
  struct Kept {
    std::vector<double> numbers;
    double scale = 0;
    std::shared_ptr<const TriangleMesh> mesh;
  };
  static std::mutex mutex;
  static std::vector<Kept> kept;
  constexpr std::size_t most_kept = 8;
  const std::lock_guard lock(mutex);
  for (const Kept& k : kept)
    if (k.scale == scale && std::ranges::equal(k.numbers, numbers)) return k.mesh;
  if (kept.size() == most_kept) kept.erase(kept.begin());
  kept.push_back({{numbers.begin(), numbers.end()}, scale, std::make_shared<TriangleMesh>(numbers, scale)});
  return kept.back().mesh;
}

}  // namespace scree
