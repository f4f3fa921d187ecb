#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

// One part of a run: the parameters that change at its start, and the condition that ends it.
struct Stage {
  struct Change {
    scree_kind kind;
    std::string name;  // of the law, boundary or body force
    Parameters parameters;
  };

  std::string name;
  std::vector<Change> changes;
  // Duration (s); without it, the condition below ends the stage.
  std::optional<double> duration;
  double period = 0;  // (s) of its cycles; 0: it has none
  // The stage ends when kinetic energy / elastic energy falls below this value.
  std::optional<double> kinetic_over_elastic;
  double at_least = 0;            // (s) before which the condition is not tested
  std::optional<double> at_most;  // (s) after which an unfulfilled condition is an error
};

// Duration of all stages together (s); NaN if one ends by a condition, or there is none.
double duration_of(const std::vector<Stage>& stages);

// Runs a simulation through its stages.
class StageRunner {
 public:
  StageRunner(Simulation& simulation, std::vector<Stage> stages);
  // Goes on within the stage in which the state was saved; if all had ended, within the last one if its duration
  // is longer now. The simulation has the parameters of that stage already. Throws Error if a duration is
  // shorter than the time that the stage has taken.
  StageRunner(Simulation& simulation, std::vector<Stage> stages, const StateTransfer& state);
  void save(const StateTransfer& state) const;

  bool finished() const { return current_ == stages_.size(); }
  std::size_t current() const { return current_; }
  const std::vector<Stage>& stages() const { return stages_; }
  // Start time of the current stage (s).
  double began() const { return began_; }
  // Steps taken in the current stage, or in the last one if all have ended.
  std::uint64_t steps() const { return simulation_.steps() - began_step_; }
  // Takes one time step and enters the next stage when this one has ended. Throws Error(failure) if the
  // condition is not fulfilled by `at_most`.
  void step();
  // Takes up to `steps` steps of this stage; `proceed` as in Simulation::run. Returns the steps taken.
  std::uint64_t run(std::uint64_t steps, const std::function<bool()>& proceed);
  // Completed fraction of the run, 0 to 1, by simulated time; absent while this stage or a later one ends by
  // a condition, as its length is unknown.
  std::optional<double> progress() const;
  // Kinetic energy / elastic energy at the last test of this stage's condition; absent before the first.
  std::optional<double> kinetic_over_elastic() const { return kinetic_over_elastic_; }

 private:
  void transfer(const StateTransfer& state);
  void check_resumed() const;
  void begin();
  bool over();
  // Steps until the end of this stage must be tested again, at least 1.
  std::uint64_t steps_to_next_check() const;
  std::uint64_t steps_in(double duration) const;

  Simulation& simulation_;
  std::vector<Stage> stages_;
  std::size_t current_ = 0;
  double began_ = 0;
  std::uint64_t began_step_ = 0;
  std::optional<double> kinetic_over_elastic_;
};

// Index of the stage whose parameters a saved simulation has: the current one, or the last if all had ended.
std::size_t stage_of(const StateTransfer& state);

// The scene with the parameters that it has in a stage.
Scene scene_in_stage(Scene scene, const std::vector<Stage>& stages, std::size_t stage);

}  // namespace scree
