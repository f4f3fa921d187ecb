#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>
#include <scree/spectrum/method_spectrum.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::spectrum {

// What all methods start from, with the callbacks for progress and stop.
struct Start {
  const scenario::Plan& plan;
  SpectrumPlan spectrum;
  Scene scene;  // with the parameters of the last stage
  State state;  // at its end
  const std::atomic<bool>* stop = nullptr;
  std::function<void(double share, const std::string& what)> on_progress = [](double, const std::string&) {};

  bool proceeds() const { return !stop || !*stop; }
};

// Checks a plan before its stages have run: its drive moves walls, and a method that is alone can be used.
// Throws Error.
void check_before_stages(const scenario::Plan& plan, const SpectrumPlan& spectrum,
                         const std::vector<Method>& methods);

}  // namespace scree::spectrum
