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
  directory_.write_file("sweep.csv", sweep_table(spectrum_.observed, sweep_->points()));
}

void Course::transfer(const StateTransfer& state) {
  std::string scenario = plan_.resolved_text;
  state.value("scenario", "", scenario);
  std::vector<std::string> asked;
  for (const Method method : asked_) asked.push_back(method_names[std::size_t(method)]);
  state.rows("asked", "", asked);
  state.rows("left_out", "", left_out_);
  state.rows("warnings", "", result_.warnings);
  asked_.clear();
  for (const Method method : {Method::linear, Method::pulse, Method::sweep})
    if (std::find(asked.begin(), asked.end(), method_names[std::size_t(method)]) != asked.end())
      asked_.push_back(method);
  std::uint64_t count = result_.spectra.size();
  state.value("count", "1", count, stored::at_most(std::size(method_names)));
  result_.spectra.resize(count);
  const std::size_t observed = result_.observed.size();
  for (std::size_t k = 0; k < count; ++k) {
    const StateTransfer of_method = state.below("road_" + std::to_string(k));
    result_.spectra[k].transfer(of_method, observed);
    if (result_.spectra[k].frequencies.empty()) of_method.refuse("frequencies", "has none");
  }
  unfinished_.transfer(state.below("unfinished"), observed);
  const run::InputHashes inputs = run::transfer_inputs(state.below("inputs"), result_.inputs);
  if (state.restoring())
    result_.inputs =
        run::inputs_after(inputs, result_.inputs, [this](const std::string& line) { warn(line); });
}

}  // namespace scree::spectrum
