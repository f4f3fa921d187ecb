// Messages between ranks for a packing of any size, of which no body is stored. Tiles are boxes of equal
// density, cut as spatial_order cuts bodies. Each body has partners in all directions at the same distance,
// so that the pairs between two tiles follow from the volume that one shares with the other when it is moved
// by this distance, averaged over directions.
//
// Usage: lattice RANKS BODIES [X Y Z]    bodies of all ranks; edges of the scene, in any unit (a cube)

#include "ranges.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace {

using namespace ranks_model;

// Counted by positions.cpp in the packing of beads-4096, in units in which a body has the volume 1: pairs of
// a body; distance of partners such that 1.65 pairs cross a unit area; bodies of a rank that another one
// reads over the pairs between them, which is 0.50 for a plane, 0.51 to 0.54 for ranks, which have corners.
constexpr double pairs_per_body = 3.14, distance = 1.65 * 2 / pairs_per_body, records_per_load = 0.52;

struct Box {
  std::array<double, 3> low, high;

  double side(int k) const { return high[k] - low[k]; }
};

// A box of the tree of cuts. Children follow each other; a tile has none.
struct Node {
  Box box;
  std::size_t bodies;
  std::size_t child = 0, tile = 0;
};

using Vector = std::array<double, 3>;

// Points on a spiral over the sphere of the distance of partners.
std::vector<Vector> steps_to_partners() {
  constexpr int number = 100;
  std::vector<Vector> steps;
  for (int k = 0; k < number; ++k) {
    const double z = (2 * k + 1.0) / number - 1, angle = std::numbers::pi * (3 - std::sqrt(5.0)) * k;
    const double radius = std::sqrt(1 - z * z);
    steps.push_back({distance * radius * std::cos(angle), distance * radius * std::sin(angle), distance * z});
  }
  return steps;
}

// Expected number of partners in b of the bodies in a.
double partners(const Box& a, const Box& b) {
  static const std::vector<Vector> steps = steps_to_partners();
  double sum = 0;
  for (const Vector& step : steps) {
    double volume = 1;
    for (int k = 0; k < 3; ++k)
      volume *=
          std::max(0.0, std::min(a.high[k], b.high[k] - step[k]) - std::max(a.low[k], b.low[k] - step[k]));
    sum += volume;
  }
  return 2 * pairs_per_body * sum / double(steps.size());
}

class Lattice {
 public:
  Lattice(std::size_t bodies, const Box& scene) : tiles_(tile_count(bodies)), pairs_(tiles_.size()) {
    nodes_.push_back({scene, bodies});
    std::size_t next = 0;
    cut(0, next);
    within(0);
  }

  const std::vector<Tile>& tiles() const { return tiles_; }

  Halos halos(const std::vector<std::size_t>& rank, std::size_t ranks) const {
    Halos result(ranks);
    for (std::size_t low = 0; low < tiles_.size(); ++low)
      for (const auto& [high, pairs] : pairs_[low]) {
        if (rank[low] == rank[high]) continue;
        Halo& halo = result[rank[low]][rank[high]];
        halo.records += pairs * records_per_load;
        halo.loads += pairs;
      }
    return result;
  }

 private:
  // Numbers the tiles of a node in order, from `next` on.
  void cut(std::size_t node, std::size_t& next) {
    const std::size_t bodies = nodes_[node].bodies, tiles = tile_count(bodies);
    if (tiles == 1) {
      nodes_[node].tile = next;
      tiles_[next++].bodies = double(bodies);
      return;
    }
    Node below{nodes_[node].box, tiles / 2 * tile_size}, above{nodes_[node].box, bodies - below.bodies};
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (below.box.side(k) > below.box.side(axis)) axis = k;
    const double at = below.box.low[axis] + below.box.side(axis) * double(below.bodies) / double(bodies);
    below.box.high[axis] = above.box.low[axis] = at;
    const std::size_t child = nodes_[node].child = nodes_.size();
    nodes_.push_back(below), nodes_.push_back(above);
    cut(child, next), cut(child + 1, next);
  }

  // Pairs of all tiles of a node.
  void within(std::size_t node) {
    const auto [box, bodies, child, tile] = nodes_[node];
    if (!child) {
      tiles_[tile].inner = partners(box, box) / 2;
      return;
    }
    within(child), within(child + 1);
    between(child, child + 1);
  }

  // Pairs between the tiles of two nodes, the tiles of the first before those of the second.
  void between(std::size_t a, std::size_t b) {
    const Node &low = nodes_[a], &high = nodes_[b];
    for (int k = 0; k < 3; ++k)
      if (std::max(low.box.low[k], high.box.low[k]) - std::min(low.box.high[k], high.box.high[k]) > distance)
        return;
    if (!low.child && !high.child) {
      const double pairs = partners(low.box, high.box);
      if (pairs < 0.5) return;
      pairs_[low.tile].push_back({high.tile, pairs});
      tiles_[low.tile].cross += pairs;
    } else if (low.child && (!high.child || low.bodies >= high.bodies)) {
      between(low.child, b), between(low.child + 1, b);
    } else {
      between(a, high.child), between(a, high.child + 1);
    }
  }

  std::vector<Node> nodes_;
  std::vector<Tile> tiles_;
  std::vector<std::vector<std::pair<std::size_t, double>>>
      pairs_;  // of each tile, with tiles of higher place
};

}  // namespace

int main(int count, char** words) {
  if (count != 3 && count != 6) {
    std::fputs("usage: lattice RANKS BODIES [X Y Z]\n", stderr);
    return 2;
  }
  const auto ranks = std::size_t(std::atof(words[1])), bodies = std::size_t(std::atof(words[2]));
  Box scene{{0, 0, 0}, {1, 1, 1}};
  for (int k = 0; count == 6 && k < 3; ++k) scene.high[k] = std::atof(words[3 + k]);
  const double scale = std::cbrt(double(bodies) / (scene.high[0] * scene.high[1] * scene.high[2]));
  for (double& edge : scene.high) edge *= scale;  // a body has the volume 1
  const Lattice lattice(bodies, scene);
  const std::vector<std::size_t> rank = rank_of_tiles(lattice.tiles(), ranks);
  print(lattice.tiles(), rank, lattice.halos(rank, ranks));
}
