#include "measurement_report.hpp"

#include "progress_bar.hpp"
#include "verbs.hpp"
#include "verdict_report.hpp"

#include <memory>

#include <fmt/format.h>

namespace scree::tool {

namespace {

sound::Measurement with_progress(bool quiet,
                                 const std::function<sound::Measurement(sound::MeasurementOptions)>& work) {
  ProgressBar bar(quiet);
  // Cleared also where an error leaves, so that its line stands alone.
  const std::shared_ptr<void> clearing(nullptr, [&bar](void*) { bar.clear(); });
  sound::MeasurementOptions options;
  options.stop = &watch_for_interrupt();
  options.on_progress = [&bar](double share, double wall, const std::string& what) {
    bar.show(share, wall, what);
  };
  options.on_warning = [&bar](const std::string& line) {
    bar.clear();
    report_warning(line);
  };
  return work(options);
}

}  // namespace

ExitStatus report_measurement(bool quiet,
                              const std::function<sound::Measurement(sound::MeasurementOptions)>& work) {
  const sound::Measurement measurement = with_progress(quiet, work);
  if (!quiet) fmt::print("{}", sound::text_report(measurement));
  const bool met = report_verdicts(measurement.verdicts, quiet);
  if (measurement.interrupted)
    fmt::print("interrupted; results so far are saved, go on with: scree resume {}\n",
               measurement.directory.string());
  fmt::print("results in {}: spectrum.csv, peaks.csv, roads.csv, charts/\n", measurement.directory.string());
  if (measurement.interrupted) return ExitStatus::interrupted;
  return met ? ExitStatus::success : ExitStatus::failure;
}

}  // namespace scree::tool
