#pragma once

#include "material_reader.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include <scree/branching.hpp>
#include <scree/document/table.hpp>
#include <scree/domain.hpp>
#include <scree/particles.hpp>

namespace scree::scenario {

struct ReadBodies {
  std::vector<Body> bodies;
  Domain box;                                    // of the file of bodies; not periodic without one
  std::shared_ptr<const State> state = nullptr;  // in which they were; null for a new packing
  Branching branching = {};
};

// Reads the bodies of [particles] (a lattice or a file) and of [[particle]], with mass and inertia: spheres
// in 3D (I = 2mR²/5), discs of unit thickness in 2D (I = mR²/2). File names are relative to `folder`. Throws
// Error if there is no body.
ReadBodies read_bodies(const document::Table& root, int dimension, const std::vector<Material>& materials,
                       std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace scree::scenario
