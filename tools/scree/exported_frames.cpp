#include "exported_frames.hpp"

#include "support/last_state.hpp"
#include "support/snapshot_files.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/pictures/load_backend.hpp>
#include <scree/scene_record.hpp>
#include <scree/state_error.hpp>
#include <scree/state_file/state_file.hpp>
#include <scree/state_transfer.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

void sort_by_id(packing::Packing& packing) {
  std::stable_sort(packing.bodies.begin(), packing.bodies.end(),
                   [](const packing::Body& a, const packing::Body& b) { return a.id < b.id; });
}

ExportedFrame frame_of(const State& state) {
  ExportedFrame frame;
  const StateTransfer from = StateTransfer::restoring_from(state);
  from.value("clock/steps", "1", frame.step);
  frame.packing.time = time_of(state);
  frame.packing.dimension = dimension_of(state);
  const std::vector<std::string> materials = frame.materials = materials_of(state);
  for (const Body& b : present_bodies(state))
    frame.packing.bodies.push_back({.id = b.id,
                                    .material = materials.at(b.material),
                                    .radius = b.radius,
                                    .mass = b.mass,
                                    .position = b.position,
                                    .velocity = b.velocity,
                                    .spin = b.spin});
  sort_by_id(frame.packing);
  packing::set_periodic(frame.packing, domain_of(state));
  return frame;
}

ExportedFrame frame_of_state(const fs::path& path) {
  const State state = state_file::read_state(path);
  return with_state_of(path.string(), [&] { return frame_of(state); });
}

ExportedFrame frame_of(const pictures::Frame& shown, const Domain& domain) {
  ExportedFrame frame;
  frame.step = shown.step;
  frame.packing.time = shown.time;
  frame.packing.dimension = shown.dimension;
  for (std::size_t i = 0; i < shown.particle_count(); ++i)
    frame.packing.bodies.push_back(
        {.id = shown.id[i],
         .material = std::to_string(shown.material.empty() ? 1 : shown.material[i] + 1),
         .radius = shown.radius[i],
         .position = vector_at(shown.position, i),
         .velocity = vector_at(shown.velocity, i),
         .spin = vector_at(shown.spin, i)});
  sort_by_id(frame.packing);
  packing::set_periodic(frame.packing, domain);
  return frame;
}

[[noreturn]] void refuse_without_bodies(const fs::path& source) {
  std::error_code failed;
  // What a run leaves that blew up before its first state.
  const bool has_table = fs::is_regular_file(source / "final_packing.csv", failed);
  throw Error(source.string(), "has neither a state nor snapshots of its bodies",
              has_table ? "take its final_packing.csv, or give the scene [snapshot] every or [checkpoint]"
                        : "give the directory of a run, a state (.h5) or a particles_*.vtp");
}

}  // namespace

Vec3 vector_at(const std::vector<double>& values, std::size_t i) {
  return values.empty() ? Vec3{} : Vec3{{values[3 * i], values[3 * i + 1], values[3 * i + 2]}};
}

void for_each_frame(const fs::path& source, bool all, const std::function<void(const ExportedFrame&)>& use) {
  std::error_code failed;
  if (source.extension() == ".h5") return use(frame_of_state(source));
  const bool is_run = fs::is_directory(source, failed);
  const std::optional<fs::path> state = is_run ? last_state(source) : std::nullopt;
  // A run that failed may have snapshots alone.
  const bool snapshots = !is_run || ((all || !state) && has_snapshots(source));
  if (!snapshots && !state) refuse_without_bodies(source);
  if (!snapshots) return use(frame_of_state(*state));
  const Domain domain = state ? domain_of(state_file::read_state(*state)) : Domain{};
  const auto backend = pictures::load_backend();
  std::vector<fs::path> files = snapshot_files(source);
  if (!all) files.erase(files.begin(), files.end() - 1);
  for (const fs::path& file : files) use(frame_of(backend->read_frame(file), domain));
}

}  // namespace scree::tool
