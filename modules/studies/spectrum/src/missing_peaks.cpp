#include "missing_peaks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace scree::spectrum {

namespace {

// Steps between frequencies within which a peak is that of a maximum.
constexpr double steps_beside = 2;

// Maxima of at least this share of the highest response, which falls to as little of them on both sides before it is higher.
constexpr double share = 0.5;

// Whether the response falls to `low` on one side, step by step to the end, before it rises above what it is at `from`.
bool falls(const std::vector<double>& heights, std::size_t from, int step, double low) {
  for (std::size_t k = from + step; k < heights.size(); k += std::size_t(step)) {  // wraps around below 0
    if (heights[k] <= low) return true;
    if (heights[k] > heights[from]) return false;
  }
  return false;
}

// Places of outstanding maxima, and of the highest response unless it is at an end of the band; none if one is not a number.
std::vector<std::size_t> outstanding(const RoadSpectrum::Column& column) {
  std::vector<double> heights;
  for (const auto& response : column.response) heights.push_back(std::abs(response));
  const double highest = *std::max_element(heights.begin(), heights.end());
  std::vector<std::size_t> places;
  if (!std::all_of(heights.begin(), heights.end(), [](double h) { return std::isfinite(h); })) return places;
  for (std::size_t k = 1; k + 1 < heights.size(); ++k) {
    const double low = share * heights[k];
    const bool stands_out =
        heights[k] >= share * highest && falls(heights, k, -1, low) && falls(heights, k, 1, low);
    if (stands_out || heights[k] == highest) places.push_back(k);
  }
  return places;
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
      for (const std::size_t k : outstanding(roads[r].columns[c])) {
        const double step = 0.5 * (frequencies[k + 1] - frequencies[k - 1]);
        if (has_peak(resonances, r, c, frequencies[k], step)) continue;
        notes.push_back(fmt::format(
            "{}: the maximum of {} at {:g} Hz is no peak that could be fitted, for which a mode has at least 4 frequencies in its width; "
            "give a smaller step_hz, or adaptive = true",
            roads[r].road, observed[c].name, frequencies[k]));
      }
    }
  }
  return notes;
}

}  // namespace scree::spectrum
