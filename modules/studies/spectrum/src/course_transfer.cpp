#include "course.hpp"
#include "measurement_files.hpp"

#include <algorithm>

#include <scree/run/set_up.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::spectrum {

void Course::save() {
  kept_.reset();
  State state = sweep_->save();
  transfer(StateTransfer::saving_to(state).below("spectrum"));
  write_sweep_table();
  write_state(state);
}

void Course::save_without_sweep() {
  transfer(StateTransfer::saving_to(start_->state).below("spectrum"));
  write_state(start_->state);
}

void Course::write_state(const State& state) {
  state_file::write_state(directory_.add(results.state), state);
}

void Course::write_sweep_table() {
  directory_.write_file("sweep.csv", sweep_table(plan_.spectrum->observed, sweep_->points()));
}

void Course::transfer(const StateTransfer& state) {
  std::string scenario = plan_.resolved_text;
  state.value("scenario", "", scenario);
  std::vector<std::string> asked;
  for (const Road road : asked_) asked.push_back(road_names[std::size_t(road)]);
  state.rows("asked", "", asked);
  state.rows("left_out", "", left_out_);
  state.rows("warnings", "", result_.warnings);
  asked_.clear();
  for (const Road road : {Road::linear, Road::pulse, Road::sweep})
    if (std::find(asked.begin(), asked.end(), road_names[std::size_t(road)]) != asked.end())
      asked_.push_back(road);
  std::uint64_t count = result_.roads.size();
  state.value("count", "1", count, stored::at_most(std::size(road_names)));
  result_.roads.resize(count);
  const std::size_t observed = result_.observed.size();
  for (std::size_t k = 0; k < count; ++k) {
    const StateTransfer of_road = state.below("road_" + std::to_string(k));
    result_.roads[k].transfer(of_road, observed);
    if (result_.roads[k].frequencies.empty()) of_road.refuse("frequencies", "has none");
  }
  unfinished_.transfer(state.below("unfinished"), observed);
  const run::InputHashes inputs = run::transfer_inputs(state.below("inputs"), result_.inputs);
  if (state.restoring())
    result_.inputs =
        run::inputs_after(inputs, result_.inputs, [this](const std::string& line) { warn(line); });
}

}  // namespace scree::spectrum
