#include <algorithm>

#include <fmt/format.h>

#include <scree/campaign/campaign.hpp>
#include <scree/document/document.hpp>
#include <scree/run/set_up.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::campaign {

namespace {

// Position of the setting that an error message refers to, else that of the scenario.
std::string position_of_cause(const Campaign& campaign, const Point& point, const std::string& line) {
  for (const Setting& setting : point.settings)
    if (line.starts_with("--set " + setting.key + "=")) return setting.place;
  return campaign.scenario_place;
}

// Hint for a common error: [0, 0, -9.81] in [set] means three values, not one vector.
std::string bracket_hint(const Campaign& campaign, const Point& point, const std::string& line) {
  if (line.find("give an array") == std::string::npos) return "";
  for (const Parameter& parameter : campaign.parameters)
    if (line.starts_with("--set " + point.find(parameter.key)->key + "="))
      return " (in [set] a list is a list of values; write [[...]] for one that is itself a list)";
  return "";
}

// Runs `action`; prefixes an error in the scenario of a point with the position in the campaign file.
template <class Action>
auto placed(const Campaign& campaign, const Point& point, Action&& action) {
  try {
    return action();
  } catch (const Error& error) {
    const std::string line = error.what();
    throw Error(fmt::format("{}: in run '{}' {}{}", position_of_cause(campaign, point, line), point.name,
                            line, bracket_hint(campaign, point, line)));
  }
}

}  // namespace

Inputs inputs_of(const Campaign& campaign, const Point& point, const PluginHost& host) {
  return placed(campaign, point, [&] {
    const auto document = document::Document::load(campaign.scenario, point.overrides());
    if (!document.conflict().empty())
      throw Error(fmt::format("{}; keep one of the two", document.conflict()));
    return Inputs{document.resolved_text(),
                  run::hashes_of(scenario::input_files(document, campaign.scenario, host))};
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
    throw Error(
        fmt::format("{}: {} has no [spectrum] to measure; add one, or remove spectrum from [campaign]",
                    campaign.scenario_place, campaign.scenario.string()));
  const std::vector<std::string> known = scenario::quantity_names(plan.probes, plan.scene.dimension);
  for (const std::string& name : campaign.collect) {
    if (const auto problem = scenario::quantity_problem(name, known))
      throw Error(fmt::format("{}: {}", campaign.collect_place, *problem));
    if (!plan.scene.audit && scenario::needs_energy_audit(name))
      throw Error(fmt::format("{}: '{}' needs the energy audit; set time.energy_audit = true, or remove it",
                              campaign.collect_place, name));
  }
}

std::vector<Body> check_preparation(const Campaign& preparation, const Point& point, PluginHost& host,
                                    const scenario::StudyTables& studies) {
  const scenario::Plan plan = checked_plan(preparation, point, host, studies);
  if (!plan.checkpoint.final_state)
    throw Error(
        fmt::format("{}: {} writes no final state, from which runs could begin; remove "
                    "checkpoint.final_state = false",
                    preparation.scenario_place, preparation.scenario.string()));
  return plan.scene.bodies;
}

void check_keys(const Campaign& campaign, const Point& point, const std::vector<Body>& bodies,
                PluginHost& host, const scenario::StudyTables& studies) {
  placed(campaign, point,
         [&] { scenario::check_keys(campaign.scenario, point.overrides(), bodies, host, studies); });
}

}  // namespace scree::campaign
