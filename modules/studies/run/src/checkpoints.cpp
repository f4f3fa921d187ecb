#include "checkpoints.hpp"

#include "results.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/state_error.hpp>
#include <scree/state_file/state_file.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t states_kept = 2;

std::string name_of(std::uint64_t steps) { return fmt::format("step_{:015}.h5", steps); }

// A stage may have any name, and a file cannot: "a/b" is a%2Fb.h5. Other stages have other files.
std::string file_name_of(const std::string& stage) {
  std::string name;
  for (const char c : stage) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '/' || c == '%' || byte < ' ')
      name += fmt::format("%{:02X}", byte);
    else
      name += c;
  }
  return name + ".h5";
}

std::uint64_t steps_of(const State& state) {
  std::uint64_t steps = 0;
  StateTransfer::restoring_from(state).below("clock").value("steps", "1", steps);
  return steps;
}

}  // namespace

std::vector<Checkpoints::File> Checkpoints::checkpoints() const {
  std::vector<File> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder(), failed)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("step_") && name.ends_with(".h5"))
      files.push_back({std::strtoull(name.c_str() + 5, nullptr, 10), entry.path()});
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.steps > b.steps; });
  return files;
}

std::vector<Checkpoints::File> Checkpoints::all() const {
  std::vector<File> files = checkpoints();
  std::uint64_t steps = 0;
  std::error_code failed;
  for (const auto& [name, taken] : recorded_in(directory_.path()).stages) {
    steps += taken;
    const fs::path path = directory_.path() / stages_folder / file_name_of(name);
    if (fs::exists(path, failed)) files.push_back({steps, path});
  }
  std::stable_sort(files.begin(), files.end(),
                   [](const File& a, const File& b) { return a.steps > b.steps; });
  return files;
}

fs::path Checkpoints::add(std::uint64_t steps) const {
  const fs::path path = directory_.add(fmt::format("{}/{}", WrittenFiles::states_folder, name_of(steps)));
  std::error_code failed;  // a failure is reported when the file is opened
  fs::create_directories(folder(), failed);
  return path;
}

fs::path Checkpoints::add_stage(const std::string& stage) const {
  const fs::path path = directory_.add(fmt::format("{}/{}", stages_folder, file_name_of(stage)));
  std::error_code failed;  // a failure is reported when the file is opened
  fs::create_directories(path.parent_path(), failed);
  return path;
}

Checkpoints::Latest Checkpoints::at_end_of(const std::string& stage, const Refusal& refusal) const {
  const fs::path folder = directory_.path() / stages_folder, path = folder / file_name_of(stage);
  std::error_code failed;
  if (!fs::exists(path, failed)) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder, failed))
      names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    throw Error(fmt::format("--from {}: {} has no state of the end of this stage; {}", stage,
                            directory_.path().string(),
                            names.empty() ? "leave --from out" : document::name_cure(stage, names)));
  }
  Latest latest{state_file::read_state(path), path};
  if (const auto why = refusal(latest)) throw Error(fmt::format("{}: {}", path.string(), *why));
  return latest;
}

void Checkpoints::remove_old() const {
  std::error_code failed;
  const std::vector<File> files = checkpoints();
  for (std::size_t k = states_kept; k < files.size(); ++k) fs::remove(files[k].path, failed);
}

void Checkpoints::remove_later(std::uint64_t steps) const {
  std::error_code failed;
  for (const File& file : checkpoints())
    if (file.steps > steps) fs::remove(file.path, failed);
}

// Looks for the latest state that can be used.
class Checkpoints::Search {
 public:
  using Report = std::function<void(const std::string&)>;
  Search(const Refusal& refusal, const Report& report) : refusal_(refusal), report_(report) {}

  std::optional<Latest> read(const fs::path& path) {
    try {
      Latest latest{state_file::read_state(path), path};
      with_state_of(path.string(), [&] { steps_of(latest.state); });
      return latest;
    } catch (const Error& error) {
      passed_over_.push_back(error.what());
      return std::nullopt;
    }
  }

  bool takes(const Latest& state) {
    if (const auto why = refusal_(state)) {
      passed_over_.push_back(fmt::format("{}: {}", state.path.string(), *why));
      if (first_refused_.empty()) first_refused_ = passed_over_.back();
      return false;
    }
    for (const std::string& line : passed_over_) report_(line);
    return true;
  }

  // Where no state is taken.
  void end(const fs::path& directory) const {
    if (!first_refused_.empty()) throw Error(first_refused_);
    for (const std::string& line : passed_over_) report_(line);
    if (!passed_over_.empty())
      throw Error(
          fmt::format("{}: none of its states can be read; run the scenario again", directory.string()));
  }

 private:
  const Refusal& refusal_;
  const Report& report_;
  std::vector<std::string> passed_over_;
  std::string first_refused_;
};

std::optional<Checkpoints::Latest> Checkpoints::latest(
    const Refusal& refusal, const std::function<void(const std::string&)>& report) const {
  Search search(refusal, report);
  std::error_code failed;
  std::optional<Latest> at_end;
  if (const fs::path path = directory_.path() / final_name; fs::exists(fs::symlink_status(path, failed)))
    at_end = search.read(path);
  for (const File& file : all()) {
    if (at_end && steps_of(at_end->state) > file.steps) {
      if (search.takes(*at_end)) return at_end;
      at_end.reset();
    }
    std::optional<Latest> state = search.read(file.path);
    if (state && search.takes(*state)) return state;
  }
  if (at_end && search.takes(*at_end)) return at_end;
  search.end(directory_.path());
  return std::nullopt;
}

}  // namespace scree::run
