#include "stage_lengths.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

namespace {

// The length of a stage may change, but nothing that has shaped the run so far.
bool is_length(const std::string& override_text) {
  const std::string key = override_text.substr(0, override_text.find('='));
  const std::string last = key.substr(key.rfind('.') + 1);
  return (key.starts_with("stage") || key.starts_with("time")) &&
         (last == "duration" || last == "cycles" || last == "at_most");
}

}  // namespace

void check_overrides(const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides)
    if (!is_length(text))
      throw Error(
          fmt::format("--set {}: a run that goes on can change only how long its stages last (duration, "
                      "cycles, at_most); begin a new run from its state (particles.state)",
                      text));
}

Position position_of(const State& state, const scenario::Plan& plan) {
  const StateTransfer stages = StateTransfer::restoring_from(state).below("run/stages");
  if (plan.stages.empty()) stages.refuse("stage", "is one of a scenario without stages");
  Position position = {stage_of(stages), 0, false};
  stages.value("began", "s", position.began);
  position.ended = position.stage >= plan.stages.size();
  if (position.ended) position.stage = plan.stages.size() - 1;
  return position;
}

void check_past(const scenario::Plan& before, const scenario::Plan& now, const Position& position) {
  for (std::size_t k = 0; k < std::min(position.stage, now.stages.size()); ++k)
    if (before.stages[k].duration != now.stages[k].duration ||
        before.stages[k].until.at_most != now.stages[k].until.at_most)
      throw Error(
          fmt::format("--set: stage '{}' is over, so that its length cannot change; set that of stage '{}'{}",
                      now.stages[k].name, now.stages[position.stage].name,
                      position.stage + 1 < now.stages.size() ? " or a later one" : ""));
}

std::string duration_until(const scenario::Plan& plan, const Position& position, double until) {
  const std::vector<Stage>& stages = plan.stages;
  if (position.ended && !stages.back().duration)
    throw Error(
        fmt::format("--until: stage '{}' has ended by its condition, after which nothing can follow; "
                    "begin a new run from the state (particles.state)",
                    stages.back().name));
  double begin = position.began;
  for (std::size_t k = position.stage; k + 1 < stages.size(); ++k) begin += stages[k].duration.value_or(NAN);
  if (!stages.back().duration || std::isnan(begin))
    throw Error(
        "--until: the time at which the last stage ends is not known, as a stage ends by a condition; "
        "give --set stage.<name>.duration=<s> or at_most=<s>");
  if (!(until > begin))
    throw Error(
        fmt::format("--until {:g}: the last stage begins at {:g} s; give a later time", until, begin));
  return scenario::length_override(plan.resolved_text, until - begin);
}

}  // namespace scree::run
