#pragma once

#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/state.hpp>

// What may change in a run that goes on: how long its stages last.
namespace scree::run {

// How far a run has come in its stages.
struct Position {
  std::size_t stage;  // the present one, or the last if all have ended
  double began;       // (s)
  bool ended;         // whether all have
};
// Of the state of a run.
Position position_of(const State& state, const scenario::Plan& plan);

// Throws Error unless all overrides set lengths of stages.
void check_overrides(const std::vector<std::string>& overrides);

// Throws Error if a stage that is over would have another length.
void check_past(const scenario::Plan& before, const scenario::Plan& now, const Position& position);

// The override that makes a plan end at a time (s). Throws Error if its last stage cannot end there.
std::string duration_until(const scenario::Plan& plan, const Position& position, double until);

}  // namespace scree::run
