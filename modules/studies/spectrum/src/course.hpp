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

  Course(const scenario::Plan& plan, SpectrumPlan spectrum, const MeasurementOptions& options,
         run::RunDirectory& directory);

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
  bool asks(Method method) const;
  bool has(const std::string& method) const;
  bool proceeds() const { return !options_.stop || !*options_.stop; }
  void measure_by_methods();
  // Measures by a method that begins again, or from what is unfinished, if it is interrupted. A method that fails
  // is skipped if there are others.
  void take_short(Method method, const std::function<MethodSpectrum(const Start&)>& take);
  void take_sweep();
  void save();
  void write_sweep_table();
  void write_state(const State& state);
  // Saves the part of the frequencies that is solved, now and then.
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
  SpectrumPlan spectrum_;
  const MeasurementOptions& options_;
  run::RunDirectory& directory_;
  std::vector<Method> asked_;
  std::vector<std::string> left_out_;  // asked for, but could not be taken
  Measurement result_;
  MethodSpectrum unfinished_;  // linear method of a part of the frequencies
  std::optional<Start> start_;
  std::unique_ptr<Sweep> sweep_;
  std::optional<State> kept_;  // after the last complete frequency, if it is not in the file
  run::SpareRoom room_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  double last_state_ = 0, last_table_ = 0;  // (s)
};

}  // namespace scree::spectrum
