#include "ranks/bodies_near.hpp"

#include "ranks/messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scree {

namespace {

// The smallest box of the centres of a tile's bodies, and their largest radius (m).
struct TileBox {
  static constexpr std::size_t width = 7;
  std::array<double, 3> lower, upper;
  double radius;
};

struct PlacedSphere {
  std::uint32_t place;
  Sphere sphere;
};

// Of all tiles; each rank measures its own.
std::vector<TileBox> boxes_of(RankShare& share, std::span<const Sphere> bodies, const BodyTiles& tiles) {
  std::vector<double> numbers(TileBox::width * tiles.count(), -std::numeric_limits<double>::infinity());
  for (const std::uint32_t tile : share.owners.own()) {
    double* const of_tile = numbers.data() + TileBox::width * tile;
    for (std::size_t i = tiles[tile].begin; i < tiles[tile].end; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = bodies[i].position[int(k)];
        of_tile[k] = std::max(of_tile[k], -x), of_tile[3 + k] = std::max(of_tile[3 + k], x);
      }
      of_tile[6] = std::max(of_tile[6], bodies[i].radius);
    }
  }
  share.ranks.combine(numbers, {});
  std::vector<TileBox> boxes;
  for (std::size_t t = 0; t < tiles.count(); ++t) {
    const double* const n = numbers.data() + TileBox::width * t;
    boxes.push_back({{-n[0], -n[1], -n[2]}, {n[3], n[4], n[5]}, n[6]});
  }
  return boxes;
}

// Whether an interval of half a length about a centre, grown by `reach`, meets another one, along an axis
// that may be periodic.
bool meets(double distance, double half_lengths, double reach, double period) {
  distance = std::abs(distance);
  if (period > 0) distance = std::min(distance, std::abs(period - distance));
  return distance <= half_lengths + reach;
}

bool is_near(const TileBox& box, const std::array<double, 3>& lower, const std::array<double, 3>& upper,
             double reach, const Domain& domain) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double distance = 0.5 * ((box.upper[k] + box.lower[k]) - (upper[k] + lower[k]));
    const double half_lengths = 0.5 * ((box.upper[k] - box.lower[k]) + (upper[k] - lower[k]));
    if (!meets(distance, half_lengths, reach, domain.periodic[k] ? domain.length(int(k)) : 0)) return false;
  }
  return true;
}

// Round-off of the test of nearness, relative to the coordinates; bodies that are too far are no error.
double slack(const TileBox& box) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max({largest, std::abs(box.lower[k]), std::abs(box.upper[k])});
  return 1e-12 * largest;
}

// The ranks with tiles before this one that the body may be near to.
void send_to_near(const Sphere& body, std::uint32_t place, const std::vector<std::uint32_t>& near_tiles,
                  const std::vector<TileBox>& boxes, const Domain& domain, double skin,
                  const TileOwners& owners, std::vector<std::vector<PlacedSphere>>& sent) {
  const std::array<double, 3> at = {body.position[0], body.position[1], body.position[2]};
  for (const std::uint32_t tile : near_tiles) {
    std::vector<PlacedSphere>& to = sent[owners.rank_of(tile)];
    if (!to.empty() && to.back().place == place) continue;
    const double reach = body.radius + boxes[tile].radius + skin + slack(boxes[tile]);
    if (is_near(boxes[tile], at, at, reach, domain)) to.push_back({place, body});
  }
}

}  // namespace

NearBodies find_near_bodies(RankShare& share, std::span<const Sphere> bodies, const Domain& domain,
                            double skin) {
  const BodyTiles tiles(bodies.size());
  const std::vector<TileBox> boxes = boxes_of(share, bodies, tiles);
  std::vector<std::vector<PlacedSphere>> sent(share.ranks.size());
  std::vector<PlacedSphere> near;
  for (const std::uint32_t tile : share.owners.own()) {
    std::vector<std::uint32_t> near_tiles;
    for (std::uint32_t other = 0; other < tile; ++other) {
      const double reach = boxes[tile].radius + boxes[other].radius + skin + slack(boxes[other]);
      if (!share.owners.is_own(other) &&
          is_near(boxes[other], boxes[tile].lower, boxes[tile].upper, reach, domain))
        near_tiles.push_back(other);
    }
    for (std::size_t i = tiles[tile].begin; i < tiles[tile].end; ++i) {
      near.push_back({std::uint32_t(i), bodies[i]});
      send_to_near(bodies[i], std::uint32_t(i), near_tiles, boxes, domain, skin, share.owners, sent);
    }
  }
  for (const std::vector<PlacedSphere>& received : exchange_items(share.ranks, sent))
    near.insert(near.end(), received.begin(), received.end());
  std::sort(near.begin(), near.end(),
            [](const PlacedSphere& one, const PlacedSphere& other) { return one.place < other.place; });
  NearBodies found;
  for (const PlacedSphere& body : near)
    found.spheres.push_back(body.sphere), found.places.push_back(body.place);
  return found;
}

}  // namespace scree
