#include "studies/measurement_report.hpp"

#include "support/verdict_report.hpp"
#include "support/watched_work.hpp"

#include <filesystem>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

std::string written_in(const std::filesystem::path& directory) {
  std::string names;
  for (const char* name : {"spectrum.csv", "peaks.csv", "shapes.csv", "sweep.csv", "methods.csv", "charts"})
    if (std::filesystem::exists(directory / name))
      names += fmt::format("{}{}", names.empty() ? ": " : ", ", name);
  return names;
}

}  // namespace

ExitStatus report_measurement(
    bool quiet, const std::function<spectrum::Measurement(spectrum::MeasurementOptions)>& work) {
  const spectrum::Measurement measurement = watch<spectrum::MeasurementOptions>(quiet, work);
  if (!quiet) fmt::print("{}", files::escaped(spectrum::text_report(measurement), files::Escapes::lines));
  const bool met = report_verdicts(measurement.verdicts, quiet);
  if (measurement.interrupted)
    fmt::print("interrupted; results so far are saved, go on with: scree resume {}\n",
               measurement.directory.string());
  fmt::print("results in {}{}\n", files::escaped(measurement.directory.string()),
             written_in(measurement.directory));
  if (measurement.interrupted) return ExitStatus::interrupted;
  return met ? ExitStatus::success : ExitStatus::failure;
}

}  // namespace scree::tool
