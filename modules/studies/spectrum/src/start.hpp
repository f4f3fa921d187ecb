#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>
#include <scree/spectrum/road_spectrum.hpp>

namespace scree::spectrum {

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

// What can be told of a plan before its stages have run: that its drive moves walls and, if it is the only one, that a road can be taken. Throws
// Error.
void check_before_stages(const scenario::Plan& plan, const std::vector<Road>& roads);

}  // namespace scree::spectrum
