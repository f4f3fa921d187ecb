#include "studies/measurement_report.hpp"
#include "studies/spectrum_files.hpp"
#include "studies/studies.hpp"
#include "support/progress_bar.hpp"
#include "support/spectrum_arguments.hpp"
#include "support/study_tables.hpp"
#include "support/verbs.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>
#include <scree/signals/amplitude_spectrum.hpp>
#include <scree/signals/lock_in.hpp>
#include <scree/signals/time_series.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t least_samples = 8, most_lines = 5;
constexpr double tolerated_unevenness = 1e-3;

LockInOptions options_of(const SpectrumArguments& arguments, const signals::TimeSeries& series) {
  const auto degree =
      std::find(detrendings.begin(), detrendings.end(), arguments.detrend) - detrendings.begin();
  LockInOptions options;
  options.frequency = arguments.frequency;
  options.duration = series.duration();
  options.drift_degree = degree > 3 ? 0 : int(degree);
  // Within 1/duration of half the sampling rate, sine and cosine are hardly told apart.
  const double highest = 0.5 / series.mean_step() - 1 / series.duration();
  while (options.harmonics > 1 && options.harmonics * arguments.frequency > highest) --options.harmonics;
  return options;
}

// A frequency about which the record says nothing is refused.
void check_frequency(const SpectrumArguments& arguments, const signals::TimeSeries& series) {
  if (arguments.frequency == 0) return;
  const double half_rate = 0.5 / series.mean_step();
  if (arguments.frequency >= half_rate)
    throw Error(
        fmt::format("{}: --frequency {} is not below half the sampling rate, {:.10g} Hz; sample more often",
                    arguments.csv, arguments.frequency, half_rate));
  const double periods = arguments.detrend == "period-average" ? 2 : 1;
  if (arguments.frequency * series.duration() < periods * (1 - 1e-9))
    throw Error(
        fmt::format("{}: --frequency {} has less than {} in the record of {:.10g} s; give {} Hz or more, "
                    "or a longer record",
                    arguments.csv, arguments.frequency, periods > 1 ? "two periods" : "a period",
                    series.duration(), fmt::format("{:.10g}", periods / series.duration())));
}

std::string density_unit(const std::string& unit) {
  return unit.empty() || unit == "1" ? "1/Hz" : fmt::format("({})^2/Hz", files::one_line(unit));
}

// Lines with their frequencies as given have no error of these.
bool is_given(const signals::FoundLine& line) { return line.frequency_error == 0; }

bool decay(const std::vector<signals::FoundLine>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.quality > 0; });
}

void print_head(const SpectrumArguments& arguments, const signals::TimeSeries& series, double unevenness,
                bool with_quality) {
  fmt::print("{}: {}, {:.10g} s to {:.10g} s, {}step {:.10g} s, drift: {}\n",
             signals::with_unit(series.name, series.unit), counted(series.times.size(), "sample"),
             series.times.front(), series.times.back(), unevenness > tolerated_unevenness ? "mean " : "",
             series.mean_step(), arguments.frequency > 0 ? arguments.detrend : "cubic and relaxation");
  const std::string unit = series.unit.empty() ? "" : fmt::format(" [{}]", files::one_line(series.unit));
  fmt::print("{:>18} {:>18} {:>18} {:>18} {:>18} {:>18}{}\n", "frequency [Hz]", "error [Hz]",
             "amplitude" + unit, "error" + unit, "phase [rad]", "error [rad]",
             with_quality ? fmt::format(" {:>18} {:>18}", "Q", "error") : "");
}

void print_line(const signals::FoundLine& line) {
  const auto text = [](double number, bool is_known) {
    return is_known ? fmt::format("{:.10g}", number) : std::string("-");
  };
  fmt::print("{:>18.10g} {:>18} {:>18.10g} {:>18.10g} {:>18.10g} {:>18.10g}", line.frequency,
             text(line.frequency_error, !is_given(line)), line.amplitude, line.amplitude_error, line.phase,
             line.phase_error);
  if (line.quality > 0) fmt::print(" {:>18.10g} {:>18.10g}", line.quality, line.quality_error);
  fmt::print("\n");
}

LockInResult harmonics_of(const SpectrumArguments& arguments, const signals::TimeSeries& series) {
  using signals::Detrending;
  const auto detrending =
      arguments.detrend == "period-average" ? Detrending::period_average : Detrending::polynomial;
  try {
    return lock_in(series.times, series.values, options_of(arguments, series), detrending);
  } catch (const Error& error) {
    throw error.at(arguments.csv);
  }
}

std::vector<signals::FoundLine> lines_of(const SpectrumArguments& arguments,
                                         const signals::TimeSeries& series,
                                         const signals::AmplitudeSpectrum& amplitudes) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  ProgressBar bar(arguments.quiet);
  return strongest_lines(series.times, series.values, amplitudes, most_lines, [&](double share) {
    bar.show(share, std::chrono::duration<double>(Clock::now() - began).count(), "fitting lines");
  });
}

