#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>
#include <scree/until.hpp>

namespace scree {

// One part of a run: the parameters that change at its start, and the condition that ends it.
struct Stage {
  struct Change {
    scree_kind kind;
    std::string name;  // of the law, boundary or body force
    Parameters parameters;
    // Functions of time that the stage does not set and that go on.
    std::vector<std::string> going_on = {};
  };

  std::string name;
  std::vector<Change> changes;
  // Duration (s); without it, conditions end the stage.
  std::optional<double> duration;
  double period = 0;  // (s) of its cycles; 0: it has none
  Until until;        // without a duration
};

// How a stage has ended.
enum class StageEnd { duration, condition, at_most };
const char* name_of(StageEnd end);  // "duration"

// Duration of all stages together (s); NaN if one ends by a condition, or there is none.
double duration_of(const std::vector<Stage>& stages);

// Runs a simulation through its stages.
class StageRunner {
 public:
  // columns: needed if conditions read columns of probes; else null.
  StageRunner(Simulation& simulation, std::vector<Stage> stages,
              std::shared_ptr<StageColumns> columns = nullptr);
  // Goes on within the stage in which the state was saved; if all had ended, within the last one if its
  // duration is longer now. The simulation has the parameters of that stage already. Throws Error if a
  // duration is shorter than the time that the stage has taken.
  StageRunner(Simulation& simulation, std::vector<Stage> stages, const StateTransfer& state,
              std::shared_ptr<StageColumns> columns = nullptr);
  void save(const StateTransfer& state) const;

  bool finished() const { return current_ == stages_.size(); }
  std::size_t current() const { return current_; }
  const std::vector<Stage>& stages() const { return stages_; }
  // Start time of the current stage (s).
  double began() const { return began_; }
  // Steps taken in the current stage, or in the last one if all have ended.
  std::uint64_t steps() const { return simulation_.steps() - began_step_; }
  // Takes one time step and enters the next stage when this one has ended. Throws Error(not_reached) if its
  // conditions are not met by `at_most`, unless the stage goes on then.
  void step();
  // Takes up to `steps` steps of this stage; `proceed` as in Simulation::run. Returns the steps taken.
  std::uint64_t run(std::uint64_t steps, const std::function<bool()>& proceed);
  // Completed fraction of the run, 0 to 1, by simulated time; absent while this stage or a later one ends by
  // a condition, as its length is unknown.
  std::optional<double> progress() const;
  // Whether step() or run() has thrown since the stage after this one cannot begin.
  bool next_is_refused() const { return next_is_refused_; }
  // How the stage before this one ended, or the last one if all have.
  StageEnd last_end() const { return last_end_; }
  // The values of this stage's conditions at their last test, "kinetic_over_elastic = 0.02, below 1e-06";
  // empty before the first, and of a stage with a duration.
  std::string status() const;

 private:
  void transfer(const StateTransfer& state);
  void check_resumed() const;
  void begin();
  void apply_changes();
  void forget_values();
  void end_stage(StageEnd end);
  // Throws Error(not_reached) if the next stage cannot begin; this one then goes on to be the present one.
  void check_next();
  // Takes the values of conditions that are due; false if none is.
  bool take_values();
  bool conditions_met() const;
  bool over();
  [[noreturn]] void fail() const;
  // Steps until the end of this stage must be tested again, at least 1.
  std::uint64_t steps_to_next_check() const;
  std::uint64_t steps_in(double duration) const;
  // Steps of until.at_most, at least one.
  std::uint64_t steps_of_limit(double at_most) const;

  Simulation& simulation_;
  std::vector<Stage> stages_;
  std::size_t current_ = 0;
  double began_ = 0;
  std::uint64_t began_step_ = 0;
  std::vector<ConditionValues> values_;  // of the conditions of this stage
  std::shared_ptr<StageColumns> columns_;
  StageEnd last_end_ = StageEnd::duration;
  bool next_is_refused_ = false;
};

// Index of the stage whose parameters a saved simulation has: the current one, or the last if all had ended.
std::size_t stage_of(const StateTransfer& state);

// The scene with the parameters that it has in a stage.
Scene scene_in_stage(Scene scene, const std::vector<Stage>& stages, std::size_t stage);

}  // namespace scree
