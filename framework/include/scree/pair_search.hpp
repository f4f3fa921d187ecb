#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <scree/domain.hpp>
#include <scree/plugin/vec.hpp>
#include <scree/thread_pool.hpp>

namespace scree {

// Input of a search: a body as a sphere; in 2D z is 0.
struct Sphere {
  Vec3 position;  // (m)
  double radius;  // (m)
};

// Two bodies whose surfaces are nearer than the skin; a < b.
struct NeighbourPair {
  std::uint32_t a, b;
  std::uint8_t image;  // code of the nearest image: Domain::shift(image) is added to x_a − x_b
  friend bool operator==(const NeighbourPair&, const NeighbourPair&) = default;
};

// Finds pairs of bodies with a hierarchy of cell grids: each body is binned in the level of its size and
// paired with bodies of its own and coarser levels, so that a size ratio of 1:100 costs no more than 1:2.
// Memory is reused by the next search.
class PairSearch {
 public:
  // Images of a pair in a periodic domain: `unique` refuses lengths under twice the largest reach, where a
  // pair could touch through two images; with `nearest` any length will do, and only the nearest image is
  // seen.
  enum class Images { unique, nearest };

  // most_pairs: 0 for as many as fit into memory.
  explicit PairSearch(Images images = Images::unique, std::size_t most_pairs = 0);
  ~PairSearch();

  std::size_t most_pairs() const { return most_pairs_; }

  // All pairs with |x_a − x_b| < R_a + R_b + skin, sorted by a, then b. Positions must lie in the domain.
  // Throws Error for lengths that `images` refuses, and Error(failure) if there are more pairs than allowed.
  const std::vector<NeighbourPair>& find(std::span<const Sphere> bodies, int dimension, const Domain& domain,
                                         double skin, ThreadPool& threads);
  // Calls use() with each of these pairs, in no particular order, until it returns false. Stores no pairs.
  void visit(std::span<const Sphere> bodies, int dimension, const Domain& domain, double skin,
             const std::function<bool(const NeighbourPair&)>& use);

 private:
  struct Hierarchy;
  void collect_pairs(const Domain& domain, double skin, ThreadPool& threads);
  void bin_bodies(std::span<const Sphere> bodies, int dimension, const Domain& domain, double skin);
  void sort_pairs(std::size_t bodies, ThreadPool& threads);

  Images images_;
  std::size_t most_pairs_;
  std::unique_ptr<Hierarchy> hierarchy_;
  std::vector<std::vector<NeighbourPair>> found_;  // by each task, a share of the bodies
  std::vector<std::uint32_t> first_;               // first pair of each a
  std::vector<NeighbourPair> sorted_;
};

}  // namespace scree
