#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include <scree/packing/packing.hpp>

namespace scree::tool {

// Bodies at one time.
struct ExportedFrame {
  packing::Packing packing;
  std::uint64_t step = 0;
  std::vector<std::string> materials = {};  // of types 1, 2, ...; empty: numbers
};

// Calls use(frame) for the bodies of a state, of one particles_*.vtp, or of a run: of all its snapshots in
// order of time if there are any and `all`, else of its state. Bodies of snapshots have the number of their
// material in place of its name, and no mass. Throws Error if there is nothing of the kind.
void for_each_frame(const std::filesystem::path& source, bool all,
                    const std::function<void(const ExportedFrame&)>& use);

// Row i of (rows, 3) values; 0 without values.
Vec3 vector_at(const std::vector<double>& values, std::size_t i);

}  // namespace scree::tool
