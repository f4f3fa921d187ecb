#include "search/neighbour_list.hpp"

#include "bodies/kept_rows.hpp"
#include "ranks/bodies_near.hpp"
#include "ranks/rank_sums.hpp"
#include "ranks/row_routes.hpp"
#include "walls/plane_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include <scree/spatial_order.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// Smallest skin, as a multiple of the distance by which a step may try to displace a plane: a list must last
// for more than one step.
constexpr double least_reaches = 8;

// Folds the position of a body into the periodic domain and counts the periods crossed.
void fold(Particles& p, std::size_t i, const Domain& domain) {
  for (int k = 0; k < p.dimension(); ++k) {
    double& x = p.position()[k][i];
    if (!domain.periodic[k] || (x >= domain.lower[k] && x < domain.upper[k])) continue;
    const double turns = std::floor((x - domain.lower[k]) / domain.length(k));
    x -= turns * domain.length(k);
    constexpr double max_image = std::numeric_limits<std::int32_t>::max();
    p.image[k][i] = std::int32_t(std::clamp(p.image[k][i] + turns, -max_image, max_image));
  }
}

// Two fixed bodies exert no force on each other, however much they overlap. Empty if no body is fixed.
std::vector<NeighbourPair> without_fixed_pairs(const std::vector<NeighbourPair>& all, const Particles& p) {
  std::vector<NeighbourPair> pairs;
  if (p.fixed.empty()) return pairs;
  std::copy_if(all.begin(), all.end(), std::back_inserter(pairs),
               [&](const NeighbourPair& pair) { return !p.fixed[pair.a] || !p.fixed[pair.b]; });
  return pairs;
}

}  // namespace

void NeighbourList::update(double body_speed, double plane_speed, double surface_speed, double step,
                           Particles& particles, const Boundaries& boundaries, Contacts& contacts,
                           ThreadPool& threads) {
  body_travel_ += body_speed * step;
  plane_travel_ += plane_speed * step;
  surface_travel_ += surface_speed * step;
  // The integrated largest speed overestimates the displacement; measure it before searching.
  ++steps_;
  const bool review = choice_.review_due(steps_);
  if (review || skin_used_up()) measure(particles, boundaries, threads);
  const bool due = skin_used_up();
  if (!review && !due) return;
  if (!choice_.fixed()) {
    const SkinChoice::ListStatistics list = list_statistics(particles, boundaries, contacts);
    const double skin = due ? choice_.next_skin(list) : choice_.reviewed_skin(list);
    if (!due && skin == skin_) return;
    skin_ = skin;
  }
  search(body_travel_, particles, boundaries, contacts, threads);
}

void NeighbourList::extend(double body_travel, double plane_reach, Particles& particles,
                           const Boundaries& boundaries, Contacts& contacts, ThreadPool& threads) {
  choice_.keep_above(least_reaches * plane_reach);
  if (!used_up(body_travel_ + body_travel, wall_travel() + plane_reach)) return;
  measure(particles, boundaries, threads);
  if (!used_up(body_travel_, wall_travel() + plane_reach)) return;
  if (!choice_.fixed()) skin_ = choice_.next_skin(list_statistics(particles, boundaries, contacts));
  search(body_travel_, particles, boundaries, contacts, threads);
}

void NeighbourList::measure(const Particles& p, const Boundaries& boundaries, ThreadPool& threads) {
  const BodyTiles tiles(p.size());
  std::vector<double> largest(tiles.count());
  const std::vector<std::uint32_t> own = own_tiles(p.size());
  threads.each(own.size(), [&](std::size_t item, unsigned) {
    const std::uint32_t t = own[item];
    double largest_square = 0;
    for (std::size_t i = tiles[t].begin; i < tiles[t].end; ++i) {
      double square = 0;
      for (int k = 0; k < p.dimension(); ++k) {
        const double moved = p.position()[k][i] - bodies_at_search_[i].position[k];
        square += moved * moved;
      }
      largest_square = std::max(largest_square, square);
    }
    largest[t] = largest_square;
  });
  double square = *std::max_element(largest.begin(), largest.end());
  RankSums sums(ranks());
  sums.largest(square);
  sums.close();
  body_travel_ = std::sqrt(square);
  plane_travel_ = 0;
  for (std::size_t w = 0; w < planes_at_search_.size(); ++w) {
    double moved = 0;
    const scree_plane &now = boundaries.planes()[w], &then = planes_at_search_[w];
    for (int k = 0; k < p.dimension(); ++k) moved += (now.point[k] - then.point[k]) * then.normal[k];
    plane_travel_ = std::max(plane_travel_, std::abs(moved));
  }
}

