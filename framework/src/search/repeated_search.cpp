#include "search/repeated_search.hpp"

#include "bodies/folding.hpp"
#include "machine/instruction_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

// Candidates per pair that the margin aims at. With 1.2 or 3 searches of drifting beads take longer.
constexpr double fewest_candidates = 1.4, most_candidates = 1.8;
constexpr double first_margin = 4, smallest_margin = 1, largest_margin = 32;  // in skins

// Largest coordinate (m) and radius (m).
struct Largest {
  double coordinate = 0, radius = 0;
  explicit Largest(std::span<const Sphere> bodies) {
    for (const Sphere& body : bodies) {
      for (int k = 0; k < 3; ++k) coordinate = std::max(coordinate, std::abs(body.position[k]));
      radius = std::max(radius, body.radius);
    }
  }
};

// Largest margin (m) at which no pair of candidates has two images.
double margin_limit(const Domain& domain, int dimension, double reach) {
  double limit = std::numeric_limits<double>::infinity();
  for (int k = 0; k < dimension; ++k)
    if (domain.periodic[k]) limit = std::min(limit, 0.499 * domain.length(k) - reach);
  return limit;
}

// Copies the pairs [begin, end) that are nearer than their reach to `out`, with the images in which they are;
// returns the end of the copy. Branch-free, as branches on distances would be mispredicted.
template <bool periodic>
[[gnu::always_inline]] inline NeighbourPair* copy_near(const NeighbourPair* begin, const NeighbourPair* end,
                                                       const Sphere* bodies, const Folding& folding,
                                                       double skin, NeighbourPair* out) {
  for (const NeighbourPair* pair = begin; pair < end; ++pair) {
    const Sphere &a = bodies[pair->a], &b = bodies[pair->b];
    Vec3 d = a.position - b.position;
    const double square = periodic ? folding.square_distance(d) : Folding::square(d);
    const double reach = a.radius + b.radius + skin;
    const int image = periodic ? folding.fold(d) : int(Domain::no_shift);
    *out = {pair->a, pair->b, std::uint8_t(image)};
    out += square < reach * reach ? 1 : 0;
  }
  return out;
}

SCREE_EVERY_LEVEL NeighbourPair* copy_near(const NeighbourPair* begin, const NeighbourPair* end,
                                           const Sphere* bodies, const Domain& domain, double skin,
                                           NeighbourPair* out) {
  const Folding folding(domain);
  return domain.any_periodic() ? copy_near<true>(begin, end, bodies, folding, skin, out)
                               : copy_near<false>(begin, end, bodies, folding, skin, out);
}

}  // namespace

const std::vector<NeighbourPair>& RepeatedSearch::find(std::span<const Sphere> bodies, int dimension,
                                                       const Domain& domain, double skin, double moved,
                                                       ThreadPool& threads, double complete) {
  covered_ -= 2 * moved;
  const bool search = !(skin < covered_);
  if (search) find_candidates(bodies, dimension, domain, skin, complete, threads);
  const bool all = !(skin < covered_);  // without a margin
  if (!all) select(bodies, domain, skin, threads);
  if (search && !all) adapt_margin();
  const std::vector<NeighbourPair>& pairs = all ? *candidates_ : selected_;
  found_last_ = pairs.size();
  return pairs;
}

void RepeatedSearch::find_candidates(std::span<const Sphere> bodies, int dimension, const Domain& domain,
                                     double skin, double complete, ThreadPool& threads) {
  const Largest largest(bodies);
  // Bodies are folded, and their displacements measured, with rounded coordinates.
  const double round_off = 1e3 * std::numeric_limits<double>::epsilon() * largest.coordinate;
  const double limit = margin_limit(domain, dimension, 2 * largest.radius + skin);
  double margin = std::min({margin_per_skin_ * skin, limit, complete - skin});
  if (margin < std::max(smallest_margin * skin, 2 * round_off) || found_last_ > search_.most_pairs() / 8)
    margin = 0;
  covered_ = 0;  // also after an error
  candidates_ = &search_.find(bodies, dimension, domain, skin + margin, threads);
  ++grid_searches_;
  if (margin_per_skin_ == 0) margin_per_skin_ = first_margin;
  if (margin > 0) covered_ = skin + margin - round_off;
}

void RepeatedSearch::select(std::span<const Sphere> bodies, const Domain& domain, double skin,
                            ThreadPool& threads) {
  constexpr std::size_t share = 8192;
  const std::size_t count = candidates_->size();
  const NeighbourPair* const from = candidates_->data();
  selected_.resize(count);
  ends_.resize((count + share - 1) / share);
  threads.each(ends_.size(), [&](std::size_t k, unsigned) {
    const std::size_t begin = k * share, end = std::min(begin + share, count);
    ends_[k] = copy_near(from + begin, from + end, bodies.data(), domain, skin, selected_.data() + begin);
  });
  NeighbourPair* end = selected_.data();
  for (std::size_t k = 0; k < ends_.size(); ++k) end = std::copy(selected_.data() + k * share, ends_[k], end);
  selected_.resize(std::size_t(end - selected_.data()));
}

void RepeatedSearch::adapt_margin() {
  const double found = double(candidates_->size()), selected = double(selected_.size());
  if (found > most_candidates * selected) margin_per_skin_ *= 0.7;
  if (found < fewest_candidates * selected) margin_per_skin_ *= 1.4;
  margin_per_skin_ = std::clamp(margin_per_skin_, smallest_margin, largest_margin);
}

}  // namespace scree
