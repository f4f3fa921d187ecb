#include "surfaces/contact_spots.hpp"

#include "machine/instruction_levels.hpp"

#include <algorithm>
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

// Of all triangles within the reach; if one spot is wanted, of all that may be the nearest.
SCREE_EVERY_LEVEL_INLINED void find_candidates(const TriangleTree& triangles, const SpotQuery& query,
                                               std::span<const NearTriangle> near,
                                               std::vector<SpotCandidate>& candidates) {
  candidates.clear();
  double furthest = query.reach;
  for (const NearTriangle& triangle : near) {
    if (triangle.distance - query.moved > distance_slack * furthest) return;
    const SpotCandidate c = candidate_on(triangles, triangle.triangle, query.centre);
    if (!(c.distance < query.reach)) continue;
    candidates.push_back(c);
    if (query.most == 1) furthest = std::min(furthest, c.distance);
  }
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
  find_candidates(mesh.triangles(), query, near, candidates_);
  std::sort(candidates_.begin(), candidates_.end(), [](const SpotCandidate& a, const SpotCandidate& b) {
    return std::tie(a.distance, a.triangle) < std::tie(b.distance, b.triangle);
  });
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

// Directions to x within half an angle of a common one are within the whole angle of each other. Edges and
// corners between the triangles have directions between these.
std::size_t spots_possible(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x,
                           std::span<const NearTriangle> near) {
  const auto towards = [&](std::uint32_t t) {
    const Triangle& triangle = mesh.triangles()[t];
    return dot(x - triangle.corner[0], triangle.normal) < 0 ? -triangle.normal : triangle.normal;
  };
  Vec3 sum = {};
  bool border = false;
  for (const NearTriangle& n : near)
    sum += towards(n.triangle), border = border || mesh.at_border(n.triangle);
  const double cosine_half = std::sqrt(0.5 * (1 + rule.cosine_smooth)), length = norm(sum);
  const bool smooth = !border && std::all_of(near.begin(), near.end(), [&](const NearTriangle& n) {
    return dot(sum, towards(n.triangle)) > cosine_half * length;
  });
  return smooth ? std::min<std::size_t>(near.size(), 1) : std::min(near.size(), most_spots);
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
