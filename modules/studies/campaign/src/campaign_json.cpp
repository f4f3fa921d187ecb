#include <nlohmann/json.hpp>

#include <scree/campaign/report.hpp>
#include <scree/files/program_commit.hpp>

namespace scree::campaign {

namespace {

using Json = nlohmann::ordered_json;

// A TOML value as JSON: numbers, strings, booleans and lists as themselves, anything else as its text.
Json setting_json(const std::string& toml) {
  Json json = Json::parse(toml, nullptr, false);
  return json.is_discarded() ? Json(toml) : json;
}

Json settings_json(const std::vector<Setting>& settings) {
  Json json = Json::object();
  for (const Setting& setting : settings) json[setting.key] = setting_json(setting.value);
  return json;
}

Json parameters_json(const std::vector<Parameter>& parameters) {
  Json json = Json::object();
  for (const Parameter& parameter : parameters)
    for (const Setting& value : parameter.values) json[parameter.key].push_back(setting_json(value.value));
  return json;
}

Json run_json(const Point& point, const Outcome& outcome) {
  Json json = {{"run", point.name}, {"status", status_name(outcome.status)}};
  if (!point.case_name.empty()) json["case"] = point.case_name;
  json["set"] = settings_json(point.settings);
  if (!outcome.problem.empty()) json["error"] = outcome.problem;
  return json;
}

Json runs_json(const Campaign& campaign, const std::vector<Outcome>& outcomes) {
  Json json = Json::array();
  for (std::size_t k = 0; k < outcomes.size(); ++k) json.push_back(run_json(campaign.points[k], outcomes[k]));
  return json;
}

}  // namespace

std::string campaign_json(const Campaign& campaign, const Execution& execution) {
  Json json = {{"version", SCREE_VERSION},
               {"commit", files::program_commit()},
               {"title", campaign.title},
               {"file", std::filesystem::absolute(campaign.source).lexically_normal().string()},
               {"scenario", campaign.scenario.string()},
               {"seeds", campaign.seeds},
               {"collect", campaign.collect},
               {"parameters", parameters_json(campaign.parameters)},
               {"fixed", settings_json(campaign.fixed)}};
  for (const Case& one : campaign.cases) json["cases"][one.name] = settings_json(one.settings);
  if (campaign.preparation)
    json["preparation"] = {{"scenario", campaign.preparation->scenario.string()},
                           {"fixed", settings_json(campaign.preparation->fixed)},
                           {"runs", runs_json(*campaign.preparation, execution.preparations)}};
  json["runs"] = runs_json(campaign, execution.outcomes);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scree::campaign
