#pragma once

#include "text_reader.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace scree::packing {

// One snapshot of a dump: where its first ITEM line stands and which timestep it names.
struct DumpFrame {
  TextReader::Position start;
  std::int64_t timestep = 0;
};

// All frames in file order, found by their ITEM lines. Fails if the text is no dump, or not in SI units.
std::vector<DumpFrame> find_frames(TextReader& reader);

// Last frame, or the last one of that timestep. Fails naming the nearest timestep if there is none.
DumpFrame choose_frame(const std::vector<DumpFrame>& frames, std::optional<std::int64_t> timestep,
                       const TextReader& reader);

}  // namespace scree::packing
