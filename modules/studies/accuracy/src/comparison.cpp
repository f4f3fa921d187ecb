#include "comparison.hpp"

#include <algorithm>

#include <scree/error.hpp>
#include <scree/run/set_up.hpp>
#include <scree/scenario/peak_quantity.hpp>
#include <scree/spectrum/trial.hpp>

namespace scree::accuracy {

namespace {

using scenario::Expectation;

// The frequency and the quality of a peak that is named without a number; else the name itself.
std::vector<std::string> complete(const std::string& name, const scenario::Plan& plan) {
  const std::string frequency = name + ".frequency";
  if (plan.spectrum && scenario::peak_quantity(frequency, plan.spectrum->observed))
    return {frequency, name + ".quality"};
  return {name};
}

// The expectation of a quantity, which may give a closed form; without one, that of nothing but the name.
Expectation expectation_of(const std::string& quantity, const std::vector<Expectation>& all) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Expectation& e) { return e.quantity == quantity; });
  if (found != all.end()) return *found;
  Expectation named;
  named.quantity = quantity;
  return named;
}

}  // namespace

Comparison::Comparison(const scenario::Plan& plan, const std::vector<std::string>& quantities) : plan_(plan) {
  if (!quantities.empty()) choose(quantities);
  // Peaks are what a scenario without a run, or without [[expect]] of one, is for.
  const bool of_peaks =
      !plan_.peak_expectations.empty() && (plan_.stages.empty() || plan_.expectations.empty());
  if (!of_peaks) {
    run::require_stages(plan_);
    return;
  }
  plan_.expectations = std::move(plan_.peak_expectations);
  note_roads();
}

void Comparison::choose(const std::vector<std::string>& quantities) {
  const auto known = scenario::quantity_names(plan_.probes, plan_.scene.dimension);
  std::vector<Expectation> of_run, of_peaks;
  for (const std::string& given : quantities)
    for (const std::string& name : complete(given, plan_)) {
      if (const auto problem = scenario::quantity_problem(name, known, plan_.spectrum)) throw Error(*problem);
      const bool of_peak = plan_.spectrum && scenario::peak_quantity(name, plan_.spectrum->observed);
      (of_peak ? of_peaks : of_run)
          .push_back(expectation_of(name, of_peak ? plan_.peak_expectations : plan_.expectations));
    }
  if (!of_run.empty() && !of_peaks.empty())
    throw Error("'" + of_run[0].quantity + "' is of a run and '" + of_peaks[0].quantity +
                "' of a spectrum; study them one after the other");
  plan_.expectations = std::move(of_run);
  plan_.peak_expectations = std::move(of_peaks);
}

void Comparison::note_roads() {
  for (const spectrum::Road road : {spectrum::Road::linear, spectrum::Road::pulse, spectrum::Road::sweep})
    if (std::any_of(plan_.expectations.begin(), plan_.expectations.end(), [&](const Expectation& e) {
          // A sweep has both directions.
          const std::size_t named = scenario::peak_quantity(e.quantity, plan_.spectrum->observed)->road;
          return std::min(named, std::size_t(spectrum::Road::sweep)) == std::size_t(road);
        }))
      roads_.push_back(road);
}

run::Trial Comparison::run(const scenario::Plan& changed, double until, const std::atomic<bool>* stop) const {
  if (!of_peaks()) return run::run_trial(changed, {1, until, stop});
  const spectrum::SpectrumTrial spectrum = spectrum::try_roads(changed, roads_, stop);
  run::Trial trial;
  trial.wall = spectrum.wall;
  trial.steps = spectrum.steps;
  trial.stopped = spectrum.stopped;
  for (const Expectation& e : changed.expectations)
    trial.quantities.push_back(
        spectrum::value_of(*scenario::peak_quantity(e.quantity, changed.spectrum->observed), spectrum.roads,
                           spectrum.resonances));
  return trial;
}

}  // namespace scree::accuracy
