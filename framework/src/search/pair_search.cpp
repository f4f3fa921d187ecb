#include "bodies/body_range.hpp"
#include "bodies/counting_sort.hpp"
#include "bodies/folding.hpp"
#include "machine/instruction_levels.hpp"
#include "search/cell_level.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include <scree/available_memory.hpp>
#include <scree/error.hpp>
#include <scree/pair_search.hpp>

namespace scree {

namespace {

constexpr std::size_t max_levels = 16;

// Largest memory (bytes) per pair in search, contacts, history and loads; and the limit of their indices.
constexpr double memory_per_pair = 200;
constexpr double most_indices = 0x1p31;

Error too_many_pairs(std::size_t most, double skin) {
  return Error(
      fmt::format("there are more than {:.2g} pairs of bodies nearer than the skin of {:g} m, as many as "
                  "fit into {:.3g} GB of memory; place the bodies apart, or give a smaller neighbours.skin",
                  double(most), skin, 1e-9 * available_memory()),
      ExitStatus::failure);
}

// Level 0 holds the largest bodies; each further level half the size.
std::size_t level_of(double radius, double largest) {
  if (2 * radius > largest) return 0;
  return std::min(std::size_t(std::ilogb(largest / radius)), max_levels - 1);
}

void check_periodic_lengths(const Domain& domain, int dimension, double reach) {
  for (int k = 0; k < dimension; ++k)
    if (domain.periodic[k] && domain.length(k) < 2 * reach)
      throw Error(fmt::format(
          "the periodic length {:g} m along {} is under twice the reach of the largest pair, {:g} m; "
          "give a length of at least {:g} m or a smaller skin",
          domain.length(k), "xyz"[k], reach, 2 * reach * (1 + 1e-5)));
}

// A body that is alone has no pairs, but must not touch itself.
void check_own_images(const Domain& domain, int dimension, double radius) {
  for (int k = 0; k < dimension; ++k)
    if (domain.periodic[k] && !(domain.length(k) >= 2 * radius))
      throw Error(fmt::format(
          "the periodic length {:g} m along {} is under the diameter of the body, {:g} m, which would touch itself; "
          "give a length of at least that",
          domain.length(k), "xyz"[k], 2 * radius));
}

struct Extent {
  Vec3 lower, upper;   // of centres (m)
  double largest = 0;  // radius (m)

  explicit Extent(std::span<const Sphere> bodies) : lower(bodies[0].position), upper(lower) {
    for (const Sphere& body : bodies) {
      for (int k = 0; k < 3; ++k) {
        lower[k] = std::min(lower[k], body.position[k]);
        upper[k] = std::max(upper[k], body.position[k]);
      }
      largest = std::max(largest, body.radius);
    }
  }
};

// Sorts the pairs of one a by b: usually few, for which insertion sort is fastest.
void sort_run(NeighbourPair* begin, NeighbourPair* end) {
  const auto before = [](const NeighbourPair& p, const NeighbourPair& q) { return p.b < q.b; };
  if (end - begin > 16) return std::sort(begin, end, before);
  for (NeighbourPair* next = begin + 1; next < end; ++next)
    for (NeighbourPair* p = next; p > begin && before(*p, *(p - 1)); --p) std::swap(*p, *(p - 1));
}

// Appends the neighbours of one body after the other to a list of pairs. Branch-free filter, since branches
// on distances would be mispredicted: every candidate is stored, but the write index advances only for those
// within reach.
class PairCollector {
 public:
  PairCollector(std::vector<NeighbourPair>& pairs, const Folding& folding, double skin)
      : pairs_(pairs), folding_(folding), skin_(skin) {
    clear();
  }

  void clear() { pairs_.clear(); }

  std::size_t size() const { return pairs_.size(); }

