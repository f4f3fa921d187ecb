#pragma once

#include "field_output.hpp"
#include "pictures.hpp"
#include "results.hpp"
#include "sampler.hpp"
#include "state_writer.hpp"

#include <exception>
#include <memory>
#include <optional>

#include <scree/run/run.hpp>
#include <scree/run/session.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// A run of the stages of a plan, with its probes, pictures and states.
class Run : public Study {
 public:
  // A simulation at its start, or that of the state with which the run goes on.
  Run(const scenario::Plan& plan, const RunOptions& options, Session& session,
      std::unique_ptr<Simulation> simulation);

  void prepare() override;
  void restore(const State& state) override;
  void open() override;
  void reopen() override;
  bool work() override;
  void end_failed() override;
  void save_failed() override;
  nlohmann::ordered_json record() override;

  RunResult result() const { return results_.result(); }

  // Hooks of run_with_hooks().
  void begin(const std::string& stage);
  std::uint64_t observe(const std::string& stage, std::uint64_t steps);
  bool proceed(const StageRunner& runner);
  // Whether neither this process nor another rank has been asked to stop.
  bool proceeds() const;
  bool pauses(const StageRunner&) const { return states_.is_waiting(); }
  void between(const StageRunner& runner);

 private:
  void announce();
  // Returns the name of the last stage.
  std::string run_stages();
  std::string drive_stages();
  void save_unreached();
  void write_last_state(bool complete);
  void write_results(bool complete);
  // The part of the state that changes; the writer thread adds the constant part. The state file must already
  // be listed in written.txt.
  State save_state();
  void report_progress(const StageRunner& runner);

  const scenario::Plan& plan_;
  const RunOptions& options_;
  Session& session_;
  std::unique_ptr<Simulation> simulation_;
  Sampler sampler_;
  Pictures pictures_;
  FieldOutput fields_;
  Results results_;
  std::optional<StageRunner> runner_;
  StateWriter states_;
  std::vector<std::string> start_warnings_;
  bool prolonged_ = false;     // its stages are longer than in the state from which it goes on
  std::uint64_t written_ = 0;  // see WrittenFiles::size
  double last_report_ = 0;     // (s) of wall time
  std::exception_ptr no_final_state_;
  bool not_reached_ = false;  // the conditions of the present stage, in time
  std::string ended_stage_;   // whose state is to be written; empty: none
};

// The part of the options of a run that its session takes.
SessionOptions session_options_of(const RunOptions& options);

}  // namespace scree::run
