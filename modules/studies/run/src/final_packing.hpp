#pragma once

#include <filesystem>

#include <scree/simulation.hpp>

namespace scree::run {

// Writes the bodies as a packing for the key `file` of [particles]; writes nothing if a value is not finite.
void write_final_packing(const Simulation& simulation, const std::filesystem::path& path);

}  // namespace scree::run
