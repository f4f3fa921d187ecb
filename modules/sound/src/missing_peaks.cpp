#include "missing_peaks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace scree::sound {

namespace {

// Steps between frequencies within which a peak is that of a maximum.
constexpr double steps_beside = 2;

// Place of the highest response; 0 if it is at an end of the band, or not a number.
std::size_t highest(const RoadSpectrum::Column& column) {
  const auto at = std::max_element(column.response.begin(), column.response.end(),
                                   [](const auto& a, const auto& b) { return std::abs(a) < std::abs(b); });
  const auto place = std::size_t(at - column.response.begin());
  return std::isfinite(std::abs(*at)) && place + 1 < column.response.size() ? place : 0;
}

bool has_peak(const std::vector<Resonance>& resonances, std::size_t road, std::size_t column,
              double frequency, double step) {
  return std::any_of(resonances.begin(), resonances.end(), [&](const Resonance& r) {
    return r.road == road && r.column == column &&
           std::abs(r.mode.frequency - frequency) <= std::max(steps_beside * step, r.mode.width);
  });
}

}  // namespace

std::vector<std::string> missing_peaks(const std::vector<RoadSpectrum>& roads,
                                       const std::vector<Resonance>& resonances,
                                       const std::vector<scenario::ObservedColumn>& observed) {
  std::vector<std::string> notes;
  for (std::size_t r = 0; r < roads.size(); ++r) {
    const std::vector<double>& frequencies = roads[r].frequencies;
    if (frequencies.size() < fewest_frequencies_of_peaks) continue;
    for (std::size_t c = 0; c < responding(observed); ++c) {
      const std::size_t k = highest(roads[r].columns[c]);
      if (k == 0) continue;
      const double step = 0.5 * (frequencies[k + 1] - frequencies[k - 1]);
      if (has_peak(resonances, r, c, frequencies[k], step)) continue;
      notes.push_back(fmt::format(
          "{}: the highest response of {}, at {:g} Hz, is no peak that could be fitted, for which a mode has at least 4 frequencies in its "
          "width; give a smaller step_hz, or adaptive = true",
          roads[r].road, observed[c].name, frequencies[k]));
    }
  }
  return notes;
}

}  // namespace scree::sound
