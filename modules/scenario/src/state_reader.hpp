#pragma once

#include "material_reader.hpp"

#include <filesystem>
#include <memory>
#include <vector>

#include <scree/branching.hpp>
#include <scree/document/table.hpp>
#include <scree/particles.hpp>

namespace scree::scenario {

// Path of the state that [particles] names: in or below `folder`, the working folder, or one of those in the
// environment variable SCREE_STATE_PATH=DIR:DIR. Throws Error if there is none.
std::filesystem::path find_state(const document::Table& particles, const std::filesystem::path& folder);
// Reads it.
std::shared_ptr<const State> read_state(const document::Table& particles,
                                        const std::filesystem::path& folder);
Branching read_branching(const document::Table& particles);

// Throws Error unless the ids are above 0 and differ.
void check_ids(const std::vector<Body>& bodies);

// Its bodies, with materials of the scenario found by their names.
std::vector<Body> bodies_of(const document::Table& particles, const State& state,
                            const std::vector<Material>& materials);

}  // namespace scree::scenario
