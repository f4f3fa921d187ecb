#include "surfaces/contact_spots.hpp"

#include "machine/instruction_levels.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace scree {

namespace {

SpotCandidate candidate_on(const TriangleTree& triangles, std::uint32_t t, const Vec3& x) {
  const Triangle& triangle = triangles[t];
  const PointOnTriangle nearest = nearest_on(triangle, x);
  if (nearest.part == TrianglePart::face) {
    const double height = dot(x - triangle.corner[0], triangle.normal);
    return {nearest.point, height < 0 ? -triangle.normal : triangle.normal, std::abs(height), t,
            nearest.part};
  }
  const Vec3 away = x - nearest.point;
  const double distance = norm(away);
  return {nearest.point, distance > 0 ? 1 / distance * away : triangle.normal, distance, t, nearest.part};
}

// Largest lower bound of the distance (m) with which a triangle may come as near as another one: bounds have
// round-off, and those without a direction may be too large by more.
double largest_bound(double distance, const SpotQuery& query) {
  return distance + 2 * TriangleTree::hidden * query.reach;
}

bool is_nearer(const SpotCandidate& a, const SpotCandidate& b) {
  return std::tie(a.distance, a.triangle) < std::tie(b.distance, b.triangle);
}

// Of all triangles within the reach.
SCREE_EVERY_LEVEL_INLINED void find_candidates(const TriangleTree& triangles, const SpotQuery& query,
                                               std::span<const NearTriangle> near,
                                               std::vector<SpotCandidate>& candidates) {
  for (const NearTriangle& triangle : near) {
    if (triangle.least_distance(query.moved) > largest_bound(query.reach, query)) continue;
    const SpotCandidate c = candidate_on(triangles, triangle.triangle, query.centre);
    if (c.distance < query.reach) candidates.push_back(c);
  }
  std::sort(candidates.begin(), candidates.end(), is_nearer);
}

// The nearest one alone: mostly the likely one, which few others can come as near as.
SCREE_EVERY_LEVEL_INLINED void find_nearest_candidate(const TriangleTree& triangles, const SpotQuery& query,
                                                      std::span<const NearTriangle> near,
                                                      std::vector<SpotCandidate>& candidates) {
  if (near.empty()) return;
  SpotCandidate nearest = candidate_on(triangles, query.likely, query.centre);
  double most = largest_bound(std::min(nearest.distance, query.reach), query);
  for (const NearTriangle& n : near) {
    if (n.least_distance(query.moved) > most || n.triangle == query.likely) continue;
    const SpotCandidate c = candidate_on(triangles, n.triangle, query.centre);
    if (is_nearer(c, nearest)) nearest = c, most = largest_bound(std::min(c.distance, query.reach), query);
  }
  if (nearest.distance < query.reach) candidates.push_back(nearest);
}

// Whether the distance from x is smaller elsewhere on a triangle that has the point of a candidate. Earlier
// candidates are nearer; faces are never passed.
bool is_passed(const TriangleMesh& mesh, std::span<const SpotCandidate> earlier, const SpotCandidate& c) {
  if (c.part == TrianglePart::face) return false;
  return std::any_of(earlier.begin(), earlier.end(), [&](const SpotCandidate& nearer) {
    const Vec3 apart = c.point - nearest_on(mesh.triangles()[nearer.triangle], c.point).point;
    return nearer.distance < c.distance && norm(apart) <= mesh.tolerance();
  });
}

bool is_in_front(const TriangleMesh& mesh, const SpotCandidate& c) {
  return dot(c.direction, mesh.outwards(c.triangle, c.part)) >= 0;
}

// Whether bodies may be on the side on which x is.
bool is_allowed(const TriangleMesh& mesh, const SpotRule& rule, const SpotCandidate& c) {
  return rule.side == SCREE_BOTH_SIDES || is_in_front(mesh, c) == (rule.side == SCREE_OUTSIDE);
}

NearestPoint in_front(const SpotCandidate& c) { return {c.point, c.direction, c.distance, {}}; }
NearestPoint behind(const SpotCandidate& c) { return {c.point, -c.direction, -c.distance, {}}; }

}  // namespace

