#include "surfaces/contact_spots.hpp"

#include "meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

// Spots of meshes against a search through all faces, edges and corners, which shares no code with them.

using namespace scree;
using namespace scree::test;

namespace {

struct Minimum {
  Vec3 point;
  double distance;
};

using Key = std::tuple<double, double, double>;
// Faces of a box have corners that differ by round-off.
Key key_of(const Vec3& p) {
  const auto rounded = [](double x) { return 1e-9 * std::round(1e9 * x); };
  return {rounded(p[0]), rounded(p[1]), rounded(p[2])};
}

// All local minima of the distance from x, by what is nearest: a face over which x lies, an edge in the
// plane through x across it whose faces fall away on both sides, a corner whose edges all lead away. By
// bodies of more than one triangle; corners that have the same coordinates are one.
std::vector<Minimum> all_minima(const Mesh& mesh, const Vec3& x) {
  std::vector<Minimum> minima;
  std::map<Key, Vec3> place;
  std::map<Key, std::vector<Vec3>> edges_from;                         // edges from each corner
  std::map<std::pair<Key, Key>, std::vector<std::array<Vec3, 3>>> at;  // triangles at each edge, it first
  for (const auto& triangle : mesh.triangles) {
    const Vec3 c[3] = {mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]};
    const Vec3 u = c[1] - c[0], v = c[2] - c[0], w = x - c[0];
    // x − c₀ = s u + t v + height.
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
    const double determinant = uu * vv - uv * uv;
    const double s = (wu * vv - wv * uv) / determinant, t = (wv * uu - wu * uv) / determinant;
    if (s > 0 && t > 0 && s + t < 1) {
      const Vec3 foot = c[0] + s * u + t * v;
      minima.push_back({foot, norm(x - foot)});
    }
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = c[k], &q = c[(k + 1) % 3], &r = c[(k + 2) % 3];
      place[key_of(p)] = p;
      edges_from[key_of(p)].push_back(q - p), edges_from[key_of(p)].push_back(r - p);
      key_of(p) < key_of(q) ? at[{key_of(p), key_of(q)}].push_back({p, q, r})
                            : at[{key_of(q), key_of(p)}].push_back({q, p, r});
    }
  }
  for (const auto& [ends, triangles] : at) {
    const Vec3 p = triangles[0][0], along = triangles[0][1] - p;
    const double share = dot(x - p, along) / dot(along, along);
    const Vec3 foot = p + share * along;
    const bool falls = std::all_of(triangles.begin(), triangles.end(),
                                   [&](const auto& of) { return dot(x - foot, of[2] - foot) <= 0; });
    if (share > 0 && share < 1 && falls) minima.push_back({foot, norm(x - foot)});
  }
  for (const auto& [corner, edges] : edges_from) {
    const Vec3 p = place.at(corner);
    if (std::all_of(edges.begin(), edges.end(), [&](const Vec3& edge) { return dot(x - p, edge) <= 0; }))
      minima.push_back({p, norm(x - p)});
  }
  return minima;
}

// Those within the radius; of two in nearly the same direction the nearer.
std::vector<Minimum> reference(const Mesh& mesh, const Vec3& x, double radius, double angle) {
  std::vector<Minimum> minima = all_minima(mesh, x), kept;
  std::sort(minima.begin(), minima.end(),
            [](const Minimum& a, const Minimum& b) { return a.distance < b.distance; });
  for (const Minimum& m : minima) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Minimum& k) {
      const Vec3 a = x - m.point, b = x - k.point;
      return std::acos(std::clamp(dot(a, b) / (norm(a) * norm(b)), -1.0, 1.0)) < angle;
    });
    if (m.distance < radius && !known && kept.size() < most_spots) kept.push_back(m);
  }
  return kept;
}

std::vector<NearestPoint> spots_of(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x,
                                   double radius) {
  std::vector<NearTriangle> near;
  mesh.triangles().find_near(x, radius, near);
  SpotFinder finder;
  return finder.find(mesh, rule, {x, radius}, near);
}

SpotRule both_sides(double angle) { return {SCREE_BOTH_SIDES, std::cos(angle)}; }

}  // namespace

