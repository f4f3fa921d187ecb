#include "results.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/csv.hpp>
#include <scree/run/result_kind.hpp>
#include <scree/run/verdict.hpp>
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

using Json = nlohmann::ordered_json;

Json footprint_of(const Simulation& s) {
  const Footprint f = s.footprint();
  return {{"bodies", s.scene().bodies.size()},
          {"degrees_of_freedom", f.degrees_of_freedom},
          {"bytes_per_body", f.bytes_per_body},
          {"bytes_per_pair", f.bytes_per_pair},
          {"history_per_pair", f.history_width}};
}

Json stages_of(const RunResult& result) {
  Json json = Json::array();
  for (const StageResult& stage : result.stages)
    json.push_back({{"name", stage.name},
                    {"start", stage.start},
                    {"end", stage.end},
                    {"steps", stage.steps},
                    {"ended", stage.ended}});
  return json;
}

Json run_record(const scenario::Plan& plan, const RunOptions& options, const RunResult& result,
                const Simulation& s) {
  Json json = {{"title", plan.title}, {"seed", plan.seed}, {"threads", options.threads}};
  if (options.ranks) json["ranks"] = options.ranks->size();
  json["step"] = s.step_length();
  json["wall_s"] = result.wall_time;
  json["stepping_s"] = result.wall_time - result.output;
  json["output_s"] = result.output;
  json["states_s"] = result.state_output;
  json["states"] = result.states;
  json["particle_steps_per_second"] = result.particle_steps_per_second;
  for (const auto& [name, value] : result.quantities) json[name] = value;
  json["steps"] = s.steps();  // counts, as whole numbers
  json["neighbour_searches"] = s.rebuilds();
  json["state_hash"] = fmt::format("{:016x}", result.state_hash);
  json["footprint"] = footprint_of(s);
  json["stages"] = stages_of(result);
  json["expect"] = json_of(result.verdicts);
  return json;
}

}  // namespace

Results::Results(const scenario::Plan& plan, const RunOptions& options, Session& session,
                 const Simulation& simulation)
    : plan_(plan), options_(options), session_(session), simulation_(simulation) {}

void Results::transfer(const StateTransfer& state) {
  transfer_stages(state.below("stages"), result_.stages);
  session_.transfer_notes(state);
  if (!state.restoring()) return;
  if (result_.stages.size() > plan_.stages.size())
    state.refuse("stages/names", "lists more stages than the scenario has");
  if (!result_.stages.empty()) result_.stages.back().ended = "running";
}

void Results::go_on_with_times() {
  const Recorded before = recorded_in(session_.directory().path());
  wall_time_before_ = before.wall_time;
  output_before_ = before.output;
  result_.state_output = before.state_output;
  result_.states = before.states;
}

void Results::begin_stage(const std::string& name, const char* how) {
  end_stage(how);
  const double time = simulation_.time();
  result_.stages.push_back({name, time, time, simulation_.steps(), 0, "running"});
}

void Results::end_stage(const char* how) {
  if (result_.stages.empty()) return;
  StageResult& stage = result_.stages.back();
  stage.end = simulation_.time();
  stage.steps = simulation_.steps() - stage.first_step;
  stage.ended = how;
}

void Results::judge(const Sampler& sampler) {
  result_.quantities = scenario::run_quantities(simulation_);
  const auto column = [&](const std::string& probe, const std::string& name) {
    return sampler.series(probe).column(name);
  };
  for (const scenario::Expectation& e : plan_.expectations)
    result_.verdicts.push_back(judge_expectation(e, result_.quantities, column));
}

void Results::take_quantities() {
  result_.quantities = scenario::run_quantities(simulation_);
  result_.state_hash = simulation_.state_hash();
}

Json Results::record() {
  result_.wall_time = wall_time_before_ + session_.watch().total();
  result_.output = output_before_ + session_.watch().output();
  const double work = double(simulation_.steps()) * double(simulation_.scene().bodies.size());
  const double stepping = result_.wall_time - result_.output;
  result_.particle_steps_per_second = stepping > 0 ? work / stepping : 0;
  return run_record(plan_, options_, result_, simulation_);
}

RunResult Results::result() const {
  RunResult result = result_;
  result.directory = session_.directory().path();
  result.interrupted = session_.interrupted();
  result.inputs = session_.inputs();
  result.warnings = session_.warnings();
  return result;
}

Recorded recorded_in(const std::filesystem::path& directory) {
  try {
    const Json json = parse_record(files::read_text(directory / "run.json"));
    std::vector<std::pair<std::string, std::uint64_t>> stages;
    for (const Json& stage : json.value("stages", Json::array()))
      stages.emplace_back(stage.value("name", ""), stage.value("steps", std::uint64_t(0)));
    return {json.value("status", ""),
            json.value("wall_s", 0.0),
            json.value("output_s", 0.0),
            json.value("states_s", 0.0),
            json.value("states", std::uint64_t(0)),
            json.value("warnings", std::vector<std::string>()),
            json.value("scenario", ""),
            std::move(stages)};
  } catch (const std::exception&) {
    return {};
  }
}

namespace {

packing::Packing packing_of(const Simulation& s) {
  packing::Packing all;
  all.dimension = s.dimension();
  all.time = s.time();
  for (std::size_t i = 0; i < s.particles().size(); ++i) {
    const Body b = s.particles().body(i);
    all.bodies.push_back({.id = b.id,
                          .material = s.scene().materials[b.material],
                          .radius = b.radius,
                          .mass = b.mass,
                          .position = b.position,
                          .velocity = b.velocity,
                          .spin = b.spin});
  }
  // Sorted by id, as the order in memory is arbitrary.
  std::stable_sort(all.bodies.begin(), all.bodies.end(),
                   [](const packing::Body& a, const packing::Body& b) { return a.id < b.id; });
  return all;
}

bool is_finite(const packing::Body& b) {
  return std::isfinite(norm(b.position)) && std::isfinite(norm(b.velocity)) && std::isfinite(norm(b.spin));
}

}  // namespace

void write_final_packing(const Simulation& simulation, const std::filesystem::path& path) {
  packing::Packing last = packing_of(simulation);
  for (const packing::Body& body : last.bodies)
    if (!is_finite(body))
      throw Error(
          fmt::format(
              "particle {}: position, velocity or spin at t = {:g} s is beyond the range of numbers, so "
              "that final_packing.csv is not written; use a shorter time.step or a shorter run",
              body.id, simulation.time()),
          ExitStatus::failure);
  packing::set_periodic(last, simulation.domain());
  packing::write_csv(last, path);
}

}  // namespace scree::run