void NeighbourList::record_positions(Particles& p, const Domain& domain, ThreadPool& threads) {
  bodies_at_search_.resize(p.size());
  const BodyTiles tiles(p.size());
  const std::vector<std::uint32_t> own = own_tiles(p.size());
  threads.each(own.size(), [&](std::size_t item, unsigned) {
    const std::uint32_t t = own[item];
    for (std::size_t i = tiles[t].begin; i < tiles[t].end; ++i) {
      if (domain.any_periodic()) fold(p, i, domain);
      bodies_at_search_[i] = {{}, p.radius()[i]};
      for (int k = 0; k < p.dimension(); ++k) bodies_at_search_[i].position[k] = p.position()[k][i];
    }
  });
}

void NeighbourList::rebuild(Particles& particles, const Boundaries& boundaries, Contacts& contacts,
                            ThreadPool& threads) {
  search(std::numeric_limits<double>::infinity(), particles, boundaries, contacts, threads);
}

void NeighbourList::search(double moved, Particles& particles, const Boundaries& boundaries,
                           Contacts& contacts, ThreadPool& threads) {
  record_positions(particles, boundaries.domain(), threads);
  Contacts::Lookup lookup = lookup_;
  lookup.body_material = particles.material.data();
  const std::vector<std::uint32_t> wall_materials = boundaries.wall_materials();
  lookup.plane_material = wall_materials.data();
  lookup.surfaces_from = std::uint32_t(boundaries.planes().size());
  const int dimension = particles.dimension();
  const std::vector<NeighbourPair>& found = find_pairs(moved, particles, boundaries.domain(), threads);
  const std::vector<NeighbourPair> some = without_fixed_pairs(found, particles);
  const std::vector<PlanePair> near_walls = near_walls_.find(
      bodies_at_search_, own_tiles(particles.size()), boundaries, skin_, moved + surface_travel_, threads);
  contacts.rebuild(particles.fixed.empty() ? found : some,  // no copy of what was found
                   near_walls, lookup, particles.order(), threads);
  planes_at_search_ = boundaries.planes();
  absent_at_search_ = boundaries.absent();
  body_travel_ = plane_travel_ = surface_travel_ = 0;
  if (boundaries.surfaces().size() > 0) measure_reach(boundaries);
  steps_ = 0;
  ++rebuilds_;
  compare_order(contacts, dimension);
}

// A body may come nearer by a skin, and meet what is a radius away.
void NeighbourList::measure_reach(const Boundaries& boundaries) {
  const std::vector<scree_frame>& frames = boundaries.surfaces().frames;
  surface_reach_.assign(frames.size(), 0);
  RankSums sums(ranks());
  for (std::size_t s = 0; s < frames.size(); ++s) {
    const auto& origin = frames[s].position;
    const Vec3 from = {{origin[0], origin[1], origin[2]}};
    for (const std::uint32_t tile : own_tiles(bodies_at_search_.size())) {
      const BodyRange range = BodyTiles(bodies_at_search_.size())[tile];
      for (std::size_t i = range.begin; i < range.end; ++i)
        surface_reach_[s] = std::max(surface_reach_[s], norm(bodies_at_search_[i].position - from) +
                                                            bodies_at_search_[i].radius + skin_);
    }
    sums.largest(surface_reach_[s]);
  }
  sums.close();
}

