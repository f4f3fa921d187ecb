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
#include <scree/spectrum/resonance.hpp>
#include <scree/spectrum/road_spectrum.hpp>

namespace scree::spectrum {

struct MeasurementOptions {
  std::filesystem::path out;  // empty: runs/<stem of the scenario>-spectrum, numbered if it exists
  bool overwrite = false;
  unsigned threads = 1;
  std::vector<Road> roads = {Road::sweep};
  std::function<void(double share, double wall, const std::string& what)> on_progress;
  std::function<void(const std::string&)> on_warning;  // one line "<what>; <cure>"
  const std::atomic<bool>* stop = nullptr;             // set by Ctrl-C: what is complete is saved
};

// The spectrum of a packing by one or more roads.
struct Measurement {
  std::filesystem::path directory;
  std::string title;
  std::vector<scenario::ObservedColumn> observed;
  std::vector<RoadSpectrum> roads;
  std::vector<Resonance> resonances;
  bool interrupted = false;
  std::string scenario;  // as resolved
  run::InputHashes inputs;
  std::vector<std::string> warnings;   // "<what>; <cure>"
  std::string error;                   // one line, if it failed
  std::vector<run::Verdict> verdicts;  // of the expectations of peaks on the roads that were asked for
};

// Runs the stages of a plan with a [spectrum], then takes the roads, and writes their directory: sweep.csv while a sweep goes on;
// spectrum.csv, peaks.csv, roads.csv, charts/, spectrum.json. Throws Error (bad_input) before anything is written, or as a
// run does.
Measurement measure(const scenario::Plan& plan, const MeasurementOptions& options);

// Whether a directory holds a measurement.
bool is_measurement(const std::filesystem::path& directory);

// Goes on with the measurement in the directory options.out behind its last complete frequency, to the same bits; its roads are
// those it began with. Throws Error as measure() does; nothing is changed if the status is bad_input.
Measurement resume_measurement(const MeasurementOptions& options, PluginHost& host);

// At most 25 lines for people: roads with their steps and times, peaks with errors, and how far the roads disagree.
std::string text_report(const Measurement& measurement);

}  // namespace scree::spectrum
