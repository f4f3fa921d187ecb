#pragma once

#include <cstdint>
#include <vector>

namespace scree {

// The tiles of a scene, and the pairs of bodies between them.
struct TileGraph {
  // Pairs whose bodies are in two tiles, of which `tile` has the lower number.
  struct Edge {
    std::uint32_t tile, other, pairs;
  };

  std::vector<double> work;  // of each tile, at least 0, in any unit
  std::vector<Edge> edges;   // sorted by tile, then other; each once
};

}  // namespace scree
