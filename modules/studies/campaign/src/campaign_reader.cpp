#include "points.hpp"
#include "settings.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include <scree/campaign/campaign.hpp>
#include <scree/document/document.hpp>
#include <scree/document/message.hpp>
#include <scree/files/text.hpp>

namespace scree::campaign {

namespace {

using document::Document;
using document::Range;
using document::Table;
using files::one_line;

constexpr std::size_t max_runs = 100000;
const char* const seeds_form = "give whole numbers, [1, 2, 3], or { first = 1, count = 20 }";

// Seeds { first, count }.
std::vector<std::int64_t> seed_range(const Table& table) {
  const std::int64_t first = table.integer("first", 1, Range::between(0, 1e15));
  const std::int64_t count = table.integer("count", Range::between(1, double(max_runs)));
  std::vector<std::int64_t> seeds;
  for (std::int64_t k = 0; k < count; ++k) seeds.push_back(first + k);
  return seeds;
}

std::vector<std::int64_t> read_seeds(const Table& table) {
  if (!table.optional("seeds")) return {};
  if (table.is_table("seeds")) return seed_range(table.table("seeds"));
  if (!table.is_array("seeds")) throw table.error("seeds", "seeds is neither a list nor a table", seeds_form);
  std::vector<std::int64_t> seeds = table.integers("seeds", Range::non_negative());
  if (seeds.empty()) throw table.error("seeds", "the list of seeds is empty", seeds_form);
  if (seeds.size() > max_runs)
    throw table.error("seeds", fmt::format("there are more than {} seeds", max_runs),
                      "give fewer, or several campaigns");
  std::set<std::int64_t> used;
  for (std::size_t k = 0; k < seeds.size(); ++k)
    if (!used.insert(seeds[k]).second)
      throw table.error("seeds", k, fmt::format("seed {} appears twice in the list", seeds[k]),
                        "remove one; the same seed gives the same run");
  return seeds;
}

std::vector<Case> read_cases(const Table& root) {
  std::vector<Case> cases;
  std::set<std::string> names;
  for (const Table& table : root.tables("case")) {
    Case one{table.string("name"), {}, {}};
    if (one.name.empty()) throw table.error("name", "the name of the case is empty", "give a name");
    if (!names.insert(one.name).second)
      throw table.error("name", fmt::format("the case name '{}' is already in use", one_line(one.name)),
                        "give each a different name");
    if (const auto set = table.optional_table("set")) one.settings = read_case_settings(*set);
    if (const auto set = table.optional_table("prepare")) one.preparation = read_case_settings(*set);
    cases.push_back(std::move(one));
  }
  return cases;
}

Error set_elsewhere(const Setting& setting, const char* where) {
  return Error(setting.place, fmt::format("'{}' is also set by {}", one_line(setting.key), where),
               "keep one of the two");
}

// Each key must have a single source, so that the table columns are unambiguous.
void check_sources(const Campaign& c) {
  std::set<std::string> keys;
  for (const Setting& setting : c.fixed) keys.insert(setting.key);
  for (const Parameter& parameter : c.parameters) {
    keys.insert(parameter.key);
    if (parameter.key == "scene.seed")
      throw Error(parameter.values.front().place, "scene.seed cannot be in [set]",
                  "write seeds = [...] in [campaign]");
  }
  const auto check = [&](const Setting& setting) {
    if (!c.seeds.empty() && setting.key == "scene.seed") throw set_elsewhere(setting, "seeds");
    if (c.preparation && setting.key == c.state_key) throw set_elsewhere(setting, "[prepare]");
  };
  for (const Setting& setting : c.fixed) check(setting);
  for (const Parameter& parameter : c.parameters) check(parameter.values.front());
  for (const Case& one : c.cases)
    for (const Setting& setting : one.settings) {
      check(setting);
      if (keys.contains(setting.key)) throw set_elsewhere(setting, "[set] or --set");
    }
}

// Checks only that the file can be read; its content is checked for each run.
void check_scenario(const Campaign& c) {
  std::error_code failed;
  const std::filesystem::file_status status = std::filesystem::status(c.scenario, failed);
  // Each run reads the scenario again, which a pipe gives only once.
  if (std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status))
    throw Error(c.scenario_place, fmt::format("{} is not a regular file", c.scenario.string()),
                "give a file that can be read several times");
  try {
    Document::load(c.scenario);
  } catch (const Error& error) {
    throw error.at(c.scenario_place);
  }
}

void check_count(const Table& root, const Campaign& c) {
  if (count_points(c, max_runs) <= max_runs) return;
  throw root.error("campaign", fmt::format("the campaign has more than {} runs", max_runs),
                   "give fewer values or seeds, or several campaigns");
}

// Overrides of the command line, by what they change.
struct Overrides {
  std::vector<std::string> campaign;     // and [slurm], as for Document
  std::vector<std::string> preparation;  // without "prepare."
  std::vector<std::string> runs;

