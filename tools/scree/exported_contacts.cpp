#include "exported_contacts.hpp"

#include "exported_frames.hpp"
#include "support/last_state.hpp"
#include "support/snapshot_files.hpp"

#include <scree/error.hpp>
#include <scree/pictures/load_backend.hpp>
#include <scree/run/evaluated_state.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

packing::ContactTable table_of(const pictures::Frame& frame) {
  packing::ContactTable table;
  table.dimension = frame.dimension;
  table.time = frame.time;
  for (const pictures::Wall& wall : frame.walls) table.walls.push_back(wall.name);
  for (const pictures::Surface& surface : frame.surfaces) table.walls.push_back(surface.name);
  for (std::size_t c = 0; c < frame.contact_count(); ++c)
    table.contacts.push_back({.a = frame.contact_a[c],
                              .b = frame.contact_b[c],
                              .wall = frame.contact_wall[c],
                              .normal = vector_at(frame.contact_normal, c),
                              .force = vector_at(frame.contact_force, c),
                              .overlap = frame.contact_overlap[c],
                              .sliding = frame.contact_sliding[c] != 0,
                              .point = vector_at(frame.contact_point, c)});
  return table;
}

// Throws Error if the file is of an earlier version, or not of a run.
void check_columns(const pictures::Frame& frame, const fs::path& file) {
  const std::size_t c = frame.contact_count();
  const bool whole = frame.contact_a.size() == c && frame.contact_b.size() == c &&
                     frame.contact_wall.size() == c && frame.contact_sliding.size() == c &&
                     frame.contact_overlap.size() == c && frame.contact_normal.size() == 3 * c &&
                     frame.contact_force.size() == 3 * c && frame.contact_point.size() == 3 * c;
  if (!whole)
    throw Error(file.string(), "has contacts without ids, normals or forces, as earlier versions wrote them",
                "give a state of the run");
}

}  // namespace

packing::ContactTable contacts_in(const fs::path& source, PluginHost& host) {
  if (source.extension() != ".h5" && !is_folder(source)) {
    const pictures::Frame frame = pictures::load_backend()->read_frame(source);
    check_columns(frame, source);
    return table_of(frame);
  }
  const fs::path file = state_of(source);
  const run::EvaluatedState state = run::evaluated_state(state_file::read_state(file), file, host);
  packing::ContactTable table = table_of(state.frame);
  table.evaluated = !state.has_forces;
  return table;
}

}  // namespace scree::tool