// Random hills from gentle to jagged, boxes and spheres, with small and large bodies, from deep overlaps
// to none. Where a spot is: round-off of 1 m over slivers of 1e-3. A few cases in a million lie on the
// limit of a rule by chance; in none here.
TEST_CASE("spots of a mesh are those of all faces, edges and corners", "[surfaces]") {
  std::mt19937_64 random(45);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::size_t compared = 0, several = 0, edges = 0;
  for (int n = 0; n < 1000; ++n) {
    const double rough = std::pow(10, -3 + 3 * uniform(random));
    const Mesh mesh = n % 5 == 0   ? box_mesh({{0.3 + uniform(random), 0.5, 0.4}}, 1 + std::size_t(n % 3))
                      : n % 5 == 1 ? sphere_mesh(0.8, 1 + std::size_t(n % 7))
                                   : hills_mesh(1, 2 + std::size_t(n % 6), rough, random);
    const TriangleMesh tree((n % 2 ? mesh : mesh.apart()).numbers(), 1);
    const double angle = n % 3 == 0 ? 0.0 : 0.7 * uniform(random);
    for (int k = 0; k < 20; ++k) {
      const Vec3 x = {
          {2.4 * uniform(random) - 1.2, 2.4 * uniform(random) - 1.2, 1.6 * uniform(random) - 0.8}};
      const double radius = 0.05 + 0.6 * uniform(random);
      const std::vector<Minimum> expected = reference(mesh, x, radius, angle);
      const std::vector<NearestPoint> found = spots_of(tree, both_sides(angle), x, radius);
      INFO("mesh " << n << ", body " << k << ", angle " << angle << ", radius " << radius);
      REQUIRE(found.size() == expected.size());
      for (std::size_t s = 0; s < found.size(); ++s) {
        CHECK(norm(found[s].point - expected[s].point) < 1e-11);
        CHECK(norm(x - found[s].point - found[s].distance * found[s].normal) < 1e-11);
      }
      ++compared, several += found.size() > 1;
      edges += !expected.empty() && expected.size() < all_minima(mesh, x).size();
    }
  }
  CHECK(compared == 20000);
  CHECK(several > 500);
  CHECK(edges > 1000);
}

TEST_CASE("the nearest triangles are found by the tree as by looking at all", "[surfaces]") {
  std::mt19937_64 random(46);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  const TriangleMesh mesh(hills_mesh(1, 20, 0.8, random).numbers(), 1);
  std::vector<NearTriangle> near;
  for (int k = 0; k < 300; ++k) {
    const Vec3 x = {{uniform(random), uniform(random), uniform(random)}};
    std::size_t within = 0;
    double nearest = 10;
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
      const double distance = norm(x - nearest_on(mesh.triangles()[t], x).point);
      within += distance <= 0.4, nearest = std::min(nearest, distance);
    }
    mesh.triangles().find_near(x, 0.4, near);
    CHECK(near.size() == within);
    CHECK(mesh.triangles().nearest(x).distance == nearest);
  }
}

TEST_CASE("a body has as many spots as may be, or fewer", "[surfaces]") {
  std::mt19937_64 random(47);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<NearTriangle> near;
  std::size_t single = 0;
  for (int n = 0; n < 300; ++n) {
    const Mesh mesh =
        n % 2 ? hills_mesh(1, 8, 0.3 * uniform(random), random) : box_mesh({{0.8, 0.8, 0.8}}, 3);
    const TriangleMesh tree(mesh.numbers(), 1);
    const double radius = 0.05 + 0.3 * uniform(random), skin = 0.2 * radius;
    const Vec3 x = {{uniform(random), uniform(random), n % 2 ? 0.8 * radius : uniform(random)}};
    tree.triangles().find_near(x, radius + skin, near);
    const std::size_t possible = spots_possible(tree, both_sides(0.35), x, near);
    single += possible == 1;
    for (int k = 0; k < 20; ++k) {
      Vec3 moved = {{uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5}};
      moved = 0.99 * skin * uniform(random) / norm(moved) * moved;
      CHECK(spots_of(tree, both_sides(0.35), x + moved, radius).size() <= possible);
    }
  }
  CHECK(single > 50);
}

