#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scree/run/run_directory.hpp>
#include <scree/state.hpp>

namespace scree::run {

// The states in the directory of a run: checkpoint/step_<number>.h5, of which the two latest are kept,
// states/<stage>.h5, and final_state.h5: their names. add() throws Error (failure).
class Checkpoints {
 public:
  explicit Checkpoints(const RunDirectory& directory) : directory_(directory) {}

  // List the file of a checkpoint, and of the state at the end; return their paths.
  std::filesystem::path add(std::uint64_t steps) const;
  std::filesystem::path add_final() const { return directory_.add(final_name); }
  // The state at the end of a stage, states/<stage>.h5.
  std::filesystem::path add_stage(const std::string& stage) const;
  // Removes all but the two latest.
  void remove_old() const;
  // Removes those after more steps, which a run that goes on from an earlier one has not taken.
  void remove_later(std::uint64_t steps) const;

  struct Latest {
    State state;
    std::filesystem::path path;
  };
  // Why a run cannot go on from a state; nothing if it can.
  using Refusal = std::function<std::optional<std::string>(const Latest&)>;
  // The latest state that can be read and is accepted. Reports each later state that it skips. Nothing if
  // there is no file of a state. Throws Error if there is none that can be used.
  std::optional<Latest> latest(const Refusal& refusal,
                               const std::function<void(const std::string&)>& report) const;
  // The state at the end of a stage. Throws Error if there is none that can be used.
  Latest at_end_of(const std::string& stage, const Refusal& refusal) const;

 private:
  class Search;
  static constexpr const char* final_name = "final_state.h5";
  static constexpr const char* stages_folder = "states";
  std::filesystem::path folder() const { return directory_.path() / WrittenFiles::states_folder; }
  struct File {
    std::uint64_t steps;
    std::filesystem::path path;
  };
  // Sorted from the latest to the first.
  std::vector<File> checkpoints() const;
  // These and the states at the ends of the stages that the record lists.
  std::vector<File> all() const;

  const RunDirectory& directory_;
};

}  // namespace scree::run
