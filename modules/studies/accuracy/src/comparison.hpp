#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include <scree/run/run_in_memory.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/spectrum/method_spectrum.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::accuracy {

// What a study compares, and how it runs a setting.
class Comparison {
 public:
  // quantities: those to compare; those of the [[expect]] tables if there are none. Throws Error if one is
  // unknown, or if some are of a run and some of peaks.
  Comparison(const scenario::Plan& plan, const std::vector<std::string>& quantities);

  // With the compared quantities as its expectations.
  const scenario::Plan& plan() const { return plan_; }
  // Of the peaks of a spectrum; else of a run, and of its positions.
  bool of_peaks() const { return !methods_.empty(); }
  // Runs plan() with other settings; without positions if it is of peaks.
  run::InMemoryRun run(const scenario::Plan& changed, double until, const std::atomic<bool>* stop) const;

 private:
  void choose(const std::vector<std::string>& quantities);
  void note_methods();

  scenario::Plan plan_;
  std::optional<spectrum::SpectrumPlan> spectrum_;
  std::vector<spectrum::Method> methods_;  // that the peaks need
};

}  // namespace scree::accuracy
