#pragma once

#include "bodies/candidate_pairs.hpp"
#include "bodies/folding.hpp"
#include <scree/thread_pool.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace scree {

// Input of a search: a body as a sphere; in 2D z is 0.
struct Sphere {
  Vec3 position;  // (m)
  double radius;  // (m)
};

// Neighbour search with a hierarchy of cell grids: each body is binned in the level of its size and paired
// with bodies of its own and coarser levels, so that a size ratio of 1:100 costs no more than 1:2. Memory is
// reused by the next search.
class NeighbourSearch {
 public:
  // most_pairs: 0 for as many as fit into memory.
  explicit NeighbourSearch(std::size_t most_pairs = 0);
  ~NeighbourSearch();

  // All pairs with |x_a − x_b| < R_a + R_b + skin, sorted by a, then b. Positions must lie in the domain.
  // Throws Error if a periodic length is under twice the largest reach, where images would be ambiguous, and
  // Error(failure) if there are more pairs than allowed.
  const std::vector<NeighbourPair>& find(std::span<const Sphere> bodies, int dimension, const Domain& domain,
                                         double skin, ThreadPool& threads);

 private:
  struct Hierarchy;
  void collect_pairs(const Domain& domain, double skin, ThreadPool& threads);
  void bin_bodies(std::span<const Sphere> bodies, int dimension, const Domain& domain, double skin);
  void sort_pairs(std::size_t bodies);

  std::size_t most_pairs_;
  std::unique_ptr<Hierarchy> hierarchy_;
  std::vector<std::vector<NeighbourPair>> found_;  // by each task, a share of the bodies
  std::vector<std::uint32_t> first_;               // first pair of each a
  std::vector<NeighbourPair> sorted_;
};

}  // namespace scree
