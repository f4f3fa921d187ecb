#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <scree/run/run_directory.hpp>
#include <scree/state.hpp>

namespace scree::run {

// The states in the directory of a run: checkpoint/step_<number>.h5, of which the two latest are kept, and
// final_state.h5. Functions that write throw Error (failure).
class Checkpoints {
 public:
  explicit Checkpoints(const RunDirectory& directory) : directory_(directory) {}

  void write(const State& state, std::uint64_t steps) const;
  void write_final(const State& state) const;

  struct Latest {
    State state;
    std::filesystem::path path;
  };
  // The state after the most steps that can be read; one that cannot is reported. Throws Error if there is none.
  Latest latest(const std::function<void(const std::string&)>& report) const;

 private:
  std::filesystem::path folder() const { return directory_.path() / "checkpoint"; }
  std::filesystem::path final_state() const { return directory_.path() / "final_state.h5"; }
  // Sorted from the latest to the first.
  std::vector<std::filesystem::path> all() const;

  const RunDirectory& directory_;
};

}  // namespace scree::run
