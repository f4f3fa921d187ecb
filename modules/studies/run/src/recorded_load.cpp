#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/document/document.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/recorded_load.hpp>
#include <scree/run/result_kind.hpp>

namespace scree::run {

namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

// place: what the error names.
double number_in(const Json& times, const char* key, const std::string& place) {
  if (!times.is_object() || !times.contains(key) || !times[key].is_number())
    throw Error(fmt::format("{} has no {}; analyse a series with --csv", place, key));
  return times[key];
}

// Why a run or a stage stopped before its end; empty if it did not. key: of the status in its record.
std::string unfinished(const Json& record, const char* key) {
  for (const char* status : {"running", "interrupted", "failed"})
    if (record.is_object() && record.contains(key) && record[key] == status) return status;
  return "";
}

// The load of a quasi-static result, which follows the last stage.
RecordedLoad quasi_static_load(const fs::path& file) {
  const Json record = parse_record(files::read_text(file));
  const std::string place = file.string() + ":";
  return {number_in(record, "period", place), number_in(record, "start", place),
          number_in(record, "end", place), unfinished(record, "status")};
}

// stage: its number in the scenario, from 0.
RecordedLoad stage_load(const fs::path& file, std::size_t stage, double period) {
  const Json record = parse_record(files::read_text(file));
  if (!record.is_object() || !record.contains("stages") || !record["stages"].is_array())
    throw Error(fmt::format("{}: is not the record of a run; analyse a series with --csv", file.string()));
  if (stage >= record["stages"].size())
    throw Error(fmt::format("{}: stage {}, which has the period, has not run; let it go on with scree resume",
                            file.string(), stage + 1));
  const Json& times = record["stages"][stage];
  const std::string place = fmt::format("{}: stage {}", file.string(), stage + 1);
  std::string status = unfinished(times, "ended");
  if (status.empty() && stage + 1 == record["stages"].size()) status = unfinished(record, "status");
  // A record written while the stage ran may be older than the series, which has no rows of later stages
  // then.
  const double end = number_in(times, "end", place);
  return {period, number_in(times, "start", place), status.empty() ? end : std::numeric_limits<double>::max(),
          status};
}

}  // namespace

std::optional<RecordedLoad> recorded_load(const fs::path& directory) {
  if (fs::exists(directory / "quasi_static.json")) return quasi_static_load(directory / "quasi_static.json");
  const document::Document scenario = document::Document::load(directory / "scenario.toml");
  const std::vector<document::Table> stages = scenario.root().tables("stage");
  for (std::size_t k = stages.size(); k-- > 0;)
    if (stages[k].is_number("period"))
      return stage_load(directory / "run.json", k,
                        stages[k].number("period", document::Range::positive("s")));
  return std::nullopt;
}

std::string unfinished_status(const fs::path& directory) {
  for (const char* name : {"quasi_static.json", "run.json"}) {
    std::error_code failed;
    if (fs::exists(directory / name, failed))
      return unfinished(parse_record(files::read_text(directory / name)), "status");
  }
  return "";
}

}  // namespace scree::run
