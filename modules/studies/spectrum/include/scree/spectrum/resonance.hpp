#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include <scree/scenario/peak_quantity.hpp>
#include <scree/signals/peaks.hpp>
#include <scree/spectrum/road_spectrum.hpp>

namespace scree::spectrum {

// A peak in the response of a column, as one road found it.
struct Resonance {
  std::size_t road = 0, column = 0;  // of the measurement
  signals::FittedMode mode;
  // f0 − that of the nearest peak of the first road (Hz); 0 for the first road, NaN if it has none.
  double difference = 0;
  // Wavelengths between the ends of the packing, 0.25 of λ/4: from the shape, not the order (mode_shape.hpp); NaN without a standing wave.
  double wavelengths = 0;
  // Displacements of layers at the nearest frequency, over that of the drive; or empty.
  std::vector<std::complex<double>> layers;
  std::vector<double> shape;  // their parts in phase with each other, the largest 1
  // Place of the frequency at which the response is largest within half a width of the peak; none if it has no maximum
  // there, but a shoulder.
  std::optional<std::size_t> maximum = {};
};

constexpr std::size_t fewest_frequencies_of_peaks = 16;

// The peaks of all roads, by column, road and frequency. Roads of fewer frequencies than that, and columns with numbers that are not
// finite, have none. `observed`: of the columns of the roads.
std::vector<Resonance> resonances_of(const std::vector<RoadSpectrum>& roads,
                                     const std::vector<scenario::ObservedColumn>& observed);
// "λ/4", "3λ/4", "λ", ...; "" without a standing wave or a maximum, and for an amplitude below twice its error.
std::string name_of(const Resonance& resonance);
// A number of a peak, by its place in scenario::peak_numbers; wavelengths are NaN without a standing wave.
double number_of(const Resonance& resonance, std::size_t number);
// The same of the peak that a quantity names: of several with the same name, the highest. NaN if there is none.
double value_of(const scenario::PeakQuantity& quantity, const std::vector<RoadSpectrum>& roads,
                const std::vector<Resonance>& resonances);

}  // namespace scree::spectrum
