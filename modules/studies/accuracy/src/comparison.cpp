#include "comparison.hpp"

#include <algorithm>

#include <scree/error.hpp>
#include <scree/run/set_up.hpp>
#include <scree/spectrum/peak_quantity.hpp>
#include <scree/spectrum/spectrum_in_memory.hpp>

namespace scree::accuracy {

namespace {

using scenario::Expectation;

// The frequency and the quality of a peak that is named without a number; else the name itself.
std::vector<std::string> complete(const std::string& name,
                                  const std::optional<spectrum::SpectrumPlan>& spectrum) {
  const std::string frequency = name + ".frequency";
  if (spectrum && spectrum::peak_quantity(frequency, spectrum->observed))
    return {frequency, name + ".quality"};
  return {name};
}

// What is wrong with the name of a quantity; nothing if the scenario has it.
std::optional<std::string> problem_of(const std::string& name, const std::vector<std::string>& known,
                                      const std::optional<spectrum::SpectrumPlan>& spectrum) {
  const auto problem = scenario::quantity_problem(name, known);
  return problem && spectrum && spectrum::names_peak(name)
             ? spectrum::peak_quantity_problem(name, spectrum->observed)
             : problem;
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

Comparison::Comparison(const scenario::Plan& plan, const std::vector<std::string>& quantities)
    : plan_(plan), spectrum_(spectrum::read_spectrum(plan)) {
  if (!quantities.empty()) choose(quantities);
  // Peaks are what a scenario without a run, or without [[expect]] of one, is for.
  const bool of_peaks =
      spectrum_ && !spectrum_->expectations.empty() && (plan_.stages.empty() || plan_.expectations.empty());
  if (!of_peaks) {
    run::require_stages(plan_);
    return;
  }
  plan_.expectations = std::move(spectrum_->expectations);
  note_methods();
}

void Comparison::choose(const std::vector<std::string>& quantities) {
  const auto known = scenario::quantity_names(plan_.probes, plan_.scene.dimension);
  std::vector<Expectation> of_run, of_peaks;
  for (const std::string& given : quantities)
    for (const std::string& name : complete(given, spectrum_)) {
      if (const auto problem = problem_of(name, known, spectrum_)) throw Error(*problem);
      const bool of_peak = spectrum_ && spectrum::peak_quantity(name, spectrum_->observed);
      (of_peak ? of_peaks : of_run)
          .push_back(expectation_of(name, of_peak ? spectrum_->expectations : plan_.expectations));
    }
  if (!of_run.empty() && !of_peaks.empty())
    throw Error("'" + of_run[0].quantity + "' is of a run and '" + of_peaks[0].quantity +
                "' of a spectrum; study them one after the other");
  plan_.expectations = std::move(of_run);
  if (spectrum_) spectrum_->expectations = std::move(of_peaks);
}

void Comparison::note_methods() {
  for (const spectrum::Method method :
       {spectrum::Method::linear, spectrum::Method::pulse, spectrum::Method::sweep})
    if (std::any_of(plan_.expectations.begin(), plan_.expectations.end(), [&](const Expectation& e) {
          // A sweep has both directions.
          const std::size_t named = spectrum::peak_quantity(e.quantity, spectrum_->observed)->method;
          return std::min(named, std::size_t(spectrum::Method::sweep)) == std::size_t(method);
        }))
      methods_.push_back(method);
}

run::InMemoryRun Comparison::run(const scenario::Plan& changed, double until,
                                 const std::atomic<bool>* stop) const {
  if (!of_peaks()) return run::run_in_memory(changed, {1, until, stop});
  const spectrum::InMemorySpectrum spectrum =
      spectrum::spectrum_in_memory(changed, *spectrum_, methods_, stop);
  run::InMemoryRun result;
  result.wall_time = spectrum.wall_time;
  result.steps = spectrum.steps;
  result.stopped = spectrum.stopped;
  for (const Expectation& e : changed.expectations)
    result.quantities.push_back(spectrum::value_of(*spectrum::peak_quantity(e.quantity, spectrum_->observed),
                                                   spectrum.spectra, spectrum.peaks));
  return result;
}

}  // namespace scree::accuracy
