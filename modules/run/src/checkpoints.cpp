#include "checkpoints.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state_file/state_file.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kept = 2;

std::string name_of(std::uint64_t steps) { return fmt::format("step_{:015}.h5", steps); }

std::uint64_t steps_of(const State& state) {
  std::uint64_t steps = 0;
  StateTransfer::restoring_from(state).below("clock").value("steps", "1", steps);
  return steps;
}

}  // namespace

std::vector<fs::path> Checkpoints::all() const {
  std::vector<fs::path> paths;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder(), failed)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("step_") && name.ends_with(".h5")) paths.push_back(entry.path());
  }
  // Numbers of steps have a fixed width, so that names are sorted as they are.
  std::sort(paths.rbegin(), paths.rend());
  return paths;
}

fs::path Checkpoints::add(std::uint64_t steps) const {
  std::error_code failed;  // a failure is reported when the file is opened
  fs::create_directories(folder(), failed);
  return directory_.add(fmt::format("{}/{}", WrittenFiles::states_folder, name_of(steps)));
}

void Checkpoints::remove_old() const {
  std::error_code failed;
  const std::vector<fs::path> paths = all();
  for (std::size_t k = kept; k < paths.size(); ++k) fs::remove(paths[k], failed);
}

void Checkpoints::remove_later(std::uint64_t steps) const {
  std::error_code failed;
  for (const fs::path& path : all())
    if (path.filename().string() > name_of(steps)) fs::remove(path, failed);
}

std::optional<Checkpoints::Latest> Checkpoints::latest(
    const std::function<void(const std::string&)>& report) const {
  std::optional<Latest> found;
  bool damaged = false;
  const auto consider = [&](const fs::path& path) {
    try {
      State state = state_file::read_state(path);
      if (!found || steps_of(state) > steps_of(found->state)) found = Latest{std::move(state), path};
      return true;
    } catch (const Error& error) {
      report(error.what());
      damaged = true;
      return false;
    }
  };
  for (const fs::path& path : all())
    if (consider(path)) break;
  std::error_code failed;
  if (fs::exists(fs::symlink_status(directory_.path() / final_name, failed)))
    consider(directory_.path() / final_name);
  if (!found && damaged)
    throw Error(fmt::format("{}: none of its states can be read; run the scenario again",
                            directory_.path().string()));
  return found;
}

}  // namespace scree::run
