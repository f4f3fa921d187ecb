#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/spectrum/method_spectrum.hpp>
#include <scree/spectrum/peak.hpp>

namespace scree::spectrum {

// The spectrum of a plan by some methods, without a directory, for studies of many.
struct InMemorySpectrum {
  std::vector<MethodSpectrum> spectra;
  std::vector<Peak> peaks;
  std::uint64_t steps = 0;  // of the stages and the methods
  double wall_time = 0;     // (s) of both, without the set-up
  bool stopped = false;     // before its end
};

// spectrum_plan: from read_spectrum(). Runs the stages and measures by the methods on one thread until
// `*stop` is true; `stop` may be null. Throws Error as measure() does.
InMemorySpectrum spectrum_in_memory(const scenario::Plan& plan, const SpectrumPlan& spectrum_plan,
                                    const std::vector<Method>& methods, const std::atomic<bool>* stop);

}  // namespace scree::spectrum
