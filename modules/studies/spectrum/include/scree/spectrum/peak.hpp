#pragma once

#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <scree/signals/peaks.hpp>
#include <scree/spectrum/method_spectrum.hpp>
#include <scree/spectrum/peak_quantity.hpp>

namespace scree::spectrum {

// The displacement of layers from one end of a packing to the other in a steady motion.
struct ModeShape {
  // In the phase in which the layers move most, divided by the largest displacement, which is positive.
  std::vector<double> displacement;
  // Wavelengths between the ends, the nearest of 0.25, 0.5, 0.75, ...: of the sine of any phase that fits the
  // displacements best, with as many nodes, or one more beyond an end. So a wall that moves by itself makes
  // no antinode. NaN without a standing wave: the returning wave has less than a quarter of the amplitude of
  // the outgoing wave.
  double wavelengths = std::numeric_limits<double>::quiet_NaN();
};

// Of three layers or more. Layers that move less than a tenth of the largest displacement are in no phase.
ModeShape mode_shape(const std::vector<std::complex<double>>& layers);

// A peak in the response of a column, as one method found it.
struct Peak {
  std::size_t spectrum = 0, column = 0;  // of the measurement
  signals::FittedMode mode;
  // f0 − that of the nearest peak of the first method (Hz); 0 for the first method, NaN if it has none.
  double difference = 0;
  // Wavelengths between the ends of the packing, 0.25 of λ/4, from the shape (mode_shape()); NaN without a
  // standing wave.
  double wavelengths = 0;
  // Displacements of layers at the nearest frequency, over that of the drive; or empty.
  std::vector<std::complex<double>> layers;
  std::vector<double> shape;  // their parts in phase with each other, the largest 1
  // Place of the frequency at which the response is largest within half a width of the peak; none if the
  // response has no maximum there, but a shoulder.
  std::optional<std::size_t> maximum = {};
};

constexpr std::size_t fewest_frequencies_of_peaks = 16;

// The peaks of all spectra, by column, method and frequency. Spectra with fewer frequencies, and columns with
// numbers that are not finite, have none. `observed`: the columns of the spectra.
std::vector<Peak> peaks_in(const std::vector<MethodSpectrum>& spectra,
                           const std::vector<ObservedColumn>& observed);
// "λ/4", "3λ/4", "λ", ...; "" without a standing wave or a maximum, and for an amplitude below two errors.
std::string name_of(const Peak& peak);
// A number of a peak, by its place in peak_numbers; wavelengths are NaN without a standing wave.
double number_of(const Peak& peak, std::size_t number);
// The number of the peak that a quantity names; of several peaks with that name, of the highest. NaN if there
// is none.
double value_of(const PeakQuantity& quantity, const std::vector<MethodSpectrum>& spectra,
                const std::vector<Peak>& peaks);

// "<what>; <cure>" for each outstanding maximum of a column that has no peak. Most often too few frequencies
// lie in its width for a fit.
std::vector<std::string> missing_peaks(const std::vector<MethodSpectrum>& spectra,
                                       const std::vector<Peak>& peaks,
                                       const std::vector<ObservedColumn>& observed);

}  // namespace scree::spectrum