  explicit Overrides(const std::vector<std::string>& all) {
    const std::string of_preparation = "prepare.";
    for (const std::string& text : all) {
      if (text.starts_with("campaign.") || text.starts_with("slurm."))
        campaign.push_back(text);
      else if (text.starts_with(of_preparation))
        preparation.push_back(text.substr(of_preparation.size()));
      else
        runs.push_back(text);
    }
  }
};

// The points of [prepare] are named by branched().
std::shared_ptr<const Campaign> read_preparation(const Table& root, const Campaign& c,
                                                 const std::string& seeds_place,
                                                 const std::vector<std::string>& overrides) {
  const auto table = root.optional_table("prepare");
  if (!table) {
    if (!overrides.empty())
      throw Error(fmt::format("--set prepare.{}", one_line(overrides.front())),
                  "the campaign has no [prepare]", "leave \"prepare.\" out");
    for (const Case& one : c.cases)
      if (!one.preparation.empty())
        throw Error(one.preparation.front().place,
                    fmt::format("a case sets '{}' of its preparation, but there is no [prepare]",
                                one_line(one.preparation.front().key)),
                    "add one with scenario");
    return nullptr;
  }
  const auto preparation = std::make_shared<Campaign>();
  preparation->source = c.source;
  preparation->scenario = c.source.parent_path() / table->string("scenario");
  preparation->scenario_place = table->place("scenario");
  check_scenario(*preparation);
  if (const auto set = table->optional_table("set")) preparation->fixed = read_case_settings(*set);
  for (const std::string& text : overrides) replace_setting(preparation->fixed, text);
  preparation->seeds = c.seeds;
  if (std::any_of(c.cases.begin(), c.cases.end(), [](const Case& one) { return !one.preparation.empty(); }))
    for (const Case& one : c.cases) preparation->cases.push_back({one.name, one.preparation, {}});
  check_sources(*preparation);
  preparation->points = make_points(*preparation, seeds_place);
  for (Point& point : preparation->points) point.name = "prepare";
  return preparation;
}

// The key by which the scenario takes the state of its preparation: of its only [[particles]], or of the one
// without a lattice, file or random.
std::string state_key_of(const Campaign& c) {
  const Document document = Document::load(c.scenario);
  const std::vector<Table> all = document.root().tables("particles");
  if (all.size() < 2) return c.state_key;
  std::vector<std::string> free;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!all[k].has("lattice") && !all[k].has("file") && !all[k].has("random"))
      free.push_back(fmt::format("particles[{}].state", k));
  if (free.size() == 1) return free.front();
  throw Error(c.scenario_place,
              fmt::format("{} of its {} tables [[particles]] can take the state of [prepare]",
                          free.empty() ? "none" : "more than one", all.size()),
              "leave lattice, file and random out of one of them");
}

// Cases vary slowest, seeds fastest.
std::vector<std::size_t> preparations_of(const Campaign& c) {
  std::vector<std::size_t> all;
  const std::size_t seeds = std::max<std::size_t>(1, c.seeds.size());
  const std::size_t points_each = c.points.size() / std::max<std::size_t>(1, c.preparation->cases.size());
  for (std::size_t k = 0; k < c.points.size(); ++k) all.push_back(k / points_each * seeds + k % seeds);
  return all;
}

// Methods of spectra instead of runs.
std::string read_methods(const Table& table) {
  if (!table.optional("spectrum")) return "";
  const std::string methods = table.string("spectrum");
  for (const char* known : {"sweep", "pulse", "linear", "all"})
    if (methods == known) return methods;
  throw table.error("spectrum", fmt::format("there is no method '{}'", one_line(methods)),
                    "give \"sweep\", \"pulse\", \"linear\" or \"all\", as for scree spectrum --by");
}

SlurmTable read_slurm(const Table& table) {
  SlurmTable slurm;
  const auto text = [&](const char* key) { return table.optional(key) ? table.string(key) : std::string(); };
  slurm.partition = text("partition");
  slurm.time = text("time");
  slurm.memory = text("memory");
  slurm.account = text("account");
  slurm.qos = text("qos");
  slurm.constraint = text("constraint");
  if (table.optional("options")) slurm.options = table.strings("options");
  for (std::size_t k = 0; k < slurm.options.size(); ++k)
    if (!slurm.options[k].starts_with('-'))
      throw table.error("options", k, fmt::format("'{}' is no option of sbatch", one_line(slurm.options[k])),
                        "write each as one text, \"--mail-type=END\"");
  return slurm;
}

// Quantities, a column of the table each.
std::vector<std::string> read_collected(const Table& table) {
  const std::vector<std::string> names = table.strings("collect");
  std::set<std::string> used;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (!used.insert(names[k]).second)
      throw table.error("collect", k, fmt::format("'{}' appears twice in the list", one_line(names[k])),
                        "remove one");
  return names;
}

}  // namespace

Campaign read_campaign(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  const Overrides given(overrides);
  const Document document =
      Document::load(path, given.campaign, "write a campaign: [campaign] with scenario = \"<file>\", [set]");
  const Table root = document.root(), table = root.table("campaign");
  Campaign c;
  c.source = path;
  c.title = table.string("title", path.stem().string());
  c.scenario = path.parent_path() / table.string("scenario");
  c.scenario_place = table.place("scenario");
  check_scenario(c);
  c.methods = read_methods(table);
  if (table.optional("collect")) c.collect = read_collected(table);
  c.collect_place = table.place("collect");
  if (!c.methods.empty() && !c.collect.empty())
    throw table.error("collect", "spectra have no series to collect from",
                      "remove it; their peaks are in the table");
  c.seeds = read_seeds(table);
  Settings settings = read_settings(root.table_or_empty("set"));
  for (const std::string& text : given.runs) replace_setting(settings, text);
  c.fixed = std::move(settings.fixed);
  c.parameters = std::move(settings.parameters);
  c.cases = read_cases(root);
  c.slurm = read_slurm(root.table_or_empty("slurm"));
  c.preparation = read_preparation(root, c, table.place("seeds"), given.preparation);
  document.refuse_unused();
  if (c.preparation) c.state_key = state_key_of(c);
  check_sources(c);
  check_count(root, c);
  c.points = make_points(c, table.place("seeds"));
  if (c.preparation) c.preparation_of = preparations_of(c);
  return c;
}

}  // namespace scree::campaign