// Prints the lines and returns them.
std::vector<signals::FoundLine> report_lines(const SpectrumArguments& arguments,
                                             const signals::TimeSeries& series,
                                             const signals::AmplitudeSpectrum& amplitudes,
                                             double unevenness) {
  std::vector<signals::FoundLine> lines;
  if (!(arguments.frequency > 0)) {
    lines = lines_of(arguments, series, amplitudes);
    print_head(arguments, series, unevenness, decay(lines));
    for (const signals::FoundLine& line : lines) print_line(line);
    if (lines.empty()) fmt::print("no line of three or more periods stands out of the noise\n");
    return lines;
  }
  const LockInResult result = harmonics_of(arguments, series);
  print_head(arguments, series, unevenness, false);
  for (std::size_t k = 0; k < result.harmonics; ++k)
    print_line(lines.emplace_back(signals::FoundLine{result.lines[k]}));
  fmt::print("mean {:.10g}, rms of the rest {:.10g}, noise density at {:.10g} Hz {:.10g} {}\n", result.mean,
             result.residual_rms, arguments.frequency, result.lines[0].noise_density,
             density_unit(series.unit));
  return lines;
}

ExitStatus analyse(const SpectrumArguments& arguments) {
  const fs::path folder =
      arguments.out.empty() ? fs::path(arguments.csv).parent_path() : fs::path(arguments.out);
  const SpectrumFiles files(folder, arguments.csv, arguments.overwrite);
  const signals::TimeSeries series =
      signals::read_time_series(arguments.csv, arguments.column, least_samples);
  if (series.cut_line > 0)
    report_warning(fmt::format("{}: {}", arguments.csv, signals::cut_line_warning(series.cut_line)));
  check_frequency(arguments, series);
  const double unevenness = signals::unevenness(series.times);
  const signals::AmplitudeSpectrum amplitudes =
      unevenness > tolerated_unevenness
          ? signals::amplitude_spectrum(series.mean_step(),
                                        signals::at_equal_steps(series.times, series.values))
          : signals::amplitude_spectrum(series.mean_step(), series.values);
  const std::vector<signals::FoundLine> lines = report_lines(arguments, series, amplitudes, unevenness);
  if (unevenness > tolerated_unevenness)
    report_warning(fmt::format(
        "{}: the steps differ, so {} is of straight lines between samples; lines above are of the samples "
        "themselves",
        arguments.csv, SpectrumFiles::table_name));
  files.write(amplitudes, series, lines);
  return ExitStatus::success;
}

std::vector<spectrum::Method> methods_of(const std::string& by) {
  using enum spectrum::Method;
  if (by == "all") return {linear, pulse, sweep};
  return {by == "linear" ? linear : by == "pulse" ? pulse : sweep};  // the default
}

ExitStatus measure(const SpectrumArguments& arguments) {
  PluginHost host = make_host(arguments.plugins);
  return report_measurement(arguments.quiet, [&](spectrum::MeasurementOptions options) {
    options.out = arguments.out;
    options.overwrite = arguments.overwrite;
    options.threads = arguments.threads;
    options.methods = methods_of(arguments.by);
    if (arguments.resume) return spectrum::resume_measurement(options, host);
    return spectrum::measure(
        scenario::read_plan(arguments.scenario, arguments.overrides, host, study_tables()), options);
  });
}

ExitStatus spectrum_of(const SpectrumArguments& arguments) {
  const bool of_file = !arguments.csv.empty();
  if (of_file && (!arguments.scenario.empty() || arguments.resume))
    throw Error("--csv analyses a file, not a scenario; give one of them");
  if (of_file && (!arguments.by.empty() || !arguments.overrides.empty()))
    throw Error("--csv analyses a file, which has no --by and --set; leave them out");
  if (!of_file && (!arguments.column.empty() || arguments.frequency > 0))
    throw Error("--column and --frequency are of a file; give --csv FILE, or [spectrum] of the scenario");
  if (of_file && arguments.column.empty()) throw Error("--csv without --column; give --column NAME");
  if (of_file) return analyse(arguments);
  const bool began_otherwise =
      !arguments.scenario.empty() || !arguments.by.empty() || !arguments.overrides.empty();
  if (arguments.resume && began_otherwise)
    throw Error("--resume goes on with what the spectrum began with; leave the scenario, --by and --set out");
  if (arguments.resume && arguments.out.empty())
    throw Error("--resume without --out; give --out with the directory of the spectrum");
  if (!arguments.resume && arguments.scenario.empty())
    throw Error("neither a scenario nor --csv; give a scenario with [spectrum], or --csv FILE --column NAME");
  if (arguments.scenario.ends_with(".csv"))
    throw Error(fmt::format("{0}: is a time series; give it as --csv {0} --column NAME", arguments.scenario));
  return measure(arguments);
}

}  // namespace

void add_spectrum_verb(CommandLine& line) {
  auto a = std::make_shared<SpectrumArguments>();
  Verb verb = add_spectrum_options(line, *a);
  verb.action([a] { return spectrum_of(*a); });
}

}  // namespace scree::tool
