#include <cmath>
#include <limits>

#include <scree/sound/resonance.hpp>

namespace scree::sound {

namespace {

constexpr std::size_t fewest_frequencies = 16;

double nearest_difference(double frequency, const std::vector<spectrum::Mode>& modes) {
  double nearest = std::numeric_limits<double>::quiet_NaN();
  for (const spectrum::Mode& mode : modes)
    if (const double d = frequency - mode.frequency; !(std::abs(d) >= std::abs(nearest))) nearest = d;
  return nearest;
}

}  // namespace

std::vector<Resonance> resonances_of(const std::vector<RoadSpectrum>& roads) {
  std::vector<Resonance> all;
  for (std::size_t c = 0; !roads.empty() && c < roads[0].columns.size(); ++c) {
    std::vector<spectrum::Mode> of_first;
    for (std::size_t r = 0; r < roads.size(); ++r) {
      if (roads[r].frequencies.size() < fewest_frequencies) continue;
      const auto modes = spectrum::find_modes(roads[r].frequencies, roads[r].columns[c].response);
      if (r == 0) of_first = modes;
      for (const spectrum::Mode& mode : modes)
        all.push_back({r, c, mode, r == 0 ? 0 : nearest_difference(mode.frequency, of_first)});
    }
  }
  return all;
}

}  // namespace scree::sound
