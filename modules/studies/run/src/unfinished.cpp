#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/document/document.hpp>
#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/scene_record.hpp>
#include <scree/state_error.hpp>
#include <scree/state_file/state_file.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

namespace {

using OnWarning = std::function<void(const std::string&)>;
namespace fs = std::filesystem;

bool is_there(const fs::path& file) {
  std::error_code failed;
  return fs::exists(file, failed);
}

// A text of a record, or nothing.
std::string text_of(const nlohmann::ordered_json& record, const char* name) {
  return record.is_object() && record.contains(name) && record[name].is_string()
             ? record[name].get<std::string>()
             : "";
}

RunDirectory directory_of(const fs::path& path, const ResultKind& kind, const OnWarning& on_warning) {
  if (!has_results(path, kind))
    throw Error(fmt::format("{}: contains no {}; give the directory of one", path.string(), kind.noun));
  RunDirectory directory(path, RunDirectory::Existing::keep, kind.directory);
  directory.take();
  directory.report_lock(on_warning);
  return directory;
}

using document::Document;

// Paths of files of bodies by their keys, "particles[1].file".
std::map<std::string, std::string> body_paths(const Document& document) {
  std::map<std::string, std::string> paths;
  const auto add = [&](const document::Table& table, const char* key) {
    if (table.is_string(key)) paths[fmt::format("{}.{}", table.path(), key)] = table.string(key);
  };
  for (const document::Table& boundary : document.root().tables("boundary")) add(boundary, "file");
  for (const document::Table& particles : document.root().tables("particles")) {
    for (const char* key : {"file", "state"}) add(particles, key);
    if (particles.is_table("springs")) add(particles.table("springs"), "file");
  }
  return paths;
}

// The scenario with which results began, with the paths of the present file where they name the same file of
// bodies.
std::string with_paths_of(const Document& now, const std::string& began) {
  std::vector<std::string> paths;
  const std::map<std::string, std::string> present = body_paths(now);
  for (const auto& [key, before] : body_paths(Document::parse(began, scenario_file))) {
    const auto path = present.find(key);
    if (path != present.end() && fs::path(before).filename() == fs::path(path->second).filename())
      paths.push_back(fmt::format("{}=\"{}\"", key, files::escaped(path->second, files::Escapes::toml)));
  }
  return Document::parse(began, scenario_file, paths).resolved_text();
}

}  // namespace

std::string restored_scenario(const fs::path& directory, const std::string& began,
                              const std::function<void(const std::string&)>& on_warning) {
  const fs::path file = directory / scenario_file;
  std::string restored = began;
  try {
    const Document now = Document::load(file);
    restored = with_paths_of(now, began);
    if (now.resolved_text() == restored) return "";
  } catch (const Error&) {
    // It was removed, or is no scenario any more.
  }
  if (on_warning)
    on_warning(fmt::format(
        "{}: is not the scenario with which these results began; they go on with that one, and the file is "
        "written anew; to change values, begin a new run from a state (particles.state)",
        file.string()));
  return restored;
}

Unfinished unfinished_in(const fs::path& path, const ResultKind& kind, PluginHost& host,
                         const OnWarning& on_warning) {
  RunDirectory taken = directory_of(path, kind, on_warning);
  const fs::path& directory = taken.path();
  const auto record = parse_record(files::read_text(directory / kind.record));
  if (text_of(record, "status") == "finished")
    throw Error(fmt::format("{}: the {} is finished; give --overwrite with the scenario to run it again",
                            directory.string(), kind.noun));
  const fs::path file = directory / kind.state;
  if (!is_there(file))
    throw Error(fmt::format(
        "{}: no saved state to resume the {} from; give --overwrite with the scenario to run it again",
        directory.string(), kind.noun));
  State state = state_file::read_state(file);
  std::string text;
  const StateTransfer of_kind = StateTransfer::restoring_from(state).below(kind.group);
  if (!of_kind.has("scenario"))
    throw Error(fmt::format(
        "{}: is not the state of a {}; put back that of this directory, or give --overwrite with the "
        "scenario to run it again",
        file.string(), kind.noun));
  with_state_of(file.string(), [&] { of_kind.value("scenario", "", text); });
  if (const std::string own = text_of(record, "scenario"); !own.empty() && own != text)
    throw Error(fmt::format(
        "{}: is the state of another {} than that in {}; put back the one of this directory, or give --overwrite with the "
        "scenario to run it again",
        file.string(), kind.noun, kind.record));
  const RecordedBodies bodies = with_state_of(file.string(), [&] { return recorded_bodies(state); });
  scenario::Plan plan = scenario::read_plan_again(text, file.string() + " (scenario)", {}, bodies, host);
  plan.text_for_any_folder = restored_scenario(directory, text, on_warning);
  return {std::move(taken), std::move(state), file, std::move(plan)};
}

}  // namespace scree::run
