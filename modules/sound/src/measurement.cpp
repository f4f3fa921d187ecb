#include "course.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/scene_record.hpp>
#include <scree/sound/measurement.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::sound {

namespace {

namespace fs = std::filesystem;
using run::RunDirectory;

// A text of spectrum.json, or nothing.
std::string recorded(const fs::path& directory, const char* name) {
  const auto json = nlohmann::json::parse(files::read_text(directory / "spectrum.json"), nullptr, false);
  return json.is_object() && json.contains(name) && json[name].is_string() ? json[name].get<std::string>()
                                                                           : "";
}

}  // namespace

Measurement measure(const scenario::Plan& plan, const MeasurementOptions& options) {
  if (!plan.spectrum)
    throw Error(fmt::format(
        "{}: has no [spectrum]; add one with drive, amplitude, observe, from_hz, to_hz and step_hz",
        plan.source.string()));
  RunDirectory directory = RunDirectory::of_results(options.out, options.overwrite, plan.source, plan.inputs,
                                                    RunDirectory::Kind::spectrum);
  return Course(plan, options, directory).begin();
}

bool is_measurement(const fs::path& directory) {
  std::error_code failed;
  return fs::exists(directory / "spectrum.json", failed);
}

namespace {

Measurement go_on(const MeasurementOptions& options, PluginHost& host) {
  if (!is_measurement(options.out))
    throw Error(fmt::format("{}: contains no spectrum; give the directory of one", options.out.string()));
  RunDirectory directory(options.out, RunDirectory::Existing::keep, RunDirectory::Kind::spectrum);
  directory.take();
  if (recorded(options.out, "status") == "finished")
    throw Error(
        fmt::format("{}: the spectrum is finished; give --overwrite with the scenario to measure it again",
                    options.out.string()));
  const fs::path file = options.out / Course::state_name;
  if (std::error_code failed; !fs::exists(file, failed))
    throw Error(fmt::format("{}: there is no state yet; measure the scenario again with --overwrite",
                            options.out.string()));
  const State state = state_file::read_state(file);
  std::string text;
  StateTransfer::restoring_from(state).below("spectrum").value("scenario", "", text);
  if (const std::string own = recorded(options.out, "scenario"); !own.empty() && own != text)
    throw Error(fmt::format(
        "{}: is the state of another spectrum than that in spectrum.json; put back the one of this directory, or measure the "
        "scenario again with --overwrite",
        file.string()));
  const scenario::Plan plan =
      scenario::read_plan_again(text, file.string() + " (scenario)", {}, bodies_at_start(state), host);
  return Course(plan, options, directory).resume(state);
}

}  // namespace

Measurement resume_measurement(const MeasurementOptions& options, PluginHost& host) {
  return files::in_place([&] { return go_on(options, host); });
}

}  // namespace scree::sound
