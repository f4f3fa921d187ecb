#include <algorithm>

#include <fmt/format.h>

#include <scree/campaign/campaign.hpp>
#include <scree/document/document.hpp>
#include <scree/run/set_up.hpp>

namespace scree::campaign {

namespace {

// The place of the setting that a line blames; else that of the scenario.
std::string blamed_place(const Campaign& campaign, const Point& point, const std::string& line) {
  for (const Setting& setting : point.settings)
    if (line.starts_with("--set " + setting.key + "=")) return setting.place;
  return campaign.scenario_place;
}

// The commonest slip: [0, 0, -9.81] taken for three values instead of one.
std::string bracket_hint(const Campaign& campaign, const Point& point, const std::string& line) {
  if (line.find("give an array") == std::string::npos) return "";
  for (const Parameter& parameter : campaign.parameters)
    if (line.starts_with("--set " + point.find(parameter.key)->key + "="))
      return " (in [set] a list is a list of values; write [[...]] for one that is itself a list)";
  return "";
}

// Puts what is wrong with the scenario of a point where the campaign file asks for it.
template <class Action>
auto placed(const Campaign& campaign, const Point& point, Action&& action) {
  try {
    return action();
  } catch (const Error& error) {
    const std::string line = error.what();
    throw Error(fmt::format("{}: in run '{}' {}{}", blamed_place(campaign, point, line), point.name, line,
                            bracket_hint(campaign, point, line)));
  }
}

}  // namespace

Inputs inputs_of(const Campaign& campaign, const Point& point) {
  return placed(campaign, point, [&] {
    const auto document = document::Document::load(campaign.scenario, point.overrides());
    if (!document.outdone().empty()) throw Error(fmt::format("{}; keep one of the two", document.outdone()));
    Inputs inputs{document.resolved_text(), std::nullopt};
    const document::Table root = document.root();
    if (root.is_table("particles") && root.table("particles").is_string("file"))
      inputs.packing = campaign.scenario.parent_path() / root.table("particles").string("file");
    return inputs;
  });
}

void check_point(const Campaign& campaign, const Point& point, PluginHost& host) {
  const scenario::Plan plan = placed(campaign, point, [&] {
    scenario::Plan read = scenario::read_plan(campaign.scenario, point.overrides(), host);
    run::set_up(read);
    return read;
  });
  const std::vector<std::string> known = scenario::quantity_names(plan.probes, plan.scene.dimension);
  for (const std::string& name : campaign.collect)
    if (const auto problem = scenario::quantity_problem(name, known))
      throw Error(fmt::format("{}: {}", campaign.collect_place, *problem));
}

}  // namespace scree::campaign
