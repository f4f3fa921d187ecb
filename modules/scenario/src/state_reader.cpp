#include "state_reader.hpp"

#include "particles_keys.hpp"
#include "plugin_parameters.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include <scree/scenario/names.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::scenario {

namespace fs = std::filesystem;

namespace {

// Folders from which a scenario may read states: its own, the working folder, and those that the user names.
std::vector<fs::path> state_folders(const fs::path& folder) {
  std::vector<fs::path> all = {folder.empty() ? "." : folder, "."};
  if (const char* named = std::getenv("SCREE_STATE_PATH")) {
    std::istringstream parts(named);
    for (std::string part; std::getline(parts, part, ':');)
      if (!part.empty()) all.emplace_back(part);
  }
  return all;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

}  // namespace

fs::path find_state(const document::Table& particles, const fs::path& folder) {
  const fs::path given = read(particles, particles_keys.state);
  std::error_code failed;
  bool outside = false;
  for (const fs::path& base : state_folders(folder)) {
    const fs::path path = fs::weakly_canonical(base / given, failed);
    if (failed || !fs::exists(path, failed)) continue;
    for (const fs::path& allowed : state_folders(folder))
      if (is_below(path, fs::weakly_canonical(allowed, failed))) return path;
    outside = true;
  }
  if (outside)
    throw particles.error(
        particles_keys.state,
        fmt::format("'{}' is outside the folder of the scenario and the working folder", given.string()),
        "name its folder in the environment variable SCREE_STATE_PATH");
  throw particles.error(
      particles_keys.state, fmt::format("there is no file '{}'", given.string()),
      "give its path from the folder of the scenario or the working folder, or name its folder in SCREE_STATE_PATH");
}

std::shared_ptr<const State> read_state(const document::Table& particles, const fs::path& folder) {
  const fs::path path = find_state(particles, folder);
  return placed(particles, "state",
                [&] { return std::make_shared<const State>(state_file::read_state(path)); });
}

Branching read_branching(const document::Table& particles) {
  Branching branching;
  if (!particles.optional(particles_keys.leave_out)) return branching;
  const std::vector<std::string> known = {"histories", "walls", "orientations"};
  const std::vector<std::string> words = particles.strings(particles_keys.leave_out);
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::size_t which = find_name(particles, particles_keys.leave_out, "part", words[k], known, k);
    *std::array{&branching.histories, &branching.walls, &branching.orientations}[which] = false;
  }
  return branching;
}

void check_ids(const std::vector<Body>& bodies) {
  std::vector<std::int64_t> ids;
  for (const Body& body : bodies) ids.push_back(body.id);
  std::sort(ids.begin(), ids.end());
  const bool positive = ids.empty() || ids.front() > 0;
  if (!positive || std::adjacent_find(ids.begin(), ids.end()) != ids.end())
    throw Error(
        "'bodies/id' has an id that is not above 0 or is used twice; take a state that scree has written");
}

std::vector<Body> bodies_of(const document::Table& particles, const State& state,
                            const std::vector<Material>& materials) {
  return placed(particles, "state", [&] {
    std::vector<std::uint32_t> here;
    const std::vector<std::string> names = names_of(materials);
    for (const std::string& name : materials_of(state)) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        throw Error(
            fmt::format("the state has bodies of the material '{}'; add a [[material]] of this name", name));
      here.push_back(std::uint32_t(found - names.begin()));
    }
    std::vector<Body> bodies = present_bodies(state);
    check_ids(bodies);
    for (Body& body : bodies) body.material = here.at(body.material);
    return bodies;
  });
}

}  // namespace scree::scenario
