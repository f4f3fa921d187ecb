#pragma once

#include <filesystem>

#include <scree/simulation.hpp>

namespace scree::run {

// Writes the bodies as a packing that [particles] file can read; nothing if a number is not finite.
void write_final_packing(const Simulation& simulation, const std::filesystem::path& path);

}  // namespace scree::run