const std::vector<NearestPoint>& SpotFinder::find(const TriangleMesh& mesh, const SpotRule& rule,
                                                  const SpotQuery& query,
                                                  std::span<const NearTriangle> near) {
  spots_.clear();
  candidates_.clear();
  if (query.most == 1)
    find_nearest_candidate(mesh.triangles(), query, near, candidates_);
  else
    find_candidates(mesh.triangles(), query, near, candidates_);
  if (!candidates_.empty() && !is_allowed(mesh, rule, candidates_[0])) {
    spots_.push_back(behind(candidates_[0]));
    return spots_;
  }
  for (std::size_t k = 0; k < candidates_.size() && spots_.size() < query.most; ++k) {
    const SpotCandidate& c = candidates_[k];
    const bool known = std::any_of(spots_.begin(), spots_.end(), [&](const NearestPoint& spot) {
      return dot(spot.normal, c.direction) > rule.cosine_smooth ||
             norm(spot.point - c.point) <= mesh.tolerance();
    });
    if (!known && is_allowed(mesh, rule, c) && !is_passed(mesh, std::span(candidates_).first(k), c))
      spots_.push_back(in_front(c));
  }
  return spots_;
}

NearestPoint nearest_spot(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x) {
  const SpotCandidate c = candidate_on(mesh.triangles(), mesh.triangles().nearest(x).triangle, x);
  return is_allowed(mesh, rule, c) ? in_front(c) : behind(c);
}

namespace {

double cosine_of_half(double cosine) { return std::sqrt(0.5 * (1 + cosine)); }

// Height (m) of x over the plane of a triangle, above 0 at its outside.
double height_over(const Triangle& triangle, const Vec3& x) {
  return dot(x - triangle.corner[0], triangle.normal);
}

// Whether the directions from triangles to x are within an angle of their sum, and none is at a border.
bool is_smooth(const TriangleMesh& mesh, double cosine, const Vec3& x, std::span<const NearTriangle> near) {
  const auto towards = [&](const NearTriangle& n) {
    const Triangle& triangle = mesh.triangles()[n.triangle];
    return height_over(triangle, x) < 0 ? -triangle.normal : triangle.normal;
  };
  Vec3 sum = {};
  for (const NearTriangle& n : near) {
    if (mesh.at_border(n.triangle)) return false;
    sum += towards(n);
  }
  const double least = cosine * norm(sum);
  return std::all_of(near.begin(), near.end(),
                     [&](const NearTriangle& n) { return dot(sum, towards(n)) > least; });
}

}  // namespace

// Directions to x within half an angle of a common one are within the whole angle of each other. Edges and
// corners between the triangles have directions between these.
std::size_t spots_possible(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x,
                           std::span<const NearTriangle> near) {
  const bool smooth = is_smooth(mesh, cosine_of_half(rule.cosine_smooth), x, near);
  return std::min(near.size(), smooth ? 1 : most_spots);
}

// Within a quarter of the angle of their sum, any of the directions are within half of it of the sum of any
// others. They stay the same as long as x passes no plane of a triangle.
double smooth_travel(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x,
                     std::span<const NearTriangle> near) {
  const double cosine_quarter = cosine_of_half(cosine_of_half(rule.cosine_smooth));
  if (!is_smooth(mesh, distance_slack * cosine_quarter, x, near)) return 0;
  double travel = std::numeric_limits<double>::infinity();
  for (const NearTriangle& n : near)
    travel = std::min(travel, std::abs(height_over(mesh.triangles()[n.triangle], x)));
  return travel / distance_slack;
}

void SpotMatches::find(const SpotRule& rule, const Vec3& x, std::span<const NearestPoint> spots,
                       std::span<const KeptSpot> former) {
  constexpr double cosine_least = 0.94;
  const double cosine = std::min(rule.cosine_smooth, cosine_least);
  matches_.clear();
  before_.assign(spots.size(), -1);
  for (std::size_t s = 0; s < spots.size(); ++s)
    for (std::size_t f = 0; f < former.size(); ++f)
      if (const Vec3 then = x - former[f].point; dot(then, spots[s].normal) > cosine * norm(then))
        matches_.push_back({norm(spots[s].point - former[f].point), s, f});
  std::sort(matches_.begin(), matches_.end(), [](const Match& a, const Match& b) {
    return std::tie(a.moved, a.spot, a.before) < std::tie(b.moved, b.spot, b.before);
  });
  for (const Match& match : matches_)
    if (before_[match.spot] < 0 &&
        std::find(before_.begin(), before_.end(), int(match.before)) == before_.end())
      before_[match.spot] = int(match.before);
}

}  // namespace scree
