#include <algorithm>

#include <fmt/format.h>

#include <scree/campaign/campaign.hpp>
#include <scree/document/document.hpp>
#include <scree/files/content_hash.hpp>
#include <scree/run/set_up.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::campaign {

namespace {

// Whether an error concerns the value that a setting gives to a key.
bool is_of(const Error& error, const std::string& key) {
  const std::string& begin = error.place().empty() ? error.problem() : error.place();
  return begin.starts_with("--set " + key + "=");
}

// Position of the setting that causes an error, or else of the scenario.
std::string position_of_cause(const Campaign& campaign, const Point& point, const Error& error) {
  for (const Setting& setting : point.settings)
    if (is_of(error, setting.key)) return setting.place;
  return campaign.scenario_place;
}

// Hint for a common error: [0, 0, -9.81] in [set] means three values, not one vector.
std::string bracket_hint(const Campaign& campaign, const Error& error) {
  if (error.cure().find("give an array") == std::string::npos) return "";
  for (const Parameter& parameter : campaign.parameters)
    if (is_of(error, parameter.key))
      return " (in [set] a list is a list of values; write [[...]] for one that is itself a list)";
  return "";
}

// Does work on the scenario of a point. Its errors then name the run and the position in the campaign file.
template <class Action>
auto placed(const Campaign& campaign, const Point& point, Action&& action) {
  try {
    return action();
  } catch (const Error& error) {
    const std::string run = fmt::format("in run '{}' ", point.name),
                      cause = position_of_cause(campaign, point, error),
                      cure = error.cure() + bracket_hint(campaign, error);
    if (error.place().empty()) throw Error(cause, run + error.problem(), cure);
    throw Error(cause + ": " + run + error.place(), error.problem(), cure);
  }
}

}  // namespace

Inputs inputs_of(const Campaign& campaign, const Point& point, const PluginHost& host) {
  return placed(campaign, point, [&] {
    const auto document = document::Document::load(campaign.scenario, point.overrides());
    if (!document.conflict().empty()) throw Error("", document.conflict(), "keep one of the two");
    return Inputs{document.resolved_text(),
                  run::hashes_of(scenario::input_files(document, campaign.scenario, host))};
  });
}

std::string inputs_key(const Campaign& campaign, const Point& point, const PluginHost& host) {
  return placed(campaign, point, [&] {
    const auto document = document::Document::load(campaign.scenario, point.overrides());
    const scenario::InputFiles files = campaign.preparation
                                           ? scenario::InputFiles{{}, scenario::plugin_files(document, host)}
                                           : scenario::input_files(document, campaign.scenario, host);
    const run::InputHashes hashes = run::hashes_of(files);
    std::string all = document.resolved_text() + '\0' + hashes.bodies;
    for (const auto& [name, hash] : hashes.plugins) all += '\0' + name + '\0' + hash;
    return files::text_hash(all);
  });
}

namespace {

scenario::Plan checked_plan(const Campaign& campaign, const Point& point, PluginHost& host,
                            const scenario::StudyTables& studies) {
  return placed(campaign, point, [&] {
    scenario::Plan read = scenario::read_plan(campaign.scenario, point.overrides(), host, studies);
    run::set_up(read);
    return read;
  });
}

}  // namespace

void check_point(const Campaign& campaign, const Point& point, PluginHost& host,
                 const scenario::StudyTables& studies) {
  const scenario::Plan plan = checked_plan(campaign, point, host, studies);
  if (!campaign.methods.empty() && !plan.document->root().has("spectrum"))
    throw Error(campaign.scenario_place,
                fmt::format("{} has no [spectrum] to measure", campaign.scenario.string()),
                "add one, or remove spectrum from [campaign]");
  const std::vector<std::string> known = scenario::quantity_names(plan.probes, plan.scene.dimension);
  for (const std::string& name : campaign.collect) {
    if (const auto problem = scenario::quantity_problem(name, known))
      throw Error(*problem).at(campaign.collect_place);
    if (!plan.scene.audit && scenario::needs_energy_audit(name))
      throw Error(campaign.collect_place, fmt::format("'{}' needs the energy audit", name),
                  "set time.energy_audit = true, or remove it");
  }
}

std::vector<Body> check_preparation(const Campaign& preparation, const Point& point, PluginHost& host,
                                    const scenario::StudyTables& studies) {
  const scenario::Plan plan = checked_plan(preparation, point, host, studies);
  if (!plan.checkpoint.final_state)
    throw Error(
        preparation.scenario_place,
        fmt::format("{} writes no final state, from which runs could begin", preparation.scenario.string()),
        "remove checkpoint.final_state = false");
  return plan.scene.bodies;
}

void check_keys(const Campaign& campaign, const Point& point, const std::vector<Body>& bodies,
                PluginHost& host, const scenario::StudyTables& studies) {
  placed(campaign, point,
         [&] { scenario::check_keys(campaign.scenario, point.overrides(), bodies, host, studies); });
}

}  // namespace scree::campaign
