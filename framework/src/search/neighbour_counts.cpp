#include "ranks/rank_sums.hpp"
#include "ranks/row_routes.hpp"
#include "search/neighbour_list.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <scree/spatial_order.hpp>

// Counts of listed pairs over all ranks, from which the skin and the order of the bodies in memory follow.
namespace scree {

namespace {

// Bodies are sorted again when the share of pairs that cross tiles exceeds this multiple of the share if they
// were sorted now. That is computed only above the multiple of the last such share, and above a share below
// which sorting would gain nothing.
constexpr double worn_ratio = 1.1, least_worn_share = 0.1;

// Number of pairs of each tile of a group; each rank lists the pairs of its tiles.
std::vector<std::int64_t> pairs_of_tiles(const PairGroup& group, Ranks* ranks) {
  std::vector<std::int64_t> pairs;
  for (const PairRun& run : group.runs) pairs.push_back(std::int64_t(run.end - run.begin));
  if (ranks) ranks->combine({}, pairs);
  return pairs;
}

// Visits every n-th pair of a group, counted over the pairs of all tiles, with the number of pairs for which
// it stands; n is such that there are about as many samples as wanted.
template <class Visit>
void sample(const PairGroup& group, const std::vector<std::int64_t>& pairs, std::size_t wanted,
            const Visit& visit) {
  const auto all = std::size_t(std::accumulate(pairs.begin(), pairs.end(), std::int64_t(0)));
  const std::size_t n = 1 + all / wanted;
  std::size_t before = 0, next = 0;
  for (std::size_t t = 0; t < pairs.size(); ++t) {
    const PairRun& run = group.runs[t];
    for (; next < before + std::size_t(pairs[t]); next += n)
      if (run.end > run.begin) visit(run.begin + (next - before), std::int64_t(std::min(n, all - next)));
    before += std::size_t(pairs[t]);
  }
}

// Numbers of listed and of touching pairs of bodies, the latter estimated from a few thousand samples.
std::pair<double, double> count_pairs(const Particles& p, const Contacts& contacts, const Domain& domain,
                                      Ranks* ranks) {
  constexpr std::size_t max_samples = 2500;
  std::int64_t listed = 0, touching = 0;
  for (const PairGroup& group : contacts.groups()) {
    if (group.planes) continue;
    const std::vector<std::int64_t> pairs = pairs_of_tiles(group, ranks);
    listed += std::accumulate(pairs.begin(), pairs.end(), std::int64_t(0));
    sample(group, pairs, max_samples, [&](std::size_t q, std::int64_t stands_for) {
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
  if (ranks) ranks->combine({}, {&touching, 1});
  return {double(listed), double(touching)};
}

// Share of the pairs of all ranks that cross tiles.
double share_of(CrossingPairs pairs, Ranks* ranks) {
  RankSums sums(ranks);
  sums.total(pairs.all);
  sums.total(pairs.crossing);
  sums.close();
  return pairs.share();
}

}  // namespace

SkinChoice::ListStatistics NeighbourList::list_statistics(const Particles& particles,
                                                          const Boundaries& boundaries,
                                                          const Contacts& contacts) const {
  if (share_) bring_others_();
  const auto [listed, touching] = count_pairs(particles, contacts, boundaries.domain(), ranks());
  const double travelled = std::max(body_travel_, wall_travel());
  return {skin_, travelled, steps_, listed, touching, double(particles.size())};
}

void NeighbourList::compare_order(const Contacts& contacts, int dimension) {
  better_order_.clear();
  const double share = share_of(contacts.crossing(), ranks());
  if (share <= std::max(worn_ratio * crossing_when_sorted_, least_worn_share)) return;
  std::vector<std::uint32_t> sorted = order_in_space(dimension);
  crossing_when_sorted_ = share_of(contacts.crossing(sorted), ranks());
  if (share > worn_ratio * crossing_when_sorted_) better_order_ = std::move(sorted);
}

// Of several ranks the first one, which then has all bodies, computes it.
std::vector<std::uint32_t> NeighbourList::order_in_space(int dimension) {
  if (!share_) return spatial_order(bodies_at_search_, dimension);
  send(RowRoutes::to_first(*share_, BodyTiles(bodies_at_search_.size())));
  std::vector<std::uint32_t> sorted(bodies_at_search_.size());
  if (share_->is_first()) sorted = spatial_order(bodies_at_search_, dimension);
  share_->ranks.broadcast(std::as_writable_bytes(std::span(sorted)));
  return sorted;
}

}  // namespace scree
