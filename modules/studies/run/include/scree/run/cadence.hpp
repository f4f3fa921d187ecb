#pragma once

#include <cmath>
#include <optional>

#include <scree/scenario/plan.hpp>

namespace scree::run {

// When states are due, as [checkpoint] of the scene says: by wall time since the last one, and by simulated
// time.
class Cadence {
 public:
  // Wall time counts from 0 s, simulated time from t = 0.
  explicit Cadence(const scenario::CheckpointPlan& plan) : every_(plan.every), every_time_(plan.every_time) {}

  bool is_on() const { return every_ || every_time_; }
  // Whether a state is due by wall time (s).
  bool is_due(double wall) const { return every_ && wall - last_wall_ >= *every_; }
  // Whether one is due by either, at the simulated time (s) of a state: the first after each multiple of
  // every_time.
  bool is_due(double wall, double time) const {
    return is_due(wall) || (every_time_ && multiple_of(time) > multiple_of(last_time_));
  }
  void restart(double wall, double time) { last_wall_ = wall, last_time_ = time; }

 private:
  double multiple_of(double time) const {
    constexpr double slack = 1e-9;  // round-off of a time that is a sum of steps
    return std::floor(time / *every_time_ + slack);
  }

  std::optional<double> every_, every_time_;  // (s)
  double last_wall_ = 0, last_time_ = 0;      // (s)
};

}  // namespace scree::run