  // Adds the binned bodies [begin, end) to the candidates.
  void add_candidates(std::size_t begin, std::size_t end) {
    typedef std::uint32_t Run __attribute__((vector_size(32)));  // usually all bodies of three cells
    constexpr std::size_t usual = sizeof(Run) / sizeof(std::uint32_t);
    const std::size_t length = end > begin ? end - begin : 0;
    if (candidates_.size() < count_ + length + usual) candidates_.resize(2 * (count_ + length + usual));
    Run run = std::uint32_t(begin) + Run{0, 1, 2, 3, 4, 5, 6, 7};
    for (std::size_t done = 0;;) {
      std::memcpy(candidates_.data() + count_ + done, &run, sizeof(run));
      if ((done += usual) >= length) break;
      run += std::uint32_t(usual);
    }
    count_ += length;
  }
  // Appends pairs of `body` with the candidates within reach, and clears the candidates.
  template <bool across>
  void append(const CellLevel::BinnedBody& body, const CellLevel::BinnedBody* others) {
    std::uint32_t* near = candidates_.data();
    for (std::size_t k = 0; k < count_; ++k) {
      const std::uint32_t candidate = candidates_[k];
      const CellLevel::BinnedBody& other = others[candidate];
      const Vec3 d = body.position - other.position;
      const double square = across ? folding_.square_distance(d) : Folding::square(d);
      const double reach = body.radius + other.radius + skin_;  // the same whichever body comes first
      *near = candidate;
      near += square < reach * reach ? 1 : 0;
    }
    for (const std::uint32_t* k = candidates_.data(); k != near; ++k) {
      const CellLevel::BinnedBody& other = others[*k];
      Vec3 d = body.position - other.position;
      const int code = across ? folding_.fold(d) : Domain::no_shift;
      const bool first = body.body < other.body;
      pairs_.push_back({first ? body.body : other.body, first ? other.body : body.body,
                        std::uint8_t(first ? code : 2 * Domain::no_shift - code)});
    }
    count_ = 0;
  }

 private:
  std::vector<NeighbourPair>& pairs_;
  std::vector<std::uint32_t> candidates_;
  std::size_t count_ = 0;
  Folding folding_;
  double skin_;
};

}  // namespace

struct PairSearch::Hierarchy {
  std::array<std::vector<std::uint32_t>, max_levels> members;
  std::array<CellLevel, max_levels> levels;

