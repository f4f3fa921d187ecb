#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::run {

// One run of a plan without a directory, for studies that make many.
struct Trial {
  double wall = 0;  // (s) of the time loop
  std::uint64_t steps = 0;
  double time = 0;                 // (s) at the end
  bool stopped = false;            // before its end, by the flag
  std::vector<double> quantities;  // of each expectation of the plan; not a number where it took no sample
  std::vector<Vec3> positions;     // (m) of the bodies at the end, unfolded from periodic images
};

struct TrialOptions {
  unsigned threads = 1;
  double until = std::numeric_limits<double>::infinity();  // (s) at which it is cut short
  const std::atomic<bool>* stop = nullptr;
};

// Throws Error as run() does.
Trial try_plan(const scenario::Plan& plan, const TrialOptions& options);

// Positions of all bodies, unfolded from periodic images (m).
std::vector<Vec3> unfolded_positions(const Simulation& simulation);

}  // namespace scree::run
