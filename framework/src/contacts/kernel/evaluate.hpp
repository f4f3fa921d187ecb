#pragma once

#include "contacts/forces.hpp"
#include "contacts/kernel/tiles.hpp"

namespace scree::kernel {

struct EvaluationInput;

// Pairs of a tile: all, pairs inside it, or pairs with bodies of other tiles, which follow the others.
enum class TilePairs { all, inside, crossing };

// Input and output of the evaluation of one tile.
struct TileJob {
  const EvaluationInput* input;
  const Tiles* tiles;
  std::size_t tile;
  TilePairs pairs;
  std::vector<PairGroup>* groups;
  const LawInstance* laws;
  PairConstants* constants;
  double* slots;      // (slots, load width) loads
  ContactSums* sums;  // of each tile
  Profile* profile;   // null: not measured
};

// Evaluates pairs of a tile: gather -> geometry -> law -> scatter, in blocks.
using EvaluateTile = void (*)(const TileJob&);

// The evaluation for the features of a scene, compiled for the best instruction level that the processor
// supports, or for the one that SCREE_LEVEL selects. All levels give the same bits. Throws Error if the
// processor supports no level of this build.
EvaluateTile tile_evaluation(const Forces::Features& features);

// The same for the instruction level x86-64-v<level>, where that is built; 1 is the baseline.
template <int level>
EvaluateTile tile_evaluation_at(const Forces::Features& features);

}  // namespace scree::kernel
