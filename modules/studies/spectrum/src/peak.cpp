#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include <scree/spectrum/peak.hpp>

namespace scree::spectrum {

namespace {

// Share of the largest displacement below which the phase of a layer is noise.
constexpr double least_moving_share = 0.1;
// Amplitude of the returning wave over the outgoing wave, in a standing wave.
constexpr double least_return = 0.25;

int nodes_of(const std::vector<double>& displacement) {
  int nodes = 0;
  double before = 0;
  for (const double u : displacement) {
    if (std::abs(u) < least_moving_share) continue;
    nodes += u * before < 0;
    before = u;
  }
  return nodes;
}

// Residual sum of squares of the sine with so many wavelengths between the ends, with the best phase and
// amplitude.
double rest_of_sine(const std::vector<double>& displacement, double wavelengths) {
  double ss = 0, sc = 0, cc = 0, us = 0, uc = 0, uu = 0;
  for (std::size_t k = 0; k < displacement.size(); ++k) {
    const double turn =
        2 * std::numbers::pi * wavelengths * ((double(k) + 0.5) / double(displacement.size()) - 0.5);
    const double s = std::sin(turn), c = std::cos(turn), u = displacement[k];
    ss += s * s, sc += s * c, cc += c * c, us += u * s, uc += u * c, uu += u * u;
  }
  const double determinant = ss * cc - sc * sc;
  return uu - (us * us * cc - 2 * us * uc * sc + uc * uc * ss) / determinant;
}

// Wavelengths of the sine that fits best, between an eighth below half a wavelength for each node and an
// eighth above one half more.
double wavelengths_of(const std::vector<double>& displacement) {
  constexpr double least = 0.05, beyond = 0.125, step = 1.0 / 256;
  const double nodes = nodes_of(displacement);
  // Beyond half a wavelength in a layer, sines are those of longer waves.
  const double most = std::min(0.5 * (nodes + 1) + beyond, 0.49 * double(displacement.size()));
  double best = least, lowest = std::numeric_limits<double>::infinity();
  for (double at = std::max(least, 0.5 * nodes - beyond); at <= most; at += step)
    if (const double rest = rest_of_sine(displacement, at); rest < lowest) lowest = rest, best = at;
  return best;
}

// Share of the motion that is in one phase: (1 + r)²/(2 (1 + r²)) for opposite waves with amplitudes 1 and r.
constexpr double least_in_phase =
    (1 + least_return) * (1 + least_return) / (2 * (1 + least_return * least_return));

bool is_finite(const MethodSpectrum::Column& column) {
  return std::all_of(column.response.begin(), column.response.end(), [](const std::complex<double>& h) {
    return std::isfinite(h.real()) && std::isfinite(h.imag());
  });
}

// Of the displacements that a column follows: 1 of velocities, 2 of accelerations.
int time_derivative(const std::string& unit) {
  return unit.ends_with("/s") ? 1 : unit.ends_with("/s^2") ? 2 : 0;
}

double nearest_difference(double frequency, const std::vector<signals::FittedMode>& modes) {
  double nearest = std::numeric_limits<double>::quiet_NaN();
  for (const signals::FittedMode& mode : modes)
    if (const double d = frequency - mode.frequency; !(std::abs(d) >= std::abs(nearest))) nearest = d;
  return nearest;
}

void set_shape(const MethodSpectrum& spectrum, const std::vector<ObservedColumn>& observed, Peak& peak) {
  const std::size_t nearest = spectrum.nearest(peak.mode.frequency);
  for (std::size_t c = responding(observed); c < observed.size(); ++c)
    peak.layers.push_back(spectrum.columns[c].response[nearest]);
  if (peak.layers.empty()) return;
  const ModeShape shape = mode_shape(peak.layers);
  peak.wavelengths = shape.wavelengths;
  peak.shape = shape.displacement;
}

std::optional<std::size_t> maximum_of(const MethodSpectrum& spectrum, std::size_t c,
                                      const signals::FittedMode& mode) {
  const auto& f = spectrum.frequencies;
  const auto height = [&](std::size_t k) { return std::abs(spectrum.columns[c].response[k]); };
  const std::size_t nearest = spectrum.nearest(mode.frequency);
  std::size_t top = nearest;
  for (std::size_t k = 0; k < f.size(); ++k) {
    // The frequency beside the nearest one may have the maximum even of a peak narrower than their distance.
    const bool is_near =
        std::abs(f[k] - mode.frequency) <= 0.5 * mode.width || (k + 1 >= nearest && k <= nearest + 1);
    if (is_near && height(k) > height(top)) top = k;
  }
  const bool is_maximum =
      top > 0 && top + 1 < f.size() && height(top) > height(top - 1) && height(top) > height(top + 1);
  return is_maximum ? std::optional(top) : std::nullopt;
}

// Of the last one. Of two peaks with the same maximum, the lower one is a shoulder.
void set_maximum(const MethodSpectrum& spectrum, std::vector<Peak>& all) {
  Peak& last = all.back();
  last.maximum = maximum_of(spectrum, last.column, last.mode);
  for (Peak& other : all) {
    if (&other == &last || !last.maximum || other.maximum != last.maximum ||
        other.spectrum != last.spectrum || other.column != last.column)
      continue;
    (other.mode.amplitude < last.mode.amplitude ? other : last).maximum.reset();
  }
}

// Steps between frequencies within which a peak belongs to a maximum.
constexpr double steps_beside = 2;

// Height of an outstanding maximum over the highest response; on both sides the response falls to this share
// of the maximum before it exceeds it.
constexpr double least_height = 0.5;

// Whether the response falls to `low` on one side before it rises above its value at `from`.
bool falls(const std::vector<double>& heights, std::size_t from, int step, double low) {
  for (std::size_t k = from + step; k < heights.size(); k += std::size_t(step)) {  // wraps around below 0
    if (heights[k] <= low) return true;
    if (heights[k] > heights[from]) return false;
  }
  return false;
}

// Places of outstanding maxima, and of the highest response unless it is at an end of the band; none if a
// response is not a number.
std::vector<std::size_t> outstanding(const MethodSpectrum::Column& column) {
  std::vector<double> heights;
  for (const auto& response : column.response) heights.push_back(std::abs(response));
  const double highest = *std::max_element(heights.begin(), heights.end());
  std::vector<std::size_t> places;
  if (!std::all_of(heights.begin(), heights.end(), [](double h) { return std::isfinite(h); })) return places;
  for (std::size_t k = 1; k + 1 < heights.size(); ++k) {
    const double low = least_height * heights[k];
    const bool stands_out =
        heights[k] >= least_height * highest && falls(heights, k, -1, low) && falls(heights, k, 1, low);
    if (stands_out || heights[k] == highest) places.push_back(k);
  }
  return places;
}

// Methods that add frequencies by themselves.
const char* adaptive_cure(const std::string& method) {
  if (method == "linear") return ", or spectrum.linear.adaptive = true";
  return method.starts_with("sweep") ? ", or spectrum.sweep.adaptive = true" : "";
}

bool has_peak(const std::vector<Peak>& peaks, std::size_t spectrum, std::size_t column, double frequency,
              double step) {
  return std::any_of(peaks.begin(), peaks.end(), [&](const Peak& r) {
    return r.spectrum == spectrum && r.column == column &&
           std::abs(r.mode.frequency - frequency) <= std::max(steps_beside * step, r.mode.width);
  });
}

}  // namespace

ModeShape mode_shape(const std::vector<std::complex<double>>& layers) {
  // sum Re(u e^(iθ))² is largest where the sum of (u e^(iθ))² is real.
  std::complex<double> squares = 0;
  double whole = 0, in_phase = 0;
  for (const std::complex<double>& u : layers) squares += u * u, whole += std::norm(u);
  const std::complex<double> turn = std::polar(1.0, -0.5 * std::arg(squares));
  ModeShape shape;
  for (const std::complex<double>& u : layers) shape.displacement.push_back((u * turn).real());
  for (const double u : shape.displacement) in_phase += u * u;
  const auto largest = std::max_element(shape.displacement.begin(), shape.displacement.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  if (const double scale = *largest; scale != 0)
    for (double& u : shape.displacement) u /= scale;
  if (!(in_phase >= least_in_phase * whole) || whole == 0) return shape;
  constexpr double quarter = 0.25;
  shape.wavelengths = quarter * std::max(1.0, std::round(wavelengths_of(shape.displacement) / quarter));
  return shape;
}

std::vector<Peak> peaks_in(const std::vector<MethodSpectrum>& spectra,
                           const std::vector<ObservedColumn>& observed) {
  std::vector<Peak> all;
  for (std::size_t c = 0; !spectra.empty() && c < responding(observed); ++c) {
    std::vector<signals::FittedMode> of_first;
    for (std::size_t r = 0; r < spectra.size(); ++r) {
      if (spectra[r].frequencies.size() < fewest_frequencies_of_peaks || !is_finite(spectra[r].columns[c]))
        continue;
      const auto modes = signals::fit_peaks(spectra[r].frequencies, spectra[r].columns[c].response,
                                            time_derivative(observed[c].unit));
      if (r == 0) of_first = modes;
      for (const signals::FittedMode& mode : modes) {
        const double difference = r == 0 ? 0 : nearest_difference(mode.frequency, of_first);
        all.push_back({r, c, mode, difference, std::numeric_limits<double>::quiet_NaN(), {}, {}});
        set_shape(spectra[r], observed, all.back());
        set_maximum(spectra[r], all);
      }
    }
  }
  return all;
}

double number_of(const Peak& peak, std::size_t number) {
  const signals::FittedMode& mode = peak.mode;
  const double numbers[] = {mode.frequency, mode.frequency_error, mode.quality,    mode.quality_error,
                            mode.amplitude, mode.amplitude_error, peak.wavelengths};
  static_assert(std::size(numbers) == peak_numbers.size());
  return numbers[number];
}

double value_of(const PeakQuantity& quantity, const std::vector<MethodSpectrum>& spectra,
                const std::vector<Peak>& peaks) {
  const Peak* found = nullptr;
  int rank = 0;  // by frequency, in which they are sorted
  for (const Peak& r : peaks) {
    if (spectra[r.spectrum].method != method_names[quantity.method] || r.column != quantity.column) continue;
    ++rank;
    const bool named = quantity.peak == "peak_" + std::to_string(rank) || quantity.peak == name_of(r);
    if (named && (!found || r.mode.amplitude > found->mode.amplitude)) found = &r;
  }
  return found ? number_of(*found, quantity.number) : std::numeric_limits<double>::quiet_NaN();
}

std::string name_of(const Peak& peak) {
  const bool stands_out = peak.mode.amplitude > 2 * peak.mode.amplitude_error;
  if (std::isnan(peak.wavelengths) || !peak.maximum || !stands_out) return "";
  int count = int(std::lround(4 * peak.wavelengths)), of = 4;
  for (; of > 1 && count % 2 == 0; of /= 2) count /= 2;
  return (count == 1 ? "" : std::to_string(count)) + "λ" + (of == 1 ? "" : "/" + std::to_string(of));
}

std::vector<std::string> missing_peaks(const std::vector<MethodSpectrum>& spectra,
                                       const std::vector<Peak>& peaks,
                                       const std::vector<ObservedColumn>& observed) {
  std::vector<std::string> notes;
  for (std::size_t r = 0; r < spectra.size(); ++r) {
    const std::vector<double>& frequencies = spectra[r].frequencies;
    if (frequencies.size() < fewest_frequencies_of_peaks) continue;
    for (std::size_t c = 0; c < responding(observed); ++c) {
      for (const std::size_t k : outstanding(spectra[r].columns[c])) {
        const double step = 0.5 * (frequencies[k + 1] - frequencies[k - 1]);
        if (has_peak(peaks, r, c, frequencies[k], step)) continue;
        notes.push_back(fmt::format(
            "{}: the maximum of {} at {:g} Hz is no peak that could be fitted, for which a mode has at least 4 frequencies in its width; "
            "give a smaller step_hz{}",
            spectra[r].method, observed[c].name, frequencies[k], adaptive_cure(spectra[r].method)));
      }
    }
  }
  return notes;
}

}  // namespace scree::spectrum
