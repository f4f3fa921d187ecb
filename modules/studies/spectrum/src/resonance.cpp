#include "mode_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/spectrum/resonance.hpp>

namespace scree::spectrum {

namespace {

bool is_finite(const RoadSpectrum::Column& column) {
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

void set_shape(const RoadSpectrum& road, const std::vector<scenario::ObservedColumn>& observed,
               Resonance& resonance) {
  const std::size_t nearest = road.nearest(resonance.mode.frequency);
  for (std::size_t c = responding(observed); c < observed.size(); ++c)
    resonance.layers.push_back(road.columns[c].response[nearest]);
  if (resonance.layers.empty()) return;
  const ModeShape shape = mode_shape(resonance.layers);
  resonance.wavelengths = shape.wavelengths;
  resonance.shape = shape.displacement;
}

std::optional<std::size_t> maximum_of(const RoadSpectrum& road, std::size_t c, const signals::FittedMode& mode) {
  const auto& f = road.frequencies;
  const auto height = [&](std::size_t k) { return std::abs(road.columns[c].response[k]); };
  const std::size_t nearest = road.nearest(mode.frequency);
  std::size_t top = nearest;
  for (std::size_t k = 0; k < f.size(); ++k) {
    // The frequency beside the nearest one is a place of the maximum even of a peak narrower than their distance.
    const bool is_near =
        std::abs(f[k] - mode.frequency) <= 0.5 * mode.width || (k + 1 >= nearest && k <= nearest + 1);
    if (is_near && height(k) > height(top)) top = k;
  }
  const bool is_maximum =
      top > 0 && top + 1 < f.size() && height(top) > height(top - 1) && height(top) > height(top + 1);
  return is_maximum ? std::optional(top) : std::nullopt;
}

// Of the last one. Of two peaks with the same maximum, the lower one is a shoulder.
void set_maximum(const RoadSpectrum& road, std::vector<Resonance>& all) {
  Resonance& last = all.back();
  last.maximum = maximum_of(road, last.column, last.mode);
  for (Resonance& other : all) {
    if (&other == &last || !last.maximum || other.maximum != last.maximum || other.road != last.road ||
        other.column != last.column)
      continue;
    (other.mode.amplitude < last.mode.amplitude ? other : last).maximum.reset();
  }
}

}  // namespace

std::vector<Resonance> resonances_of(const std::vector<RoadSpectrum>& roads,
                                     const std::vector<scenario::ObservedColumn>& observed) {
  std::vector<Resonance> all;
  for (std::size_t c = 0; !roads.empty() && c < responding(observed); ++c) {
    std::vector<signals::FittedMode> of_first;
    for (std::size_t r = 0; r < roads.size(); ++r) {
      if (roads[r].frequencies.size() < fewest_frequencies_of_peaks || !is_finite(roads[r].columns[c]))
        continue;
      const auto modes = signals::fit_peaks(roads[r].frequencies, roads[r].columns[c].response,
                                             time_derivative(observed[c].unit));
      if (r == 0) of_first = modes;
      for (const signals::FittedMode& mode : modes) {
        const double difference = r == 0 ? 0 : nearest_difference(mode.frequency, of_first);
        all.push_back({r, c, mode, difference, std::numeric_limits<double>::quiet_NaN(), {}, {}});
        set_shape(roads[r], observed, all.back());
        set_maximum(roads[r], all);
      }
    }
  }
  return all;
}

double number_of(const Resonance& resonance, std::size_t number) {
  const signals::FittedMode& mode = resonance.mode;
  const double numbers[] = {mode.frequency, mode.frequency_error, mode.quality,         mode.quality_error,
                            mode.amplitude, mode.amplitude_error, resonance.wavelengths};
  static_assert(std::size(numbers) == scenario::peak_numbers.size());
  return numbers[number];
}

double value_of(const scenario::PeakQuantity& quantity, const std::vector<RoadSpectrum>& roads,
                const std::vector<Resonance>& resonances) {
  const Resonance* found = nullptr;
  int rank = 0;  // by frequency, in which they are sorted
  for (const Resonance& r : resonances) {
    if (roads[r.road].road != road_names[quantity.road] || r.column != quantity.column) continue;
    ++rank;
    const bool named = quantity.peak == "peak_" + std::to_string(rank) || quantity.peak == name_of(r);
    if (named && (!found || r.mode.amplitude > found->mode.amplitude)) found = &r;
  }
  return found ? number_of(*found, quantity.number) : std::numeric_limits<double>::quiet_NaN();
}

std::string name_of(const Resonance& resonance) {
  const bool stands_out = resonance.mode.amplitude > 2 * resonance.mode.amplitude_error;
  if (std::isnan(resonance.wavelengths) || !resonance.maximum || !stands_out) return "";
  int count = int(std::lround(4 * resonance.wavelengths)), of = 4;
  for (; of > 1 && count % 2 == 0; of /= 2) count /= 2;
  return (count == 1 ? "" : std::to_string(count)) + "λ" + (of == 1 ? "" : "/" + std::to_string(of));
}

}  // namespace scree::spectrum