// The nearest spot alone is found in another way than all. Where a body was may be on a triangle, whose
// direction is not known there.
TEST_CASE("triangles near the place where a body was give the spots where it is", "[surfaces]") {
  std::mt19937_64 random(49);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<NearTriangle> near, near_now;
  SpotFinder finder, finder_now;
  std::size_t single = 0, none = 0, several = 0;
  for (int n = 0; n < 400; ++n) {
    const Mesh hills = hills_mesh(1, 10, 0.5 * std::abs(uniform(random)), random);
    const TriangleMesh mesh((n % 3 ? hills : box_mesh({{0.7, 0.8, 0.9}}, 4)).numbers(), 1);
    for (int k = 0; k < 20; ++k) {
      const double radius = 0.1 + 0.2 * std::abs(uniform(random)), margin = 0.1 * radius;
      Vec3 x = {{uniform(random), uniform(random), n % 3 ? 0.3 * uniform(random) : uniform(random)}};
      if (k % 4 == 0) x = nearest_spot(mesh, both_sides(0.35), x).point;
      const Vec3 way = {{uniform(random), uniform(random), uniform(random)}};
      const Vec3 moved = margin * std::abs(uniform(random)) / norm(way) * way, now = x + moved;
      mesh.triangles().find_near(x, radius + margin, near);
      mesh.triangles().find_near(now, radius, near_now);
      for (const std::size_t most : {std::size_t(1), most_spots}) {
        const auto& spots = finder.find(mesh, both_sides(0.35), {now, radius, most, moved}, near);
        const auto& expected = finder_now.find(mesh, both_sides(0.35), {now, radius, most_spots}, near_now);
        REQUIRE(spots.size() == std::min(most, expected.size()));
        for (std::size_t i = 0; i < spots.size(); ++i) {
          CHECK(spots[i].point == expected[i].point);
          CHECK(spots[i].distance == expected[i].distance);
        }
        none += spots.empty(), single += spots.size() == 1, several += spots.size() > 1;
      }
    }
  }
  CHECK(none > 500);
  CHECK(single > 500);
  CHECK(several > 500);
}

TEST_CASE("where a mesh is smooth a body that moves a little has one spot", "[surfaces]") {
  std::mt19937_64 random(50);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<NearTriangle> near, some;
  std::size_t smooth = 0, rough = 0;
  for (int n = 0; n < 400; ++n) {
    const TriangleMesh mesh(hills_mesh(1, 10, 0.1 * std::abs(uniform(random)), random).numbers(), 1);
    const double reach = 0.4 * std::abs(uniform(random));
    const Vec3 x = {{0.7 * uniform(random), 0.7 * uniform(random), 0.5 * reach * uniform(random)}};
    mesh.triangles().find_near(x, reach, near);
    const double travel = smooth_travel(mesh, both_sides(0.35), x, near);
    if (near.empty()) continue;
    const bool one = spots_possible(mesh, both_sides(0.35), x, near) == 1;
    CHECK((one || !(travel > 0)));
    travel > 0 ? ++smooth : ++rough;
    for (int k = 0; k < 20 && travel > 0; ++k) {
      const Vec3 way = {{uniform(random), uniform(random), uniform(random)}};
      const double moved = std::min(travel, reach) * std::abs(uniform(random));
      mesh.triangles().find_near(x + moved / norm(way) * way, (reach - moved) * std::abs(uniform(random)),
                                 some);
      CHECK(spots_possible(mesh, both_sides(0.35), x + moved / norm(way) * way, some) ==
            std::min<std::size_t>(some.size(), 1));
    }
  }
  CHECK(smooth > 100);
  CHECK(rough > 50);
}

TEST_CASE("a closed mesh has an outside and an inside", "[surfaces]") {
  std::mt19937_64 random(48);
  std::uniform_real_distribution<double> uniform(-1.2, 1.2);
  const Vec3 half = {{0.9, 0.6, 0.4}};
  const TriangleMesh mesh(box_mesh(half, 2).apart().numbers(), 1);
  REQUIRE(mesh.findings().closed());
  CHECK(mesh.findings().text().empty());
  int inside = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 x = {{uniform(random), uniform(random), uniform(random)}};
    const bool within = std::abs(x[0]) < half[0] && std::abs(x[1]) < half[1] && std::abs(x[2]) < half[2];
    const double outside = nearest_spot(mesh, {SCREE_OUTSIDE, 0.94}, x).distance;
    CHECK((outside < 0) == within);
    CHECK(nearest_spot(mesh, {SCREE_INSIDE, 0.94}, x).distance == -outside);
    CHECK(nearest_spot(mesh, {SCREE_BOTH_SIDES, 0.94}, x).distance == std::abs(outside));
    inside += within;
  }
  CHECK(inside > 100);
}

