#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include <scree/plugin/vec.hpp>

// Triangulated surfaces for tests.

namespace scree::test {

struct Mesh {
  std::vector<Vec3> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  void add(std::size_t a, std::size_t b, std::size_t c) { triangles.push_back({a, b, c}); }
  // Four corners, anticlockwise as seen from outside.
  void add(const std::array<std::size_t, 4>& corners) {
    add(corners[0], corners[1], corners[2]);
    add(corners[0], corners[2], corners[3]);
  }
  // Each triangle with points of its own, as STL files have them.
  Mesh apart() const {
    Mesh all;
    for (const auto& triangle : triangles) {
      for (const std::size_t p : triangle) all.points.push_back(points[p]);
      all.add(all.points.size() - 3, all.points.size() - 2, all.points.size() - 1);
    }
    return all;
  }
  // As a parameter of the type SCREE_MESH_FILE.
  std::vector<double> numbers() const {
    std::vector<double> all = {double(points.size())};
    for (const Vec3& p : points) all.insert(all.end(), p.component, p.component + 3);
    for (const auto& triangle : triangles)
      for (const std::size_t p : triangle) all.push_back(double(p));
    return all;
  }
};

// In the plane z = 0, [-half, half] squared, as a grid of n × m squares; `offset` moves the points of its
// inner lines along the lines, in cells.
inline Mesh flat_mesh(double half, std::size_t n, std::size_t m, double offset = 0) {
  Mesh mesh;
  for (std::size_t j = 0; j <= m; ++j)
    for (std::size_t i = 0; i <= n; ++i) {
      const double shift = i > 0 && i < n && j % 2 == 1 ? offset : 0;
      mesh.points.push_back(
          {{half * (2 * (double(i) + shift) / double(n) - 1), half * (2 * double(j) / double(m) - 1), 0}});
    }
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t first = j * (n + 1) + i;
      mesh.add({first, first + 1, first + n + 2, first + n + 1});
    }
  return mesh;
}

// A box about the origin with these half lengths, each face a grid of n × n squares.
inline Mesh box_mesh(const Vec3& half, std::size_t n = 1) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const std::size_t first = mesh.points.size();
      for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i) {
          Vec3 p = {};
          p[axis] = sign * half[axis];
          p[u] = sign * half[u] * (2 * double(i) / double(n) - 1);
          p[v] = half[v] * (2 * double(j) / double(n) - 1);
          mesh.points.push_back(p);
        }
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
          const std::size_t corner = first + j * (n + 1) + i;
          mesh.add({corner, corner + 1, corner + n + 2, corner + n + 1});
        }
    }
  return mesh;
}

// A cylinder about z, open at both ends: n segments around, m along. Corners lie on the cylinder.
inline Mesh cylinder_mesh(double radius, double half_length, std::size_t n, std::size_t m, double turn = 0) {
  Mesh mesh;
  for (std::size_t j = 0; j <= m; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = turn + 2 * std::numbers::pi * double(i) / double(n);
      mesh.points.push_back({{radius * std::cos(angle), radius * std::sin(angle),
                              half_length * (2 * double(j) / double(m) - 1)}});
    }
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < n; ++i)
      mesh.add({j * n + i, j * n + (i + 1) % n, (j + 1) * n + (i + 1) % n, (j + 1) * n + i});
  return mesh;
}

// With x, y, z as x, −z, y.
inline Mesh lying(Mesh mesh) {
  for (Vec3& p : mesh.points) p = {{p[0], -p[2], p[1]}};
  return mesh;
}

// A cone about z, from a point at the origin to a radius at a height: n segments around, m along.
inline Mesh cone_mesh(double radius, double height, std::size_t n, std::size_t m, double turn = 0) {
  Mesh mesh = cylinder_mesh(1, 0.5, n, m, turn);
  for (Vec3& p : mesh.points) {
    const double share = p[2] + 0.5;
    p = {{share * radius * p[0], share * radius * p[1], share * height}};
  }
  return mesh;
}

// A sphere about the origin: an octahedron whose triangles are divided in n × n, turned about z.
inline Mesh sphere_mesh(double radius, std::size_t n, double turn = 0) {
  Mesh mesh;
  for (const double z : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double x : {-1.0, 1.0}) {
        const Vec3 ends[3] = {{{x, 0, 0}}, {{0, y, 0}}, {{0, 0, z}}};
        const auto point = [&](std::size_t i, std::size_t j) {
          const Vec3 p = ends[0] + double(i) / double(n) * (ends[1] - ends[0]) +
                         double(j) / double(n) * (ends[2] - ends[0]);
          const Vec3 on = radius / norm(p) * p;
          const double c = std::cos(turn), s = std::sin(turn);
          return Vec3{{c * on[0] - s * on[1], s * on[0] + c * on[1], on[2]}};
        };
        const bool turned = x * y * z < 0;
        const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
          for (const Vec3& p : {a, turned ? c : b, turned ? b : c}) mesh.points.push_back(p);
          mesh.add(mesh.points.size() - 3, mesh.points.size() - 2, mesh.points.size() - 1);
        };
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t j = 0; i + j < n; ++j) {
            add(point(i, j), point(i + 1, j), point(i, j + 1));
            if (i + j + 1 < n) add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
          }
      }
  return mesh;
}

// Heights over a grid of n × n squares that are random up to `rough` of their width.
inline Mesh hills_mesh(double half, std::size_t n, double rough, std::mt19937_64& random) {
  Mesh mesh = flat_mesh(half, n, n);
  std::uniform_real_distribution<double> height(-1, 1);
  for (Vec3& p : mesh.points) p[2] = rough * 2 * half / double(n) * height(random);
  return mesh;
}

}  // namespace scree::test
