#include "contacts/mesh_spots.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include <scree/plugin/great_circle.hpp>

namespace scree {

namespace {

// Triangles are looked for anew when a body has moved by this part of its radius.
constexpr double margin = 0.1;

// The triangles of a mesh exceed caches.
void prefetch(const Triangle& triangle) {
  constexpr std::size_t cache_line = 64;
  const char* const bytes = reinterpret_cast<const char*>(&triangle);
  for (std::size_t k = 0; k < sizeof(Triangle); k += cache_line) __builtin_prefetch(bytes + k);
}

}  // namespace

MeshSpots::Surroundings MeshSpots::known_before(const Key& key) {
  const auto precedes = [](const Key& a, const Key& b) {
    return std::tie(a.place, a.wall) < std::tie(b.place, b.wall);
  };
  while (next_before_ < before_.size() && precedes(before_[next_before_].key, key)) ++next_before_;
  if (next_before_ < before_.size() && before_[next_before_].key == key)
    return std::move(before_[next_before_]);
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  return {key, {{nowhere, nowhere, nowhere}}, {}, 0};
}

const std::vector<NearestPoint>& MeshSpots::find(const TriangleMesh& mesh, const SpotRule& rule,
                                                 const Key& key, const SpotQuery& query) {
  if (next_ == surroundings_.size()) surroundings_.push_back(known_before(key));
  Surroundings& of = surroundings_[next_++];
  constexpr std::size_t ahead = 1;  // bodies after the next one
  if (next_ + ahead < surroundings_.size())
    if (const Surroundings& later = surroundings_[next_ + ahead]; later.key.wall == key.wall)
      prefetch(mesh.triangles()[later.nearest]);
  Vec3 moved = query.centre - of.centre;
  if (!(norm(moved) <= margin * query.reach)) {
    mesh.triangles().find_near(query.centre, distance_slack * (1 + margin) * query.reach, of.near);
    of.centre = query.centre, moved = {};
  }
  const std::vector<NearestPoint>& spots =
      finder_.find(mesh, rule, {query.centre, query.reach, query.most, moved, of.nearest}, of.near);
  of.nearest = finder_.nearest_triangle(of.nearest);
  return spots;
}

namespace {

// Columns of PairGroup::spots: whether there is one, where, and its normal.
constexpr std::uint32_t there = 0, place = 1, direction = 4;

Vec3 read(const PairColumns& columns, std::uint32_t first, std::size_t row) {
  return {{columns.column(first)[row], columns.column(first + 1)[row], columns.column(first + 2)[row]}};
}
void write(const Vec3& v, std::uint32_t first, std::size_t row, PairColumns& columns) {
  for (int k = 0; k < 3; ++k) columns.column(first + std::uint32_t(k))[row] = v[k];
}

}  // namespace

void read_kept_spots(const PairGroup& group, std::size_t begin, std::size_t end,
                     std::vector<KeptSpot>& spots) {
  spots.clear();
  for (std::size_t pair = begin; pair < end; ++pair)
    if (const std::size_t row = pair - group.begin; group.spots.column(there)[row] != 0)
      spots.push_back({read(group.spots, place, row), read(group.spots, direction, row), pair});
}

bool MeshSpots::touched(const Pairs& of) {
  for (std::size_t pair = of.begin; pair < of.end; ++pair)
    if (of.group.spots.column(there)[pair - of.group.begin] != 0) return true;
  return false;
}

void MeshSpots::follow(const SpotRule& rule, const Vec3& x, const std::vector<NearestPoint>& spots,
                       const Pairs& of, const Surrounded& by) {
  const std::size_t pairs = of.end - of.begin, now = std::min(spots.size(), pairs);
  read_kept_spots(of.group, of.begin, of.end, former_);
  if (by.domain.any_periodic()) bring_former_near(x, by);
  matches_.find(rule, x, std::span(spots).first(now), former_);
  if (former_.empty()) return;  // nothing touched, or a state without spots has been taken over
  const bool stays = pairs == 1 && now == 1 && matches_[0] == 0;
  if (stays) return;
  find_origins(pairs, now);
  for (std::uint32_t k = 0; k < of.group.history_width; ++k) {
    double* const column = of.group.history.column(k) + (of.begin - of.group.begin);
    numbers_.assign(column, column + pairs);
    for (std::size_t s = 0; s < pairs; ++s)
      column[s] = origins_[s] >= 0 ? numbers_[former_[std::size_t(origins_[s])].pair - of.begin] : 0;
  }
}

void MeshSpots::bring_former_near(const Vec3& x, const Surrounded& by) {
  for (KeptSpot& former : former_) {
    const Vec3 apart = by.to_scene(x - former.point);
    Vec3 periods = {};
    for (int k = 0; k < 3; ++k)
      if (by.domain.periodic[std::size_t(k)])
        periods[k] = std::round(apart[k] / by.domain.length(k)) * by.domain.length(k);
    if (dot(periods, periods) > 0) former.point += by.to_scene.back()(periods);
  }
}

// Spots that are no more go to pairs without one, where laws let their springs go.
void MeshSpots::find_origins(std::size_t pairs, std::size_t now) {
  origins_.assign(pairs, -1);
  std::vector<bool> goes_on(former_.size(), false);
  for (std::size_t s = 0; s < now; ++s) {
    origins_[s] = matches_[s];
    if (matches_[s] >= 0) goes_on[std::size_t(matches_[s])] = true;
  }
  std::size_t free = now;
  for (std::size_t f = 0; f < former_.size() && free < pairs; ++f)
    if (!goes_on[f]) origins_[free++] = int(f);
}

void MeshSpots::turn_springs(const Rotation& to_scene, const std::vector<NearestPoint>& spots,
                             const Pairs& of) const {
  for (std::size_t s = 0; s < matches_.size(); ++s) {
    if (matches_[s] < 0) continue;
    const Vec3 &from = former_[std::size_t(matches_[s])].normal, &to = spots[s].normal;
    if (from == to) continue;
    const std::size_t row = of.begin + s - of.group.begin;
    const Vec3 spring = to_scene.back()(read(of.group.history, 0, row));
    write(to_scene(turned_between(spring, from, to)), 0, row, of.group.history);
  }
}

// Between the former spot and the present one.
NearestPoint MeshSpots::middle(std::size_t spot, const NearestPoint& now) const {
  if (spot >= matches_.size() || matches_[spot] < 0) return now;
  const KeptSpot& before = former_[std::size_t(matches_[spot])];
  if (before.normal == now.normal) return {0.5 * (before.point + now.point), now.normal, now.distance, {}};
  const Vec3 sum = before.normal + now.normal;
  return {0.5 * (before.point + now.point), 1 / norm(sum) * sum, now.distance, {}};
}

void MeshSpots::keep(const std::vector<NearestPoint>& spots, const Pairs& of) {
  for (std::size_t s = 0; s < of.end - of.begin; ++s) {
    const std::size_t row = of.begin + s - of.group.begin;
    const bool touches = s < spots.size();
    of.group.spots.column(there)[row] = touches;
    write(touches ? spots[s].point : Vec3{}, place, row, of.group.spots);
    write(touches ? spots[s].normal : Vec3{}, direction, row, of.group.spots);
  }
}

void keep_spot(PairGroup& group, std::size_t row, const Vec3& point, const Vec3& normal) {
  group.spots.column(there)[row] = 1;
  write(point, place, row, group.spots);
  write(normal, direction, row, group.spots);
}

// Spots that were not there before are of the pairs that had none, in order.
std::optional<NearestPoint> spot_of_pair(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x,
                                         double radius, const Contacts& contacts, const PairGroup& group,
                                         std::size_t pair) {
  const auto same = [&](std::size_t q) {
    return contacts.a[q] == contacts.a[pair] && contacts.b[q] == contacts.b[pair];
  };
  std::size_t begin = pair, end = pair + 1;
  while (begin > group.begin && same(begin - 1)) --begin;
  while (end < group.end && same(end)) ++end;
  std::vector<NearTriangle> near;
  mesh.triangles().find_near(x, radius, near);
  SpotFinder finder;
  const std::vector<NearestPoint>& spots = finder.find(mesh, rule, {x, radius, end - begin}, near);
  std::vector<KeptSpot> former;
  read_kept_spots(group, begin, end, former);
  SpotMatches before;
  before.find(rule, x, spots, former);
  std::vector<std::size_t> of_spot(end - begin, spots.size());
  for (std::size_t s = 0; s < spots.size(); ++s)
    if (before[s] >= 0) of_spot[former[std::size_t(before[s])].pair - begin] = s;
  for (std::size_t s = 0; s < spots.size(); ++s)
    if (const auto free = std::find(of_spot.begin(), of_spot.end(), spots.size());
        before[s] < 0 && free != of_spot.end())
      *free = s;
  const std::size_t spot = of_spot[pair - begin];
  return spot < spots.size() ? std::optional(spots[spot]) : std::nullopt;
}

}  // namespace scree