TEST_CASE("faults of a mesh are counted, and repaired where that is safe", "[surfaces]") {
  Mesh mesh = box_mesh({{1, 1, 1}});
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  mesh.triangles.push_back(mesh.triangles[5]);
  mesh.triangles.push_back({0, 1, 1});
  mesh.points.push_back({{-1 + 1e-8, -1, -1}});
  const TriangleMesh repaired(mesh.numbers(), 1);
  CHECK(repaired.triangles().size() == 12);
  CHECK(repaired.findings().text() ==
        "1 triangle of no area, left out, 1 triangle of the same corners as another, left out, 1 triangle of "
        "the other sense than those beside it, turned");
  CHECK(nearest_spot(repaired, {SCREE_OUTSIDE, 0.94}, {{0, 0, 1.5}}).distance == 0.5);
  mesh = box_mesh({{1, 1, 1}});
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  CHECK(nearest_spot(TriangleMesh(mesh.numbers(), 1), {SCREE_OUTSIDE, 0.94}, {{0, 0, 1.5}}).distance == 0.5);
  mesh = box_mesh({{1, 1, 1}});
  mesh.triangles.pop_back();
  CHECK(TriangleMesh(mesh.numbers(), 1).findings().open_edges == 3);
  CHECK_FALSE(TriangleMesh(mesh.numbers(), 1).findings().closed());
  CHECK_FALSE(TriangleMesh(mesh.numbers(), 1).crossing());
  Mesh crossed = box_mesh({{1, 1, 1}});
  for (const Vec3& p : box_mesh({{0.5, 0.5, 0.5}}).points) crossed.points.push_back(p + Vec3{{1, 0.1, 0.2}});
  for (const auto& t : box_mesh({{0.5, 0.5, 0.5}}).triangles) crossed.add(t[0] + 24, t[1] + 24, t[2] + 24);
  const TriangleMesh two(crossed.numbers(), 1);
  CHECK(two.findings().closed());
  CHECK_FALSE(two.findings().nested);
  CHECK_FALSE(two.fold());
  REQUIRE(two.crossing());
  CHECK(std::abs((*two.crossing())[0] - 1) < 1e-12);
  // Three shells, of which one is turned and one within another.
  Mesh shells = box_mesh({{1, 1, 1}});
  for (const double size : {0.5, 0.2}) {
    const std::size_t first = shells.points.size();
    for (const Vec3& p : box_mesh({{size, size, size}}).points)
      shells.points.push_back(p + Vec3{{size > 0.3 ? 3.0 : 0.0, 0, 0}});
    for (const auto& t : box_mesh({{size, size, size}}).triangles)
      shells.add(t[1] + first, t[0] + first, t[2] + first);
    const TriangleMesh both(shells.numbers(), 1);
    CHECK(both.findings().nested == (size < 0.3));
    CHECK(nearest_spot(both, {SCREE_OUTSIDE, 0.94}, {{3, 0, 0}}).distance == -0.5);
  }
  const TriangleMesh fold(
      Mesh{{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0.2, 0.5, 0}}}, {{0, 1, 2}, {1, 0, 3}}}.numbers(), 1);
  CHECK(fold.fold());
  const auto problem = [](std::vector<double> numbers) {
    try {
      TriangleMesh(numbers, 1);
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(problem({}) == "the mesh has fewer than three points");
  CHECK(problem({3, 0, 0, 0, 1, 0, 0, 0, 1, 0}) == "the mesh has no triangles");
  CHECK(problem({3, 0, 0, 0, 1, 0, 0, 0, NAN, 0, 0, 1, 2}) == "point 3 of the mesh is not finite");
  CHECK(problem({3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 3}) ==
        "triangle 1 of the mesh has a corner that is none of its points");
  CHECK(problem({3, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 2}) == "no triangle of the mesh has an area");
}
