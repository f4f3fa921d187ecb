#include "cell_level.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/neighbours.hpp>

namespace scree {

namespace {

constexpr int most_levels = 16;

// Level 0 holds the largest bodies; each further level half the size.
int level_of(double radius, double largest) {
  return std::min(int(std::floor(std::log2(largest / radius))), most_levels - 1);
}

struct Hierarchy {
  std::vector<int> level;                        // of each body
  std::vector<std::optional<CellLevel>> levels;  // empty where no body is
};

void check_periodic_lengths(const Domain& domain, int dimension, double reach) {
  for (int k = 0; k < dimension; ++k)
    if (domain.periodic[k] && domain.length(k) < 2 * reach)
      throw Error(fmt::format(
          "the periodic length {:g} m along {} is under twice the reach of the largest pair, {:g} m; "
          "give a length of at least {:g} m or a smaller skin",
          domain.length(k), "xyz"[k], reach, 2 * reach));
}

// What the cells along an axis span. Bodies outside are filed in the outermost cells, so a few that are far
// out need not make all cells wide: beyond a quarter of the middle 98 % on either side they are left outside.
std::pair<double, double> cell_span(const Strided<const double>& x) {
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  constexpr std::size_t most_samples = 1000;
  std::vector<double> sample;
  for (std::size_t i = 0; i < x.size(); i += 1 + x.size() / most_samples) sample.push_back(x[i]);
  std::sort(sample.begin(), sample.end());
  const std::size_t tail = sample.size() / 100 + (sample.size() >= 20 ? 1 : 0);
  const double from = sample[tail], to = sample[sample.size() - 1 - tail], margin = 0.25 * (to - from);
  return {std::max(*low, from - margin), std::min(*high, to + margin)};
}

Hierarchy build_hierarchy(const Particles& particles, const Domain& domain, double skin) {
  const std::size_t n = particles.size();
  const double largest = *std::max_element(particles.radius().begin(), particles.radius().end());
  check_periodic_lengths(domain, particles.dimension(), 2 * largest + skin);

  Vec3 lower = {}, upper = {};
  for (int k = 0; k < particles.dimension(); ++k) {
    const auto [low, high] = cell_span(particles.position()[k]);
    lower[k] = domain.periodic[k] ? domain.lower[k] : low;
    upper[k] = domain.periodic[k] ? domain.upper[k] : high;
  }
  Hierarchy h;
  h.level.resize(n);
  std::vector<std::vector<std::uint32_t>> members(most_levels);
  for (std::size_t i = 0; i < n; ++i) {
    h.level[i] = level_of(particles.radius()[i], largest);
    members[h.level[i]].push_back(std::uint32_t(i));
  }
  h.levels.resize(most_levels);
  for (int l = 0; l < most_levels; ++l)
    if (!members[l].empty())
      h.levels[l].emplace(particles, domain, lower, upper, (2 * std::ldexp(largest, -l) + skin) * (1 + 1e-12),
                          members[l]);
  return h;
}

// Sorted by a, then b: a counting sort by a, then each short run by b.
std::vector<NeighbourPair> sort_pairs(const std::vector<NeighbourPair>& pairs, std::size_t bodies) {
  std::vector<std::size_t> first(bodies + 1, 0);
  for (const NeighbourPair& p : pairs) ++first[p.a + 1];
  for (std::size_t i = 0; i < bodies; ++i) first[i + 1] += first[i];
  std::vector<NeighbourPair> sorted(pairs.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const NeighbourPair& p : pairs) sorted[next[p.a]++] = p;
  for (std::size_t i = 0; i < bodies; ++i)
    std::sort(sorted.begin() + std::ptrdiff_t(first[i]), sorted.begin() + std::ptrdiff_t(first[i + 1]),
              [](const NeighbourPair& p, const NeighbourPair& q) { return p.b < q.b; });
  return sorted;
}

}  // namespace

std::vector<NeighbourPair> find_neighbours(const Particles& particles, const Domain& domain, double skin) {
  std::vector<NeighbourPair> pairs;
  const std::size_t n = particles.size();
  if (n < 2) return pairs;
  const Hierarchy h = build_hierarchy(particles, domain, skin);
  const bool periodic = domain.any_periodic();
  const auto position = [&](std::size_t i) {
    Vec3 x = {};
    for (int k = 0; k < particles.dimension(); ++k) x[k] = particles.position()[k][i];
    return x;
  };

  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec3 x = position(i);
    const double reach_of_i = particles.radius()[i] + skin;
    for (int l = 0; l <= h.level[i]; ++l) {
      if (!h.levels[l]) continue;
      h.levels[l]->near(x, [&](const CellLevel::Filed& other) {
        const std::uint32_t j = other.body;
        if (j == i || (l == h.level[i] && j < i)) return;
        Vec3 d = i < j ? x - other.position : other.position - x;
        const std::uint8_t image = periodic ? domain.fold(d) : Domain::no_shift;
        const double reach = reach_of_i + other.radius;
        if (dot(d, d) < reach * reach) pairs.push_back({std::min(i, j), std::max(i, j), image});
      });
    }
  }
  return sort_pairs(pairs, n);
}

}  // namespace scree
