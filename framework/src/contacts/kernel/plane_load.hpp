#pragma once

#include "contacts/forces.hpp"

#include <scree/plugin/abi.h>

namespace scree::kernel {

struct TileJob;

// Evaluates the pairs of a tile, which are with one plane, and writes their force on it (N); changes
// histories, and nothing else. Needs neither tiles nor slots.
using EvaluatePlaneLoad = void (*)(const TileJob&, scree_load& load);

// As tile_evaluation.
EvaluatePlaneLoad plane_load_evaluation(const Forces::Features& features);

// As tile_evaluation_at.
template <int level>
EvaluatePlaneLoad plane_load_evaluation_at(const Forces::Features& features);

}  // namespace scree::kernel
