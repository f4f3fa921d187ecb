#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <scree/plugin_host.hpp>
#include <scree/run/input_hashes.hpp>
#include <scree/run/verdict.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/spectrum/method_spectrum.hpp>
#include <scree/spectrum/peak.hpp>

namespace scree::spectrum {

struct MeasurementOptions {
  std::filesystem::path out;  // empty: runs/<stem of the scenario>-spectrum, numbered if it exists
  bool overwrite = false;
  unsigned threads = 1;
  std::vector<Method> methods = {Method::sweep};
  std::function<void(double share, double wall_time, const std::string& what)> on_progress;
  std::function<void(const std::string&)> on_warning;  // one line "<what>; <cure>"
  const std::atomic<bool>* stop = nullptr;             // set by Ctrl-C: what is complete is saved
};

// The spectrum of a packing by one or more methods.
struct Measurement {
  std::filesystem::path directory;
  std::string title;
  std::vector<ObservedColumn> observed;
  std::vector<MethodSpectrum> spectra;
  std::vector<Peak> peaks;
  bool interrupted = false;
  run::InputHashes inputs;
  std::vector<std::string> warnings;   // "<what>; <cure>"
  std::vector<run::Verdict> verdicts;  // of the expectations of peaks on the methods that were asked for
};

// Runs the stages of a plan with [spectrum], measures by each method and writes the directory: sweep.csv
// while a sweep runs; spectrum.csv, peaks.csv, methods.csv, charts/, spectrum.json. Throws Error (bad_input)
// before anything is written, or as a run does.
Measurement measure(const scenario::Plan& plan, const MeasurementOptions& options);

// Continues the measurement in the directory options.out after its last complete frequency, to the same bits
// and by the methods it began with. Throws Error as measure() does; nothing is changed if the status is
// bad_input.
Measurement resume_measurement(const MeasurementOptions& options, PluginHost& host);

// At most 25 lines for people: methods with their steps and times, peaks with errors, differences of methods.
std::string text_report(const Measurement& measurement);

}  // namespace scree::spectrum
