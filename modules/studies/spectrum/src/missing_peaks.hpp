#pragma once

#include <string>
#include <vector>

#include <scree/spectrum/resonance.hpp>

namespace scree::spectrum {

// "<what>; <cure>" for each outstanding maximum of the response of a road and column that has no peak: most often there are too few
// frequencies in its width for a fit.
std::vector<std::string> missing_peaks(const std::vector<RoadSpectrum>& roads,
                                       const std::vector<Resonance>& resonances,
                                       const std::vector<scenario::ObservedColumn>& observed);

}  // namespace scree::spectrum
