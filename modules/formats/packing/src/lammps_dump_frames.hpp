#pragma once

#include "text_reader.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace scree::packing {

// One frame of a dump: position of its first ITEM line, and its timestep.
struct DumpFrame {
  TextReader::Position start;
  std::int64_t timestep = 0;
};

// All frames in file order, found by their ITEM lines. Fails if the text is not a dump in SI units.
std::vector<DumpFrame> find_frames(TextReader& reader);

// The last frame, or the last one with this timestep. Fails, naming the nearest timestep, if there is none.
DumpFrame choose_frame(const std::vector<DumpFrame>& frames, std::optional<std::int64_t> timestep,
                       const TextReader& reader);

}  // namespace scree::packing
