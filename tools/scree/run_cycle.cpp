#include "run_cycle.hpp"

#include <fmt/format.h>

#include <scree/document/document.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/record_json.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

// Of the quasi-static course of the last stage.
RunCycles course_of(const fs::path& file, double period) {
  const auto record = run::parse_record(files::read_text(file));
  for (const char* key : {"start", "end"})
    if (!record.is_object() || !record.contains(key) || !record[key].is_number())
      throw Error(fmt::format("{}: has no {}; analyse a series with --csv", file.string(), key));
  return {{period, record["start"]}, record["end"]};
}

// stage: its number in the scenario, from 0.
RunCycles stage_of(const fs::path& directory, std::size_t stage, double period) {
  if (fs::exists(directory / "response.json")) return course_of(directory / "response.json", period);
  const fs::path file = directory / "run.json";
  const auto record = run::parse_record(files::read_text(file));
  if (!record.is_object() || !record.contains("stages") || !record["stages"].is_array())
    throw Error(fmt::format("{}: is not the record of a run; analyse a series with --csv", file.string()));
  if (stage >= record["stages"].size())
    throw Error(fmt::format("{}: stage {}, which has the period, has not run; let it go on with scree resume",
                            file.string(), stage + 1));
  const auto& times = record["stages"][stage];
  for (const char* key : {"start", "end"})
    if (!times.is_object() || !times.contains(key) || !times[key].is_number())
      throw Error(
          fmt::format("{}: stage {} has no {}; analyse a series with --csv", file.string(), stage + 1, key));
  return {{period, times["start"]}, times["end"]};
}

}  // namespace

std::optional<RunCycles> cycles_of_run(const fs::path& directory) {
  const document::Document scenario = document::Document::load(directory / "scenario.toml");
  const std::vector<document::Table> stages = scenario.root().tables("stage");
  for (std::size_t k = stages.size(); k-- > 0;)
    if (stages[k].is_number("period"))
      return stage_of(directory, k, stages[k].number("period", document::Range::positive("s")));
  return std::nullopt;
}

}  // namespace scree::tool
