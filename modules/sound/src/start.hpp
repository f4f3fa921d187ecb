#pragma once

#include <atomic>
#include <functional>
#include <string>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::sound {

// What all roads begin from, with the callbacks for progress and stop.
struct Start {
  const scenario::Plan& plan;
  Scene scene;  // with the parameters of the last stage
  State state;  // at its end
  const std::atomic<bool>* stop = nullptr;
  std::function<void(double share, const std::string& what)> on_progress = [](double, const std::string&) {};

  const scenario::SpectrumPlan& spectrum() const { return *plan.spectrum; }
  bool proceeds() const { return !stop || !*stop; }
};

}  // namespace scree::sound
