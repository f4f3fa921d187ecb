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
  std::string place;  // file:line:column in the campaign file, for messages
};

// A key that takes several values.
struct Parameter {
  std::string key;
  std::vector<Setting> values;  // at least one, all different
};

// A named set of values.
struct Case {
  std::string name;
  std::vector<Setting> settings;
};

// One run of a campaign.
struct Point {
  std::string name;       // of its directory, unique
  std::string case_name;  // empty in a campaign without cases
  std::optional<std::int64_t> seed;
  std::vector<Setting> settings;  // fixed settings, those of the case, parameters, seed

  // "key=value" for scree run --set.
  std::vector<std::string> overrides() const;
  const Setting* find(const std::string& key) const;
};

// A campaign file, read and checked: the runs are the product of cases, parameters and seeds, seeds fastest.
struct Campaign {
  std::string title;
  std::filesystem::path source, scenario;
  std::string scenario_place;        // file:line:column, for messages
  std::vector<std::string> collect;  // quantities of the runs' series, "<probe>.<column>.<statistic>"
  std::string collect_place;
  std::vector<Setting> fixed;
  std::vector<Parameter> parameters;
  std::vector<Case> cases;
  std::vector<std::int64_t> seeds;
  std::vector<Point> points;  // at least one

  // Keys in which points may differ: those of the cases, then the parameters.
  std::vector<std::string> varying_keys() const;
};

// Reads a campaign file. Throws Error "file:line:column: what is wrong; what to do" for any error in it, and
// if the scenario cannot be read.
Campaign read_campaign(const std::filesystem::path& path);

// Inputs of the run of a point.
struct Inputs {
  std::string resolved_text;                     // the scenario including the settings, as stored in run.json
  std::optional<std::filesystem::path> packing;  // the file of bodies that it reads
};

// Throws Error at a setting that does not fit the scenario.
Inputs inputs_of(const Campaign& campaign, const Point& point);

// Throws Error, like scree check, unless the point can be run and has all collected quantities. The position
// is that of the setting that causes the error, if there is one.
void check_point(const Campaign& campaign, const Point& point, PluginHost& host);

}  // namespace scree::campaign
