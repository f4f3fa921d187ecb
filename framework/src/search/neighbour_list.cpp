#include "search/neighbour_list.hpp"

#include "walls/plane_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <scree/spatial_order.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// Smallest skin, as a multiple of the distance by which a step may try to displace a plane: a list must last
// for more than one step.
constexpr double least_reaches = 8;

// Bodies are sorted again when the share of pairs that cross tiles exceeds this multiple of the share if they
// were sorted now. That is computed only above the multiple of the last such share, and above a share below
// which sorting would gain nothing.
constexpr double worn_ratio = 1.1, least_worn_share = 0.1;

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

// Visits every n-th pair of a group, with the number of pairs for which it stands.
template <class Visit>
void sample(const PairGroup& group, std::size_t n, const Visit& visit) {
  std::size_t before = 0, next = 0;  // counted over all runs
  for (const PairRun& run : group.runs) {
    const std::size_t pairs = run.end - run.begin;
    for (; next < before + pairs; next += n)
      visit(run.begin + (next - before), double(std::min(n, group.pairs - next)));
    before += pairs;
  }
}

// Numbers of listed and of touching pairs of bodies, the latter estimated from a few thousand samples.
std::pair<double, double> count_pairs(const Particles& p, const Contacts& contacts, const Domain& domain) {
  constexpr std::size_t max_samples = 2500;
  double listed = 0, touching = 0;
  for (const PairGroup& group : contacts.groups()) {
    if (group.planes) continue;
    listed += double(group.pairs);
    sample(group, 1 + group.pairs / max_samples, [&](std::size_t q, double stands_for) {
      const std::uint32_t a = contacts.a[q], b = contacts.b[q];
      const Vec3 shift = domain.shift(contacts.image[q]);
      const double reach = p.radius()[a] + p.radius()[b];
      double square = 0;
      for (int k = 0; k < p.dimension(); ++k) {
        const double difference = p.position()[k][a] - p.position()[k][b] + shift[k];
        square += difference * difference;
      }
      touching += square < reach * reach ? stands_for : 0;
    });
  }
  return {listed, touching};
}

// Two fixed bodies exert no force on each other, however much they overlap. Empty if no body is fixed.
std::vector<NeighbourPair> without_fixed_pairs(const std::vector<NeighbourPair>& all, const Particles& p) {
  std::vector<NeighbourPair> pairs;
  if (p.fixed.empty()) return pairs;
  std::copy_if(all.begin(), all.end(), std::back_inserter(pairs),
               [&](const NeighbourPair& pair) { return !p.fixed[pair.a] || !p.fixed[pair.b]; });
  return pairs;
}

std::vector<PlanePair> near_planes(std::span<const Sphere> bodies, const Boundaries& boundaries,
                                   int dimension, double skin) {
  const std::vector<scree_plane>& planes = boundaries.planes();
  std::vector<PlanePair> pairs;
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    for (std::uint32_t w = 0; w < planes.size(); ++w) {
      if (boundaries.absent()[w]) continue;
      double height = 0;
      for (int k = 0; k < dimension; ++k)
        height += (bodies[i].position[k] - planes[w].point[k]) * planes[w].normal[k];
      if (height < bodies[i].radius + skin) pairs.push_back({i, w});
    }
  return pairs;
}

}  // namespace

void NeighbourList::update(double body_speed, double plane_speed, double step, Particles& particles,
                           const Boundaries& boundaries, Contacts& contacts, ThreadPool& threads) {
  body_travel_ += body_speed * step;
  plane_travel_ += plane_speed * step;
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
  if (!used_up(body_travel_ + body_travel, plane_travel_ + plane_reach)) return;
  measure(particles, boundaries, threads);
  if (!used_up(body_travel_, plane_travel_ + plane_reach)) return;
  if (!choice_.fixed()) skin_ = choice_.next_skin(list_statistics(particles, boundaries, contacts));
  search(body_travel_, particles, boundaries, contacts, threads);
}

SkinChoice::ListStatistics NeighbourList::list_statistics(const Particles& particles,
                                                          const Boundaries& boundaries,
                                                          const Contacts& contacts) const {
  const auto [listed, touching] = count_pairs(particles, contacts, boundaries.domain());
  const double travelled = std::max(body_travel_, plane_travel_);
  return {skin_, travelled, steps_, listed, touching, double(particles.size())};
}

void NeighbourList::measure(const Particles& p, const Boundaries& boundaries, ThreadPool& threads) {
  const BodyTiles tiles(p.size());
  std::vector<double> largest(tiles.count());
  threads.each(tiles.count(), [&](std::size_t t, unsigned) {
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
  body_travel_ = std::sqrt(*std::max_element(largest.begin(), largest.end()));
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
  threads.each(tiles.count(), [&](std::size_t t, unsigned) {
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
  lookup.plane_material = boundaries.plane_materials().data();
  const int dimension = particles.dimension();
  const std::vector<NeighbourPair>& found =
      search_.find(bodies_at_search_, dimension, boundaries.domain(), skin_, moved, threads);
  const std::vector<NeighbourPair> some = without_fixed_pairs(found, particles);
  contacts.rebuild(particles.fixed.empty() ? found : some,  // no copy of what was found
                   near_planes(bodies_at_search_, boundaries, dimension, skin_), lookup, particles.order(),
                   threads);
  planes_at_search_ = boundaries.planes();
  absent_at_search_ = boundaries.absent();
  body_travel_ = plane_travel_ = 0;
  steps_ = 0;
  ++rebuilds_;
  compare_order(contacts, dimension);
}

void NeighbourList::compare_order(const Contacts& contacts, int dimension) {
  better_order_.clear();
  const double share = contacts.crossing_share();
  if (share <= std::max(worn_ratio * crossing_when_sorted_, least_worn_share)) return;
  std::vector<std::uint32_t> sorted = spatial_order(bodies_at_search_, dimension);
  crossing_when_sorted_ = contacts.crossing_share(sorted);
  if (share > worn_ratio * crossing_when_sorted_) better_order_ = std::move(sorted);
}

void NeighbourList::rearrange(const std::vector<std::uint32_t>& from) {
  rearrange_rows(bodies_at_search_, 1, from);
  better_order_.clear();
}

// In scene order.
void NeighbourList::transfer_bodies(const StateTransfer& state, const BodyOrder& order) {
  Column<Sphere> bodies = bodies_at_search_;
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
  if (state.restoring()) {
    bodies_at_search_.resize(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) bodies_at_search_[i] = {{}, particles.radius()[i]};
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
  transfer_bodies(state, particles.order());
  transfer_crossing(state);
  transfer_planes(state.below("planes_at_search"), planes_at_search_);
}

}  // namespace scree
