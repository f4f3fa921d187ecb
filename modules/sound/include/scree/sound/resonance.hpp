#pragma once

#include <vector>

#include <scree/sound/road_spectrum.hpp>
#include <scree/spectrum/peaks.hpp>

namespace scree::sound {

// A peak in the response of a column, as one road found it.
struct Resonance {
  std::size_t road = 0, column = 0;  // of the measurement
  spectrum::Mode mode;
  // f0 − that of the nearest peak of the first road (Hz); 0 for the first road, NaN if it has none.
  double difference = 0;
};

// The peaks of all roads, by column, road and frequency. Roads of fewer than 16 frequencies have none.
std::vector<Resonance> resonances_of(const std::vector<RoadSpectrum>& roads);

}  // namespace scree::sound