std::vector<std::uint32_t> NeighbourList::own_tiles(std::size_t bodies) const {
  if (share_) return share_->owners.own();
  std::vector<std::uint32_t> all(BodyTiles(bodies).count());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

const std::vector<NeighbourPair>& NeighbourList::find_pairs(double moved, Particles& particles,
                                                            const Domain& domain, ThreadPool& threads) {
  if (!share_) return search_.find(bodies_at_search_, particles.dimension(), domain, skin_, moved, threads);
  find_own_pairs(moved, particles, domain, threads);
  return own_pairs_;
}

void NeighbourList::find_own_pairs(double moved, Particles& particles, const Domain& domain,
                                   ThreadPool& threads) {
  // In skins; candidates of repeated searches usually reach as far.
  constexpr double near_reach = 5, least_near_reach = 2;
  near_covered_ -= 2 * moved;
  if (!(near_covered_ > least_near_reach * skin_)) {
    near_covered_ = near_reach * skin_;
    near_.find(*share_, bodies_at_search_, domain, near_covered_);
    near_.bring(*share_, particles.material.data());
    if (!particles.fixed.empty()) near_.bring(*share_, particles.fixed.data());
    moved = std::numeric_limits<double>::infinity();
  } else {
    near_.update(*share_, bodies_at_search_);
  }
  const BodyTiles tiles(bodies_at_search_.size());
  own_pairs_.clear();
  const std::vector<std::uint32_t>& places = near_.places();
  for (const NeighbourPair& pair :
       search_.find(near_.spheres(), particles.dimension(), domain, skin_, moved, threads, near_covered_))
    if (share_->owners.is_own(tiles.owner(places[pair.a])))
      own_pairs_.push_back({places[pair.a], places[pair.b], pair.image});
}

void NeighbourList::send(const RowRoutes& routes) { routes.send(share_->ranks, bodies_at_search_.data(), 1); }

void NeighbourList::rearrange(const std::vector<std::uint32_t>& from, std::span<const BodyRange> kept) {
  rearrange_rows(bodies_at_search_, 1, from, kept);
  better_order_.clear();
  near_covered_ = 0;
  near_walls_.forget();
}

// In scene order.
void NeighbourList::transfer_bodies(const StateTransfer& state, const BodyOrder& order) {
  BodyColumn<Sphere> bodies = bodies_at_search_;
  if (order.rearranged()) rearrange_rows(bodies, 1, order.back());
  double* const first = bodies.empty() ? nullptr : bodies[0].position.component;
  state.vectors("position_at_search", "m", {first, sizeof(Sphere) / sizeof(double), bodies.size(), 0, 3}, 0,
                3);
  if (!state.restoring()) return;
  if (order.rearranged()) rearrange_rows(bodies, 1, order.numbers());
  bodies_at_search_ = std::move(bodies);
}

// Small scenes and old states have no share; it is then compared at the next search.
void NeighbourList::transfer_crossing(const StateTransfer& state) {
  const char* const name = "crossing_when_sorted";
  if (state.restoring() ? state.has(name) : crossing_when_sorted_ > 0)
    state.value(name, "1", crossing_when_sorted_, stored::non_negative);
}

void NeighbourList::transfer(const StateTransfer& state, const Particles& particles,
                             const Boundaries& boundaries) {
  transfer_but_bodies(state, particles, boundaries);
  transfer_bodies(state, particles.order());
  for (std::size_t i = 0; state.restoring() && i < particles.size(); ++i)
    bodies_at_search_[i].radius = particles.radius()[i];
}

void NeighbourList::transfer_but_bodies(const StateTransfer& state, const Particles& particles,
                                        const Boundaries& boundaries) {
  if (state.restoring()) {
    bodies_at_search_.resize(particles.size());
    planes_at_search_ = boundaries.planes();
    absent_at_search_ = boundaries.absent();
  }
  state.value("skin", "m", skin_, stored::positive);
  skin_ = std::min(skin_, choice_.largest());
  choice_.transfer(state);
  state.value("steps", "1", steps_);
  state.value("searches", "1", rebuilds_);
  state.value("body_travel", "m", body_travel_, stored::non_negative);
  state.value("plane_travel", "m", plane_travel_, stored::non_negative);
  if (boundaries.surfaces().size() > 0) {
    state.value("surface_travel", "m", surface_travel_, stored::non_negative);
    state.rows("surface_reach", "m", surface_reach_);
  }
  transfer_crossing(state);
  transfer_planes(state.below("planes_at_search"), planes_at_search_);
}

}  // namespace scree
