#include "run_record.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/files/text_file.hpp>
#include <scree/run/input_hashes_json.hpp>
#include <scree/run/record_json.hpp>
#include <scree/run/verdict_json.hpp>

namespace scree::run {

namespace {

using Json = nlohmann::ordered_json;

Json footprint_of(const Simulation& s) {
  const Footprint f = s.footprint();
  return {{"bodies", s.particles().size()},
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

}  // namespace

std::string run_record(const scenario::Plan& plan, const RunOptions& options, const RunResult& result,
                       const Simulation& s, const std::string& status, const std::string& error) {
  Json json = {{"version", SCREE_VERSION}, {"status", status}};
  if (!error.empty()) json["error"] = error;
  json["title"] = plan.title;
  json["seed"] = plan.seed;
  json["threads"] = options.threads;
  json["step"] = s.step_length();
  json["wall_s"] = result.wall;
  json["stepping_s"] = result.wall - result.output;
  json["output_s"] = result.output;
  json["states_s"] = result.state_output;
  json["states"] = result.states;
  json["particle_steps_per_second"] = result.particle_steps_per_second;
  for (const auto& [name, value] : result.quantities) json[name] = value;
  json["steps"] = s.steps();  // counts, as whole numbers
  json["neighbour_searches"] = s.rebuilds();
  json["state_hash"] = fmt::format("{:016x}", result.state_hash);
  json["footprint"] = footprint_of(s);
  json["warnings"] = result.warnings;
  json["stages"] = stages_of(result);
  json["expect"] = json_of(result.verdicts);
  json["inputs"] = json_of(result.inputs);
  json["scenario"] = plan.resolved_text;
  // replace: a path in an error message may not be valid UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Recorded recorded_in(const std::filesystem::path& directory) {
  try {
    const Json json = parse_record(files::read_text(directory / "run.json"));
    return {json.value("status", ""),
            json.value("wall_s", 0.0),
            json.value("output_s", 0.0),
            json.value("states_s", 0.0),
            json.value("states", std::uint64_t(0)),
            json.value("warnings", std::vector<std::string>()),
            json.value("scenario", "")};
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace scree::run
