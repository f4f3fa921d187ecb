#include "error_shares.hpp"
#include "responses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/signals/peaks.hpp>

using namespace scree::signals;
using namespace scree::test;

// How often stated errors cover the truth, for a mode among hundreds of weak ones that no fit tells apart, as
// in a disordered packing.

namespace {

// The weak modes beside a mode of height 1.
struct WeakModes {
  double height;  // largest, or mean of exponential ones
  double least_quality, most_quality;
  bool exponential = false;  // heights; uniform qualities else, and those of equal logarithm here
  double noise = 0;
};

// Modes λ/4, 3λ/4, 5λ/4 and 7λ/4 (Q 60 to 5), the second in front and of height 1, and 300 weak modes from 1
// to 200 kHz.
std::vector<Truth> packing(const WeakModes& weak, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto between = [&](double low, double high) { return low + (high - low) * uniform(random); };
  std::vector<Truth> modes;
  for (const int quarters : {3, 1, 5, 7}) {
    const double frequency = quarters * between(6.9e3, 7.2e3), quality = between(40, 60) / quarters;
    const double sign = quarters % 4 == 1 ? 0 : std::numbers::pi;
    modes.push_back({frequency, frequency / quality, 4 / (1.0 + quarters), sign + between(-0.2, 0.2)});
  }
  for (int k = 0; k < 300; ++k) {
    const double frequency = between(1e3, 200e3), share = uniform(random);
    const double quality = weak.exponential
                               ? weak.least_quality * std::pow(weak.most_quality / weak.least_quality, share)
                               : between(weak.least_quality, weak.most_quality);
    const double height = weak.height * (weak.exponential ? -std::log(1 - uniform(random)) : uniform(random));
    modes.push_back({frequency, frequency / quality, height, between(-std::numbers::pi, std::numbers::pi)});
  }
  return modes;
}

struct EnsembleCover {
  int cases = 0, found = 0,
      absurd = 0;  // absurd: modes of more than twice the largest response within their width
  ErrorShares frequency, width;
  void operator+=(const EnsembleCover& more) {
    cases += more.cases, found += more.found, absurd += more.absurd;
    frequency += more.frequency, width += more.width;
  }
  std::string text() const {
    if (found == 0) return fmt::format("none of {} found", cases);
    const auto share = [&](int covered) { return 100.0 * covered / found; };
    return fmt::format(
        "{} of {} found; within one and two errors: frequency {:.1f} and {:.1f} %, width {:.1f} and {:.1f} %",
        found, cases, share(frequency.one), share(frequency.two), share(width.one), share(width.two));
  }
};

bool is_absurd(const FittedMode& mode, const std::vector<double>& f, const std::vector<Complex>& h) {
  double largest = 0;
  for (std::size_t k = 0; k < f.size(); ++k)
    if (std::abs(f[k] - mode.frequency) <= mode.width) largest = std::max(largest, std::abs(h[k]));
  return mode.amplitude > 2 * largest;
}

void add(EnsembleCover& cover, const WeakModes& weak, unsigned first_seed, unsigned cases) {
  for (unsigned k = 0; k < cases; ++k) {
    const auto modes = packing(weak, first_seed + k);
    const FrequencyGrid& grid = grids_of_packing[k % grids_of_packing.size()];
    const auto f = band(grid.low, grid.high, grid.count);
    Noise noise(weak.noise, first_seed + k);
    const auto h = noise.added(response(f, modes));
    FittedMode best;
    for (const FittedMode& mode : fit_peaks(f, h)) {
      cover.absurd += is_absurd(mode, f, h);
      if (std::abs(mode.frequency - modes[0].frequency) < modes[0].width && mode.amplitude > best.amplitude)
        best = mode;
    }
    ++cover.cases;
    if (best.points == 0) continue;
    ++cover.found;
    cover.frequency.add(best.frequency - modes[0].frequency, best.frequency_error);
    cover.width.add(best.width - modes[0].width, best.width_error);
  }
}

// Ensembles of weak modes, with a largest height or a mean of 0.5 or 0.6 of it, and with other widths and
// noise.
constexpr std::size_t ensembles = 3;
WeakModes weak_modes(double height, std::size_t ensemble) {
  const std::array of = {WeakModes{height, 8, 60}, WeakModes{height / 2, 5, 40, true, 1e-3},
                         WeakModes{0.6 * height, 10, 80, true, 3e-3}};
  return of.at(ensemble);
}

}  // namespace

TEST_CASE("errors of a mode cover the truth among weak modes of a tenth of its height", "[peaks]") {
  EnsembleCover cover;
  add(cover, weak_modes(0.1, 0), 5000, 60);
  INFO(cover.text());
  // Shares of 60 cases have standard deviations of 0.060 and 0.028; the margins are three of them and the
  // 0.06 and 0.04 that are claimed.
  CHECK(cover.found > 50);
  for (const ErrorShares& shares : {cover.frequency, cover.width}) {
    CHECK(shares.one / double(cover.found) == Approx(0.68).margin(0.06 + 0.18));
    CHECK(shares.two / double(cover.found) > 0.95 - 0.04 - 0.084);
  }
}

TEST_CASE("modes that the response does not show are refused among weak modes", "[peaks]") {
  EnsembleCover cover;
  add(cover, weak_modes(0.3, 1), 100050, 25);
  CHECK(cover.found > 12);
  CHECK(cover.absurd == 0);
}

// test_modules_analysis_signals "[.coverage]" prints the shares of a thousand responses of each ensemble, by
// height. The method was settled on the first, with other seeds; on the second only how unlikely further
// poles are; on the third nothing. Errors are to hold for 68 +- 6 % and 95 +- 4 %; of the thousands, the
// lower bounds are checked.
TEST_CASE("errors cover the truth in a thousand responses at heights from 1 to 30 %", "[.coverage]") {
  for (std::size_t ensemble = 0; ensemble < ensembles; ++ensemble) {
    EnsembleCover all;
    for (const double height : {0.01, 0.03, 0.1, 0.3}) {
      EnsembleCover cover;
      add(cover, weak_modes(height, ensemble), 100000, 250);
      all += cover;
      std::cout << fmt::format("ensemble {}, height {}: {}\n", ensemble + 1, height, cover.text());
    }
    std::cout << fmt::format("ensemble {}: {}", ensemble + 1, all.text()) << std::endl;
    CHECK(all.absurd == 0);
    for (const ErrorShares& shares : {all.frequency, all.width}) {
      CHECK(shares.one / double(all.found) > 0.68 - 0.06);
      CHECK(shares.two / double(all.found) > 0.95 - 0.04);
    }
  }
}
