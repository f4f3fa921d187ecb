#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <scree/particles.hpp>
#include <scree/plugin_host.hpp>
#include <scree/run/input_hashes.hpp>
#include <scree/scenario/study_table.hpp>

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
  std::vector<Setting> preparation;  // of its preparation
};

// One run of a campaign.
struct Point {
  std::string name;       // of its directory in the directory of the campaign, unique
  std::string case_name;  // empty in a campaign without cases
  std::optional<std::int64_t> seed;
  std::vector<Setting> settings;  // fixed settings, settings of the case, parameters, seed

  // "key=value" for scree run --set.
  std::vector<std::string> overrides() const;
  const Setting* find(const std::string& key) const;
};

// What a site's batch system is asked for, [slurm]; empty: its default. It never changes results, so that it
// is not among the inputs of runs.
struct SlurmTable {
  std::string partition, time, memory, account, qos, constraint;
  std::vector<std::string> options;  // further ones of sbatch, "--mail-type=END"
};

// A campaign file, read and checked: the runs are the product of cases, parameters and seeds, seeds fastest.
struct Campaign {
  std::string title;
  std::filesystem::path source, scenario;
  std::string scenario_place;        // file:line:column, for messages
  std::string methods;               // by which scree spectrum measures the scenario; empty: it is run
  std::vector<std::string> collect;  // quantities of the runs' series, "<probe>.<column>.<statistic>"
  std::string collect_place;
  std::vector<Setting> fixed;
  std::vector<Parameter> parameters;
  std::vector<Case> cases;
  std::vector<std::int64_t> seeds;
  std::vector<Point> points;  // at least one
  // [prepare]: a campaign with one point per seed, and per case if any case has settings for it. The points
  // of this campaign begin from its final states. Null without [prepare].
  std::shared_ptr<const Campaign> preparation = nullptr;
  std::string state_key = "particles.state";  // by which the scenario takes that state

  // Keys in which points may differ: of the cases, then the parameters.
  std::vector<std::string> varying_keys() const;
  std::vector<std::size_t> preparation_of;  // of each point: index in preparation->points
  SlurmTable slurm = {};
  // File in the directory of a point that states its status and inputs.
  const char* record() const { return methods.empty() ? "run.json" : "spectrum.json"; }
};

// Reads a campaign file. overrides: "KEY=VALUE" replaces a line of [set], "campaign.KEY=VALUE" a line of
// [campaign], "slurm.KEY=VALUE" one of [slurm], "prepare.KEY=VALUE" a setting of [prepare]. Throws Error
// "file:line:column: what is wrong; what to do" for any error in the file, and if the scenario cannot be
// read.
Campaign read_campaign(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

// Inputs of the run of a point, as stored in its record.
struct Inputs {
  std::string resolved_text;  // the scenario including the settings
  run::InputHashes hashes;
};

// Throws Error at a setting that does not fit the scenario, and for a state that does not exist.
Inputs inputs_of(const Campaign& campaign, const Point& point, const PluginHost& host);

// A hash of the inputs of a point (16 hexadecimal digits) that is known before its preparation has been run:
// of the scenario including the settings, files of bodies and plug-ins, but not of the prepared state, whose
// name says from what it is made. Throws Error like inputs_of().
std::string inputs_key(const Campaign& campaign, const Point& point, const PluginHost& host);

// The campaign with all points beginning from the final states of their preparations, which are then named
// "prepare/<hash of their inputs>"; unchanged without [prepare]. Throws Error like inputs_of() of a
// preparation.
Campaign branched(Campaign campaign, const PluginHost& host);

// Throws Error, like scree check, unless the point can be run and has all collected quantities; at the
// setting that causes the error, if one does.
void check_point(const Campaign& campaign, const Point& point, PluginHost& host,
                 const scenario::StudyTables& studies = {});
// The same for a point of a preparation, which must write its final state. Returns the bodies at its start.
std::vector<Body> check_preparation(const Campaign& preparation, const Point& point, PluginHost& host,
                                    const scenario::StudyTables& studies = {});
// Refuses keys of the settings and of the scenario that nothing reads, as far as they are known before the
// preparation of the point, which begins with these bodies, has been run.
void check_keys(const Campaign& campaign, const Point& point, const std::vector<Body>& bodies,
                PluginHost& host, const scenario::StudyTables& studies = {});

}  // namespace scree::campaign
