#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <scree/files/text_reader.hpp>

namespace scree::packing {

// One frame of a dump: position of its first ITEM line, and its timestep.
struct DumpFrame {
  files::TextReader::Position start;
  std::int64_t timestep = 0;
};

// All frames in file order, found by their ITEM lines. Fails if the text is not a dump in SI units.
std::vector<DumpFrame> find_frames(files::TextReader& reader);

// The last frame, or the last one with this timestep. Fails, naming the nearest timestep, if there is none.
DumpFrame choose_frame(const std::vector<DumpFrame>& frames, std::optional<std::int64_t> timestep,
                       const files::TextReader& reader);

}  // namespace scree::packing
