#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/plugin_host.hpp>

namespace scree::campaign {

// A value of the scenario that a campaign changes.
struct Setting {
  std::string key;    // a path, as for scree run --set
  std::string value;  // TOML in one line
  std::string place;  // in the campaign file, for messages
};

// A key that takes several values.
struct Parameter {
  std::string key;
  std::vector<Setting> values;  // at least one, all different
};

// Values that go together.
struct Case {
  std::string name;
  std::vector<Setting> settings;
};

// One run of a campaign.
struct Point {
  std::string name;       // of its directory; no other point has it
  std::string case_name;  // empty in a campaign without cases
  std::optional<std::int64_t> seed;
  std::vector<Setting> settings;  // fixed ones, those of the case, parameters, seed

  // As scree run --set takes them.
  std::vector<std::string> overrides() const;
  const Setting* find(const std::string& key) const;
};

// A campaign file, read and checked: the runs are the product of cases, parameters and seeds, seeds fastest.
struct Campaign {
  std::string title;
  std::filesystem::path source, scenario;
  std::string scenario_place;        // in the campaign file, for messages
  std::vector<std::string> collect;  // quantities of the runs' series, "<probe>.<column>.<statistic>"
  std::string collect_place;
  std::vector<Setting> fixed;
  std::vector<Parameter> parameters;
  std::vector<Case> cases;
  std::vector<std::int64_t> seeds;
  std::vector<Point> points;  // at least one

  // Keys in which points may differ, in order: of the cases, then the parameters.
  std::vector<std::string> varying_keys() const;
};

// Reads a campaign file. Throws Error "file:line:column: what is wrong; what to do" for any mistake in it,
// and for a scenario that cannot be read.
Campaign read_campaign(const std::filesystem::path& path);

// What the run of a point is made of.
struct Inputs {
  std::string resolved_text;                     // the scenario with the settings in, as run.json keeps it
  std::optional<std::filesystem::path> packing;  // the file of bodies that it names
};

// Throws Error at the setting that does not fit the scenario.
Inputs inputs_of(const Campaign& campaign, const Point& point);

// Throws Error, as scree check would, placed at the setting to blame where one is, unless the point can be
// run and has all that is collected.
void check_point(const Campaign& campaign, const Point& point, PluginHost& host);

}  // namespace scree::campaign
