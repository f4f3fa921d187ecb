#pragma once

#include <cstdint>
#include <vector>

#include <scree/tile_graph.hpp>

namespace scree::ranks {

// The rank of each tile, as METIS divides the graph among `ranks` of them; nothing if it fails.
std::vector<std::uint32_t> metis_partition(const TileGraph& graph, unsigned ranks);

}  // namespace scree::ranks
