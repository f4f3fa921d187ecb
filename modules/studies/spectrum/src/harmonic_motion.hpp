#pragma once

#include <vector>

#include <scree/response/band_response.hpp>
#include <scree/response/degrees_of_freedom.hpp>
#include <scree/response/frequency_response.hpp>
#include <scree/simulation.hpp>

namespace scree::spectrum {

// The steady motion of a packing about its present state while its walls move.
struct HarmonicMotion {
  response::DegreesOfFreedom freedom;
  std::size_t sliding_contacts, one_way_contacts;     // as in response::LinearSystem
  double time_step;                                   // likewise
  std::vector<response::HarmonicResponse> responses;  // for each frequency, until band.stop said stop
};

// walls: displacement of each wall (m). The one place where the linear system is set up and solved; a small
// one to round-off. Throws Error if a law
// cannot be linearised.
HarmonicMotion harmonic_motion(const Simulation& simulation, const std::vector<Vec3>& walls,
                               const std::vector<double>& frequencies_hz,
                               const response::AssemblyOptions& options, const response::BandOptions& band);

}  // namespace scree::spectrum
