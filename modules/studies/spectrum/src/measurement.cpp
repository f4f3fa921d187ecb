#include "course.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/place_error.hpp>
#include <scree/spectrum/measurement.hpp>

namespace scree::spectrum {

using run::RunDirectory;

Measurement measure(const scenario::Plan& plan, const MeasurementOptions& options) {
  const auto spectrum = read_spectrum(plan);
  if (!spectrum)
    throw Error(fmt::format(
        "{}: has no [spectrum]; add one with drive, amplitude, observe, from_hz, to_hz and step_hz",
        plan.source.string()));
  RunDirectory directory = RunDirectory::of_results(options.out, options.overwrite, plan.source, plan.inputs,
                                                    RunDirectory::Kind::spectrum);
  directory.report_lock(options.on_warning);
  return Course(plan, *spectrum, options, directory).begin();
}

bool is_measurement(const std::filesystem::path& directory) {
  return run::has_results(directory, Course::results);
}

Measurement resume_measurement(const MeasurementOptions& options, PluginHost& host) {
  return files::in_place([&] {
    RunDirectory directory = run::directory_of(options.out, Course::results, options.on_warning);
    const run::Unfinished from = run::unfinished_in(directory, Course::results, host, options.on_warning);
    const auto spectrum = read_spectrum(from.plan);
    if (!spectrum)
      throw Error(fmt::format("{}: its scenario has no [spectrum]; take a state that scree has written there",
                              (directory.path() / Course::results.state).string()));
    return Course(from.plan, *spectrum, options, directory).resume(from.state);
  });
}

}  // namespace scree::spectrum
