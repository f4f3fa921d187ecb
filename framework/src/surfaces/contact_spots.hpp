#pragma once

#include "surfaces/nearest_point.hpp"
#include "surfaces/triangle_mesh.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace scree {

// Most spots in which a body touches one mesh; of more, the nearest count.
constexpr std::size_t most_spots = 8;

// How the triangles of a mesh make spots.
struct SpotRule {
  std::uint32_t side;    // scree_side
  double cosine_smooth;  // of the angle below which two spots are one
};

// The nearest point of a triangle, seen from the centre of a body.
struct SpotCandidate {
  Vec3 point, direction;  // unit, to the centre
  double distance;
  std::uint32_t triangle;
  TrianglePart part;
};

// Where spots are looked for.
struct SpotQuery {
  Vec3 centre;                    // (m) of the body, in the frame of the mesh
  double reach;                   // (m) within which there are spots
  std::size_t most = most_spots;  // as many are found, the nearest
  Vec3 moved = {};                // (m) of the centre since the distances of triangles were measured
  std::uint32_t likely = 0;       // triangle that may be the nearest one
};

// Round-off of distances, relative: triangles whose distance is longer by less are looked at.
constexpr double distance_slack = 1 + 1e-9;

// Finds the spots in which a body may touch a mesh: where the distance from its centre has a local minimum
// over the surface. Of two whose directions from the centre differ by less than an angle, the nearer one
// counts, so that a surface that bends a little from triangle to triangle, or has cracks, is touched once.
// With one side, a centre that is behind the surface has one spot, the nearest, with a distance below 0.
class SpotFinder {
 public:
  // The nearest first. near: all triangles that come nearer than the reach, and others, the nearest first.
  // Valid until the next call.
  const std::vector<NearestPoint>& find(const TriangleMesh& mesh, const SpotRule& rule,
                                        const SpotQuery& query, std::span<const NearTriangle> near);
  // The triangle that is nearest to the centre of the last query; `otherwise` if none is within the reach.
  std::uint32_t nearest_triangle(std::uint32_t otherwise) const {
    return candidates_.empty() ? otherwise : candidates_[0].triangle;
  }

 private:
  std::vector<SpotCandidate> candidates_;
  std::vector<NearestPoint> spots_;
};

// The nearest spot of all.
NearestPoint nearest_spot(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x);

// Most spots that a body may have while it moves among the triangles `near` it, on the side on which its
// centre x is: 1 if they bend by less than the angle of the rule.
std::size_t spots_possible(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x,
                           std::span<const NearTriangle> near);

// How far (m) a centre may move from x so that spots_possible() of any of the triangles `near` it is 1; 0 if
// it may be more.
double smooth_travel(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x,
                     std::span<const NearTriangle> near);

// Where a spot was, in the frame of the surface, and the pair that has it.
struct KeptSpot {
  Vec3 point, normal;
  std::size_t pair;
};

// The former spot of each spot, or -1: the nearest one, if both are seen from x within the angle of the
// rule, or 0.35 rad if that is less.
class SpotMatches {
 public:
  void find(const SpotRule& rule, const Vec3& x, std::span<const NearestPoint> spots,
            std::span<const KeptSpot> former);
  std::size_t size() const { return before_.size(); }
  int operator[](std::size_t spot) const { return before_[spot]; }

 private:
  struct Match {
    double moved;  // (m)
    std::size_t spot, before;
  };
  std::vector<Match> matches_;
  std::vector<int> before_;
};

}  // namespace scree