  // Finds the pairs of the binned bodies [begin, end) of a level with all bodies of coarser levels, and with
  // those behind them in their own level. Ends early beyond `most` pairs.
  void find(std::size_t level, std::size_t begin, std::size_t end, std::size_t most,
            PairCollector& pairs) const;
};

SCREE_EVERY_LEVEL_INLINED void PairSearch::Hierarchy::find(std::size_t level, std::size_t begin,
                                                           std::size_t end, std::size_t most,
                                                           PairCollector& pairs) const {
  for (std::size_t k = begin; k < end && pairs.size() <= most; ++k) {
    const CellLevel::BinnedBody& body = levels[level].binned()[k];
    for (std::size_t l = 0; l <= level; ++l) {
      if (members[l].empty()) continue;
      const std::size_t behind = l == level ? k + 1 : 0;
      const CellLevel::Surroundings around = levels[l].around(body.position);
      levels[l].each_run(around, [&](std::size_t first, std::size_t last) {
        pairs.add_candidates(std::max(first, behind), last);
      });
      const CellLevel::BinnedBody* others = levels[l].binned().data();
      around.across ? pairs.append<true>(body, others) : pairs.append<false>(body, others);
    }
  }
}

PairSearch::PairSearch(Images images, std::size_t most_pairs)
    : images_(images),
      most_pairs_(most_pairs > 0 ? most_pairs
                                 : std::size_t(std::min(most_indices, available_memory() / memory_per_pair))),
      hierarchy_(std::make_unique<Hierarchy>()) {}
PairSearch::~PairSearch() = default;

void PairSearch::bin_bodies(std::span<const Sphere> bodies, int dimension, const Domain& domain,
                            double skin) {
  const Extent extent(bodies);
  const double largest = extent.largest;
  if (images_ == Images::unique) check_periodic_lengths(domain, dimension, 2 * largest + skin);
  Vec3 lower = extent.lower, upper = extent.upper;
  double farthest = 0;
  for (int k = 0; k < dimension; ++k) {
    farthest = std::max({farthest, std::abs(lower[k]), std::abs(upper[k])});
    if (domain.periodic[k]) lower[k] = domain.lower[k], upper[k] = domain.upper[k];
  }
  // Large coordinates are rounded, and so are their cell indices.
  const double round_off = 8 * std::numeric_limits<double>::epsilon() * farthest;
  for (auto& members : hierarchy_->members) members.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    hierarchy_->members[level_of(bodies[i].radius, largest)].push_back(std::uint32_t(i));
  for (std::size_t l = 0; l < max_levels; ++l)
    if (const auto& members = hierarchy_->members[l]; !members.empty())
      hierarchy_->levels[l].bin(bodies, dimension, domain, lower, upper,
                                (2 * std::ldexp(largest, -int(l)) + skin) * (1 + 1e-12) + round_off, members);
}

// Sorts by a with a counting sort, then each short run by b.
void PairSearch::sort_pairs(std::size_t bodies, ThreadPool& threads) {
  std::size_t count = 0;
  for (const auto& pairs : found_) count += pairs.size();
  sorted_.resize(count);
  if (count == 0) return;
  counting_sort(
      bodies, first_,
      [&](const auto& visit) {
        for (const auto& pairs : found_)
          for (const NeighbourPair& p : pairs) visit(p);
      },
      [](const NeighbourPair& p) { return p.a; },
      [&](const NeighbourPair& p, std::size_t index) { sorted_[index] = p; });
  const BodyTiles tiles(bodies);
  threads.each(tiles.count(), [&](std::size_t t, unsigned) {
    for (std::size_t i = tiles[t].begin; i < tiles[t].end; ++i)
      sort_run(sorted_.data() + first_[i], sorted_.data() + first_[i + 1]);
  });
}

const std::vector<NeighbourPair>& PairSearch::find(std::span<const Sphere> bodies, int dimension,
                                                   const Domain& domain, double skin, ThreadPool& threads) {
  sorted_.clear();
  if (bodies.size() == 1 && images_ == Images::unique) check_own_images(domain, dimension, bodies[0].radius);
  if (bodies.size() < 2) return sorted_;
  bin_bodies(bodies, dimension, domain, skin);
  collect_pairs(domain, skin, threads);
  sort_pairs(bodies.size(), threads);
  return sorted_;
}

void PairSearch::visit(std::span<const Sphere> bodies, int dimension, const Domain& domain, double skin,
                       const std::function<bool(const NeighbourPair&)>& use) {
  if (bodies.size() < 2) return;
  bin_bodies(bodies, dimension, domain, skin);
  std::vector<NeighbourPair> found;
  PairCollector pairs(found, Folding(domain), skin);
  for (std::size_t level = 0; level < max_levels; ++level)
    for (std::size_t k = 0; k < hierarchy_->members[level].size(); ++k) {
      pairs.clear();
      hierarchy_->find(level, k, k + 1, bodies.size(), pairs);
      for (const NeighbourPair& pair : found)
        if (!use(pair)) return;
    }
}

void PairSearch::collect_pairs(const Domain& domain, double skin, ThreadPool& threads) {
  constexpr std::size_t share = 2048;
  struct Share {
    std::size_t level, begin, end;
  };
  std::vector<Share> shares;
  for (std::size_t l = 0; l < max_levels; ++l)
    for (std::size_t begin = 0, end = hierarchy_->members[l].size(); begin < end; begin += share)
      shares.push_back({l, begin, std::min(begin + share, end)});
  found_.resize(shares.size());
  std::atomic<std::size_t> all = 0;
  threads.each(shares.size(), [&](std::size_t k, unsigned) {
    const Share& s = shares[k];
    PairCollector pairs(found_[k], Folding(domain), skin);
    hierarchy_->find(s.level, s.begin, s.end, most_pairs_ - std::min(most_pairs_, all.load()), pairs);
    if (all.fetch_add(pairs.size()) + pairs.size() > most_pairs_) throw too_many_pairs(most_pairs_, skin);
  });
}

}  // namespace scree
