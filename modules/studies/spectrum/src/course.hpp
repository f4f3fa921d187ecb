#pragma once

#include "start.hpp"
#include "sweep.hpp"

#include <chrono>
#include <memory>
#include <optional>

#include <scree/run/run_directory.hpp>
#include <scree/run/spare_room.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/spectrum/measurement.hpp>

namespace scree::spectrum {

// One measurement from its start, or from its state, to its last file.
class Course {
 public:
  static constexpr const run::ResultKind& results = run::spectrum_results;

  Course(const scenario::Plan& plan, const MeasurementOptions& options, run::RunDirectory& directory);

  Measurement begin();
  Measurement resume(const State& state);

 private:
  void set_start(State state);
  void check_start(const Simulation& simulation) const;
  // Returns false after a stop.
  bool run_stages(Simulation& simulation, StageRunner& runner);
  // Keeps the state within the stages.
  Measurement stop_in_stages(const Simulation& simulation, const StageRunner& runner);
  Measurement go_on_in_stages(std::unique_ptr<Simulation> simulation, StageRunner& runner);
  bool asks(Road road) const;
  bool has(const std::string& road) const;
  bool proceeds() const { return !options_.stop || !*options_.stop; }
  void take_roads();
  // A road that begins again, or with what is unfinished, if it is interrupted. With others to take, one that cannot be taken is
  // left out.
  void take_short(Road road, const std::function<RoadSpectrum(const Start&)>& take);
  void take_sweep();
  void save();
  void write_sweep_table();
  void write_state(const State& state);
  // The same for a road of a part of the frequencies, now and then.
  void save_unfinished();
  void save_without_sweep();
  // What is complete stays.
  void save_failed(const std::string& failure);
  void transfer(const StateTransfer& state);
  void warn(const std::string& line);
  void judge();
  Measurement finish();
  double seconds() const;  // of wall time so far

  const scenario::Plan& plan_;
  const MeasurementOptions& options_;
  run::RunDirectory& directory_;
  std::vector<Road> asked_;
  std::vector<std::string> left_out_;  // asked for, but could not be taken
  Measurement result_;
  RoadSpectrum unfinished_;  // linear road of a part of the frequencies
  std::optional<Start> start_;
  std::unique_ptr<Sweep> sweep_;
  std::optional<State> kept_;  // behind the last complete frequency, if it is not in the file
  run::SpareRoom room_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  double last_state_ = 0, last_table_ = 0;  // (s)
};

}  // namespace scree::spectrum
