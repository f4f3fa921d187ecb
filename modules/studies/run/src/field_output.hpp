#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <scree/fields/field_recorder.hpp>
#include <scree/run/line_file.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

// The fields of a run, of each [[fields]], in fields/. Their library is loaded, and in a build tree built,
// only if the plan has some.
class FieldOutput {
 public:
  // Throws Error if the library is needed and cannot be loaded.
  FieldOutput(const scenario::Plan& plan, const RunDirectory& directory, unsigned threads);

  // Takes kernels and grids, from the bodies at the start of the run. Throws Error, at the table, if one is
  // not possible.
  void prepare(const Simulation& simulation);
  // Writes what is due `steps` after the start of a stage. Returns the step count of the next output.
  std::uint64_t take(const Simulation& simulation, const std::string& stage, std::uint64_t steps);
  // Step count after the start of a stage at which the next output is due.
  std::uint64_t next(const Simulation& simulation, const std::string& stage, std::uint64_t steps) const;
  // Writes the fields of the last step of a run, in the stage of this name.
  void take_last(const Simulation& simulation, const std::string& stage);
  // Which files there are; tables must be flushed.
  void transfer(const StateTransfer& state);
  // Drops rows, and entries of collections, that came after the state.
  void cut();
  void flush();

 private:
  struct Recorded {
    const scenario::FieldsPlan* plan;
    std::optional<fields::FieldSetting> setting = std::nullopt;
    std::unique_ptr<LineFile> table = nullptr;
    std::vector<double> times = {};  // (s) of the frames, and the steps at which they were written
    std::vector<std::uint64_t> steps = {};
  };
  void write(Recorded& recorded, const Simulation& simulation);
  void write_collection(const Recorded& recorded) const;
  // The path of a file in fields/, which is about to be written.
  std::filesystem::path listed(const std::string& file) const;

  const RunDirectory& directory_;
  unsigned threads_;
  int dimension_;
  fields::FieldRecorder* recorder_ = nullptr;
  std::vector<Recorded> all_;
};

}  // namespace scree::run
