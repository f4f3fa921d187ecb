#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scree/simulation.hpp>

namespace scree {

// One part of a run: what changes when it begins, and until when it lasts.
struct Stage {
  struct Change {
    scree_kind kind;
    std::string name;  // of the law, boundary or body force
    Parameters parameters;
  };

  std::string name;
  std::vector<Change> changes;
  // Lasts this long (s), or until the condition holds.
  std::optional<double> duration;
  // Ends when kinetic energy / elastic energy falls below this.
  std::optional<double> kinetic_over_elastic;
  double at_least = 0;            // (s) before which the condition is not looked at
  std::optional<double> at_most;  // (s) after which a condition that has not come is an error
};

// Drives a simulation through its stages, step by step.
class StageRunner {
 public:
  StageRunner(Simulation& simulation, std::vector<Stage> stages);

  bool finished() const { return current_ == stages_.size(); }
  std::size_t current() const { return current_; }
  const std::vector<Stage>& stages() const { return stages_; }
  // Time at which the current stage began (s).
  double began() const { return began_; }
  // One time step; moves to the next stage when this one is over.
  // Throws Error(failure) when a condition has not come in time.
  void step();
  // The same for up to so many steps of this stage, as long as proceed() says yes. Returns how many were
  // made.
  std::uint64_t run(std::uint64_t steps, const std::function<bool()>& proceed);
  // Share of the whole run that is done, as far as durations tell: 0 to 1.
  double progress() const;

 private:
  void begin();
  bool over() const;
  // Until this stage may be over, at least 1.
  std::uint64_t steps_to_next_look() const;
  std::uint64_t steps_in(double duration) const;
  double expected_length(const Stage& stage) const;

  Simulation& simulation_;
  std::vector<Stage> stages_;
  std::size_t current_ = 0;
  double began_ = 0;
  std::uint64_t began_step_ = 0;
};

}  // namespace scree
