#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/spectrum/resonance.hpp>
#include <scree/spectrum/road_spectrum.hpp>

namespace scree::spectrum {

// The spectrum of a plan by some roads, without a directory, for studies of many.
struct SpectrumTrial {
  std::vector<RoadSpectrum> roads;
  std::vector<Resonance> resonances;
  std::uint64_t steps = 0;  // of the stages and the roads
  double wall = 0;          // (s) of both, without the set-up
  bool stopped = false;     // before its end
};

// Runs the stages and takes the roads on one thread until `*stop` is true; `stop` may be null. Throws Error as measure()
// does.
SpectrumTrial try_roads(const scenario::Plan& plan, const std::vector<Road>& roads,
                        const std::atomic<bool>* stop);

}  // namespace scree::spectrum
