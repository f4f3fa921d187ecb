#include "lammps_dump_frames.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include <scree/counted.hpp>

namespace scree::packing {

using files::quote_token;
using files::TextReader;
using files::Token;

namespace {

std::uint64_t distance(std::int64_t a, std::int64_t b) {
  return a > b ? std::uint64_t(a) - std::uint64_t(b) : std::uint64_t(b) - std::uint64_t(a);
}

void require_si(TextReader& reader) {
  const bool found = reader.next();
  const Token unit = reader.trimmed(0, reader.line().size());
  if (found && unit.text == "si") return;
  reader.fail(unit.column, fmt::format("the dump is in units {}", quote_token(unit.text)),
              "write it with units si");
}

}  // namespace

// Units and time precede the timestep, so a frame begins with the first item after the previous atoms or
// entries (of dump local).
std::vector<DumpFrame> find_frames(TextReader& reader) {
  std::vector<DumpFrame> frames;
  bool complete = true;
  while (reader.next()) {
    const bool item = reader.line().starts_with("ITEM:");
    if (reader.line_number() == 1 && !item)
      reader.fail(1, "not a text dump: it does not begin with 'ITEM:'", "give the output of dump custom");
    if (!item) continue;
    if (complete) frames.push_back({reader.position(), 0});
    complete = reader.line().starts_with("ITEM: ATOMS") || reader.line().starts_with("ITEM: ENTRIES");
    if (reader.line().starts_with("ITEM: UNITS")) require_si(reader);
    if (reader.line().starts_with("ITEM: TIMESTEP") && reader.next())
      frames.back().timestep = reader.integer(reader.trimmed(0, reader.line().size()), "timestep");
  }
  if (frames.empty()) reader.fail(1, "the dump is empty", "give the output of dump custom");
  return frames;
}

DumpFrame choose_frame(const std::vector<DumpFrame>& frames, std::optional<std::int64_t> timestep,
                       const TextReader& reader) {
  if (!timestep) return frames.back();
  const auto found = std::find_if(frames.rbegin(), frames.rend(),
                                  [&](const DumpFrame& frame) { return frame.timestep == *timestep; });
  if (found != frames.rend()) return *found;
  const auto nearest =
      std::min_element(frames.begin(), frames.end(), [&](const DumpFrame& a, const DumpFrame& b) {
        return distance(a.timestep, *timestep) < distance(b.timestep, *timestep);
      });
  reader.fail(1, fmt::format("there is no timestep {} in {}", *timestep, counted(frames.size(), "frame")),
              fmt::format("the nearest is {}", nearest->timestep));
}

}  // namespace scree::packing
