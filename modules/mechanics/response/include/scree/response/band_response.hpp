#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include <scree/response/frequency_response.hpp>

namespace scree::response {

struct BandOptions {
  double tolerance = 1e-2;  // largest estimated relative error of an amplitude, above 0
  unsigned threads = 0;     // 0: as many as the machine has; results do not depend on it
  // Called by any thread, one at a time, with the share of the frequencies that are found.
  std::function<void(double share)> on_progress = {};
  // Set by another thread: frequencies not found by then are left out. Asked for later, they get the same
  // bits.
  const std::atomic<bool>* stop = nullptr;
};

struct BandStatistics {
  int factorisations = 0;
  int largest_basis = 0;  // vectors from which the solutions at neighbouring frequencies are combined
  double seconds = 0;     // wall time
};

struct BandResponse {
  std::vector<HarmonicResponse> responses;  // of the frequencies that were found, in their order
  BandStatistics statistics;
};

// Does the same as `solve` at many frequencies with few factorisations: frequencies near a factorised one are
// found by iteration. HarmonicResponse::error, an estimate, is below the tolerance, or, if iteration at a
// factorised frequency does not reach it, the error that remains. Throws Error as `solve` does, and if the
// tolerance is not above 0.
BandResponse solve_band(const LinearSystem& system, const Drive& drive,
                        const std::vector<double>& frequencies_hz, const BandOptions& options = {});

}  // namespace scree::response
