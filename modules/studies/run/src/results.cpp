#include "results.hpp"

#include "expectations.hpp"
#include "run_record.hpp"

#include <fmt/format.h>

#include <scree/scenario/quantities.hpp>

namespace scree::run {

namespace {

void transfer_stages(const StateTransfer& state, std::vector<StageResult>& stages) {
  std::vector<std::string> names, ended;
  std::vector<double> start, end;
  std::vector<std::uint64_t> first, steps;
  for (const StageResult& stage : stages) {
    names.push_back(stage.name), ended.push_back(stage.ended);
    start.push_back(stage.start), end.push_back(stage.end);
    first.push_back(stage.first_step), steps.push_back(stage.steps);
  }
  state.rows("names", "", names);
  stages.resize(names.size());
  for (auto* numbers : {&start, &end}) numbers->resize(names.size());
  for (auto* counts : {&first, &steps}) counts->resize(names.size());
  ended.resize(names.size());
  state.sized_rows("start", "s", start);
  state.sized_rows("end", "s", end);
  state.sized_rows("first_step", "1", first);
  state.sized_rows("steps", "1", steps);
  state.sized_rows("ended", "", ended);
  for (std::size_t k = 0; k < stages.size(); ++k)
    stages[k] = {names[k], start[k], end[k], first[k], steps[k], ended[k]};
}

}  // namespace

Results::Results(const scenario::Plan& plan, const RunOptions& options, const RunDirectory& directory,
                 const Simulation& simulation)
    : plan_(plan), options_(options), directory_(directory), simulation_(simulation) {
  result_.directory = directory.path();
  result_.inputs = hashes_of(plan.files);
}

void Results::transfer(const StateTransfer& state) {
  transfer_stages(state.below("stages"), result_.stages);
  state.rows("warnings", "", result_.warnings);
  const InputHashes inputs = transfer_inputs(state.below("inputs"), result_.inputs);
  if (!state.restoring()) return;
  if (result_.stages.size() > plan_.stages.size())
    state.refuse("stages/names", "lists more stages than the scenario has");
  go_on_from(inputs);
  if (!result_.stages.empty()) result_.stages.back().ended = "running";
}

void Results::go_on_with_times() {
  const Recorded before = recorded_in(directory_.path());
  wall_before_ = before.wall;
  output_before_ = before.output;
  result_.state_output = before.state_output;
  result_.states = before.states;
}

void Results::go_on_from(const InputHashes& before) {
  result_.inputs =
      inputs_after(before, result_.inputs, [this](const std::string& warning) { warn(warning); });
}

void Results::begin_stage(const std::string& name) {
  end_stage("");
  const double time = simulation_.time();
  result_.stages.push_back({name, time, time, simulation_.steps(), 0, "running"});
}

void Results::end_stage(const std::string& how) {
  if (result_.stages.empty()) return;
  StageResult& stage = result_.stages.back();
  stage.end = simulation_.time();
  stage.steps = simulation_.steps() - stage.first_step;
  const bool timed = plan_.stages[result_.stages.size() - 1].duration.has_value();
  stage.ended = !how.empty() ? how : timed ? "duration" : "condition";
}

void Results::warn(const std::string& line) {
  result_.warnings.push_back(line);
  if (options_.on_warning) options_.on_warning(line);
}

void Results::note(const std::vector<std::string>& lines) {
  result_.warnings.insert(result_.warnings.end(), lines.begin(), lines.end());
}

void Results::judge(const Sampler& sampler) {
  if (result_.interrupted) return;
  result_.quantities = scenario::run_quantities(simulation_);
  const auto column = [&](const std::string& probe, const std::string& name) {
    return sampler.series(probe).column(name);
  };
  for (const scenario::Expectation& e : plan_.expectations)
    result_.verdicts.push_back(judge_expectation(e, result_.quantities, column));
}

void Results::record(const std::string& status, const std::string& error, const Stopwatch& watch) {
  result_.quantities = scenario::run_quantities(simulation_);
  result_.state_hash = simulation_.state_hash();
  write(status, error, watch);
}

void Results::record_times(const Stopwatch& watch) { write("running", "", watch); }

void Results::write(const std::string& status, const std::string& error, const Stopwatch& watch) {
  result_.wall = wall_before_ + watch.total();
  result_.output = output_before_ + watch.output();
  const double work = double(simulation_.steps()) * double(simulation_.particles().size());
  const double stepping = result_.wall - result_.output;
  result_.particle_steps_per_second = stepping > 0 ? work / stepping : 0;
  directory_.write_file("run.json", run_record(plan_, options_, result_, simulation_, status, error));
}

}  // namespace scree::run
