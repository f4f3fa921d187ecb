#include "scenario_file.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/record_json.hpp>
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

}  // namespace

bool has_results(const fs::path& directory, const ResultKind& kind) {
  return is_there(directory / kind.record);
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
  const std::vector<Body> bodies = with_state_of(file.string(), [&] { return bodies_at_start(state); });
  scenario::Plan plan = scenario::read_plan_again(text, file.string() + " (scenario)", {}, bodies, host);
  plan.text_for_any_folder = restored_scenario(directory, text, on_warning);
  return {std::move(taken), std::move(state), file, std::move(plan)};
}

}  // namespace scree::run
