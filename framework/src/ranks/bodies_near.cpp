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
                  const TileOwners& owners, std::vector<std::vector<std::uint32_t>>& sent) {
  const std::array<double, 3> at = {body.position[0], body.position[1], body.position[2]};
  for (const std::uint32_t tile : near_tiles) {
    std::vector<std::uint32_t>& to = sent[owners.rank_of(tile)];
    if (!to.empty() && to.back() == place) continue;
    const double reach = body.radius + boxes[tile].radius + skin + slack(boxes[tile]);
    if (is_near(boxes[tile], at, at, reach, domain)) to.push_back(place);
  }
}

}  // namespace

void NearBodies::find(RankShare& share, std::span<const Sphere> bodies, const Domain& domain, double skin) {
  const BodyTiles tiles(bodies.size());
  const std::vector<TileBox> boxes = boxes_of(share, bodies, tiles);
  sent_.assign(share.ranks.size(), {});
  places_.clear();
  for (const std::uint32_t tile : share.owners.own()) {
    std::vector<std::uint32_t> near_tiles;
    for (std::uint32_t other = 0; other < tile; ++other) {
      const double reach = boxes[tile].radius + boxes[other].radius + skin + slack(boxes[other]);
      if (!share.owners.is_own(other) &&
          is_near(boxes[other], boxes[tile].lower, boxes[tile].upper, reach, domain))
        near_tiles.push_back(other);
    }
    for (std::size_t i = tiles[tile].begin; i < tiles[tile].end; ++i) {
      places_.push_back(std::uint32_t(i));
      send_to_near(bodies[i], std::uint32_t(i), near_tiles, boxes, domain, skin, share.owners, sent_);
    }
  }
  list(exchange_items(share.ranks, sent_), share.owners, tiles);
  update(share, bodies);
}

void NearBodies::list(const std::vector<std::vector<std::uint32_t>>& received, const TileOwners& owners,
                      const BodyTiles& tiles) {
  for (const std::vector<std::uint32_t>& of_rank : received)
    places_.insert(places_.end(), of_rank.begin(), of_rank.end());
  std::sort(places_.begin(), places_.end());
  spheres_.resize(places_.size());
  own_.clear();
  for (std::uint32_t k = 0; k < places_.size(); ++k)
    if (owners.is_own(tiles.owner(places_[k]))) own_.push_back(k);
  received_ = received;
  for (std::vector<std::uint32_t>& of_rank : received_)
    for (std::uint32_t& place : of_rank)
      place = std::uint32_t(std::lower_bound(places_.begin(), places_.end(), place) - places_.begin());
}

void NearBodies::update(RankShare& share, std::span<const Sphere> bodies) {
  for (const std::uint32_t k : own_) spheres_[k] = bodies[places_[k]];
  std::vector<std::vector<Sphere>> sent(sent_.size());
  for (std::size_t r = 0; r < sent_.size(); ++r)
    for (const std::uint32_t place : sent_[r]) sent[r].push_back(bodies[place]);
  const std::vector<std::vector<Sphere>> received = exchange_items(share.ranks, sent);
  for (std::size_t r = 0; r < received_.size(); ++r)
    for (std::size_t k = 0; k < received_[r].size(); ++k) spheres_[received_[r][k]] = received[r][k];
}

}  // namespace scree
