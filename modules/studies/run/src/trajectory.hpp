#pragma once

#include <scree/run/run_directory.hpp>
#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

// The frames of a run in one file of H5MD. HDF5 is loaded with the first.
class Trajectory {
 public:
  static constexpr const char* file_name = "trajectory.h5md";

  explicit Trajectory(const RunDirectory& directory) : directory_(directory) {}

  void add(const Simulation& simulation);
  // How many frames there are. Throws Error if the file of a run that goes on has not so many.
  void transfer(const StateTransfer& state);
  // Drops frames that came after the state.
  void cut();

 private:
  const RunDirectory& directory_;
  std::uint64_t frames_ = 0;
};

}  // namespace scree::run
