#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::run {

// Result of one run of a plan without a directory, for studies of many runs.
struct InMemoryRun {
  double wall_time = 0;  // (s) of the time loop
  std::uint64_t steps = 0;
  double time = 0;                 // (s) at the end
  bool stopped = false;            // before its end, by InMemoryOptions::stop
  std::vector<double> quantities;  // of each expectation of the plan; NaN if there are no samples
  std::vector<Vec3> positions;     // (m) of the bodies at the end, unwrapped across periodic faces
};

struct InMemoryOptions {
  unsigned threads = 1;
  double until = std::numeric_limits<double>::infinity();  // (s) end of the run
  const std::atomic<bool>* stop = nullptr;
};

// Runs a plan. Throws Error as run_plan() does.
InMemoryRun run_in_memory(const scenario::Plan& plan, const InMemoryOptions& options);

// Positions of all bodies (m), unwrapped across periodic faces.
std::vector<Vec3> unwrapped_positions(const Simulation& simulation);

}  // namespace scree::run
