#include "responses.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/signals/peaks.hpp>

using namespace scree::signals;
using namespace scree::test;

namespace {

const Truth mode{101.2345678, 4, 2e-3, 0.6};

}  // namespace

TEST_CASE("without noise a mode on a background is found to round-off, between the frequencies", "[peaks]") {
  const auto f = band(60, 140, 161);
  const auto h = response(f, {mode}, {1e-4, -3e-4}, {1e-6, 2e-6});
  const auto found = fit_peaks(f, h);
  REQUIRE(found.size() == 1);
  CHECK(found[0].frequency == Approx(mode.frequency).epsilon(1e-10));
  CHECK(found[0].width == Approx(mode.width).epsilon(1e-8));
  CHECK(found[0].quality == Approx(mode.frequency / mode.width).epsilon(1e-8));
  CHECK(found[0].amplitude == Approx(mode.amplitude).epsilon(1e-8));
  CHECK(found[0].phase == Approx(mode.phase).epsilon(1e-8));
  CHECK(found[0].together == 1);
  CHECK(found[0].frequency_error < 1e-8);
}

TEST_CASE("amplitudes alone give the same for a mode alone, and nearly so on a background", "[peaks]") {
  const auto f = band(60, 140, 161);
  const auto alone = fit_peaks(f, sizes(response(f, {mode})));
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].frequency == Approx(mode.frequency).epsilon(1e-8));
  CHECK(alone[0].width == Approx(mode.width).epsilon(1e-8));
  CHECK(alone[0].amplitude == Approx(mode.amplitude).epsilon(1e-8));
  CHECK(alone[0].phase == 0);
  const auto found = fit_peaks(f, sizes(response(f, {mode}, {1e-4, -3e-4}, {1e-6, 2e-6})));
  REQUIRE(found.size() == 1);
  // (w/f0)^2 of an interference of a third of the height, 2 * 3.2e-4 / 2e-3: 5e-4 of the width.
  CHECK(found[0].frequency == Approx(mode.frequency).margin(5e-4 * mode.width));
  CHECK(found[0].width == Approx(mode.width).epsilon(5e-4));
}

TEST_CASE("two modes half a width apart are told apart", "[peaks]") {
  const Truth first{100, 4, 1, 0}, second{102, 4, 0.8, 0.3};
  const auto f = band(70, 130, 241);
  const auto h = response(f, {first, second});
  const auto exact = fit_peaks(f, h);
  REQUIRE(exact.size() == 2);
  CHECK(exact[0].together == 2);
  CHECK(exact[0].frequency == Approx(100).epsilon(1e-6));
  CHECK(exact[1].frequency == Approx(102).epsilon(1e-6));
  CHECK(exact[1].amplitude == Approx(0.8).epsilon(1e-4));
  Noise noise(1e-3, 5);
  for (int k = 0; k < 20; ++k) {
    const auto found = fit_peaks(f, noise.added(h));
    REQUIRE(found.size() == 2);
    CHECK(std::abs(found[0].frequency - 100) < 4.5 * found[0].frequency_error);
    CHECK(std::abs(found[1].frequency - 102) < 4.5 * found[1].frequency_error);
    CHECK(found[0].frequency_error < 0.2);
  }
}

TEST_CASE("modes of velocities and accelerations are those of the displacement", "[peaks]") {
  const Truth broad{100, 20, 2e-3, 0.6};  // Q = 5
  const auto f = band(40, 170, 261);
  const auto displacement = response(f, {broad});
  for (const int derivative : {1, 2}) {
    std::vector<Complex> h;
    for (std::size_t k = 0; k < f.size(); ++k)
      h.push_back(std::pow(2 * std::numbers::pi * f[k] * i, derivative) * displacement[k]);
    for (const auto& found : {fit_peaks(f, h, derivative), fit_peaks(f, sizes(h), derivative)}) {
      REQUIRE(found.size() == 1);
      CHECK(found[0].frequency == Approx(100).epsilon(1e-8));
      CHECK(found[0].quality == Approx(5).epsilon(1e-8));
      CHECK(found[0].amplitude == Approx(2e-3 * std::pow(200 * std::numbers::pi, derivative)).epsilon(1e-8));
    }
    const double phase = fit_peaks(f, h, derivative)[0].phase,
                 expected = 0.6 + derivative * std::numbers::pi / 2;
    CHECK(std::abs(std::remainder(phase - expected, 2 * std::numbers::pi)) < 1e-8);
    const double noise = 1e-2 * 2e-3 * std::pow(200 * std::numbers::pi, derivative);
    Coverage frequency, amplitude;
    Noise added(noise, 3);
    for (int k = 0; k < 400; ++k) {
      const auto found = fit_peaks(f, added.added(h), derivative);
      REQUIRE(found.size() == 1);
      frequency.add(found[0].frequency, 100, found[0].frequency_error);
      amplitude.add(found[0].amplitude, noise / 1e-2, found[0].amplitude_error);
    }
    CHECK(frequency.share() == Approx(0.68).margin(0.07));  // three times what 400 cases tell
    CHECK(amplitude.share() == Approx(0.68).margin(0.07));
  }
}

// λ/4 of a packing with what transverse modes add to it, a broad mode far away, and a background that is no
// line.
TEST_CASE("without noise, poles that only bend the background of a mode are not listed", "[peaks]") {
  const Truth main{6449, 179, 2125, 0};
  const auto f = band(5000, 7900, 146);
  auto h = response(f, {main, {6272, 565, 6.5, 1}, {6580, 568, 15, -2}, {19180, 1870, 1234, 3}});
  for (std::size_t k = 0; k < f.size(); ++k) h[k] += 3.0 * std::pow((f[k] - 6000) / 1000, 3);
  for (const auto& found : {fit_peaks(f, h), fit_peaks(f, sizes(h))}) {
    REQUIRE(found.size() == 1);
    // The broad poles together have 1 % of its height, and may be taken for a part of it.
    CHECK(found[0].frequency == Approx(main.frequency).margin(0.01 * main.width));
    CHECK(found[0].width == Approx(main.width).epsilon(0.01));
    CHECK(found[0].amplitude == Approx(main.amplitude).epsilon(0.02));
  }
  CHECK(fit_peaks(f, h)[0].together > 1);
}

TEST_CASE("a weak mode that is narrow is listed on the flank of a strong one", "[peaks]") {
  const auto f = band(70, 130, 601);
  const auto found = fit_peaks(f, response(f, {{100, 10, 1, 0}, {108, 0.6, 0.02, 1}}));
  REQUIRE(found.size() == 2);
  CHECK(found[1].frequency == Approx(108).epsilon(1e-6));
  CHECK(found[1].amplitude == Approx(0.02).epsilon(1e-4));
}

TEST_CASE("modes apart, and modes whose flanks overlap, are found by frequency", "[peaks]") {
  const std::vector<Truth> truth = {{80, 2, 1, 0}, {100, 3, 0.3, 1}, {107, 3, 0.5, -2}, {130, 4, 2, 3}};
  const auto f = band(60, 160, 1001);
  const auto found = fit_peaks(f, Noise(1e-4, 1).added(response(f, truth, 0.01)));
  REQUIRE(found.size() == 4);
  CHECK(found[1].together == 2);
  for (std::size_t k = 0; k < 4; ++k) {
    // A line stands for the flanks of modes that are not in the fit; its curvature is some 1e-3 of a height.
    CHECK(found[k].frequency == Approx(truth[k].frequency).margin(0.01 * truth[k].width));
    CHECK(found[k].amplitude == Approx(truth[k].amplitude).epsilon(0.05));
  }
}

// Beside a narrow mode, the bump at 13500 Hz is fitted with a pole that ends far away, in the range of the
// next mode.
TEST_CASE("a pole that leaves its range does not disturb the modes of another", "[peaks]") {
  const std::vector<Truth> truth = {{11060, 94, 8624, 0}, {33531, 885, 6096, 3.1}, {54262, 3027, 2042, -0.2}};
  std::vector<double> f;
  for (double at = 4000; at<60000; at += at> 10500 && at < 11500 ? 25 : at > 30000 && at < 36000 ? 125 : 250)
    f.push_back(at);
  auto h = response(f, truth, 300);
  for (std::size_t k = 0; k < f.size(); ++k)
    if (f[k] == 13500) h[k] *= 2;
  const auto found = fit_peaks(f, h);
  const auto is_middle = [&](const FittedMode& m) {
    return std::abs(m.frequency - truth[1].frequency) < 0.05 * truth[1].width;
  };
  CHECK(std::count_if(found.begin(), found.end(), is_middle) == 1);
}

TEST_CASE("errors of a mode in noise cover the true errors", "[peaks]") {
  constexpr int cases = 1000;
  constexpr double margin = 0.06 + 2 * 0.015;  // what is claimed, and two standard deviations of the share
  const auto f = band(85, 118, 133);
  const auto h = response(f, {mode}, {1e-4, -3e-4});
  Noise noise(4e-5, 3);  // a fiftieth of the height
  Coverage frequency, width, quality, amplitude, of_sizes;
  for (int k = 0; k < cases; ++k) {
    const auto found = fit_peaks(f, noise.added(h));
    REQUIRE(found.size() == 1);
    frequency.add(found[0].frequency, mode.frequency, found[0].frequency_error);
    width.add(found[0].width, mode.width, found[0].width_error);
    quality.add(found[0].quality, mode.frequency / mode.width, found[0].quality_error);
    amplitude.add(found[0].amplitude, mode.amplitude, found[0].amplitude_error);
  }
  for (const Coverage& one : {frequency, width, quality, amplitude})
    CHECK(one.share() == Approx(0.68).margin(margin));
  for (int k = 0; k < cases; ++k) {
    const auto found = fit_peaks(f, noise.added(sizes(h)));
    REQUIRE(found.size() == 1);
    of_sizes.add(found[0].frequency, mode.frequency, found[0].frequency_error);
  }
  CHECK(of_sizes.share() == Approx(0.68).margin(margin));
}

TEST_CASE("a mode near the end of the band is found, one beyond it not", "[peaks]") {
  Noise noise(1e-6, 2);
  const auto inside = band(97, 140, 173), outside = band(102, 140, 153);
  const auto found = fit_peaks(inside, noise.added(response(inside, {mode})));
  REQUIRE(found.size() == 1);
  CHECK(std::abs(found[0].frequency - mode.frequency) < 4.5 * found[0].frequency_error);
  CHECK(fit_peaks(outside, noise.added(response(outside, {mode}))).empty());
}

TEST_CASE("a flat spectrum has no modes", "[peaks]") {
  const auto f = band(1, 1000, 1000);
  CHECK(fit_peaks(f, std::vector<Complex>(1000)).empty());
  CHECK(fit_peaks(f, std::vector<Complex>(1000, {2, 1})).empty());
  CHECK(fit_peaks(f, std::vector<double>(1000, 2)).empty());
  for (unsigned seed = 1; seed <= 100; ++seed) {
    CHECK(fit_peaks(f, Noise(1, seed).added(std::vector<Complex>(1000))).empty());
    CHECK(fit_peaks(f, Noise(1, seed).added(std::vector<Complex>(1000, 5))).empty());
    CHECK(fit_peaks(f, Noise(1, seed).added(std::vector<double>(1000, 5))).empty());
  }
}

TEST_CASE("a peak of a few frequencies is no mode", "[peaks]") {
  const auto f = band(60, 140, 81);
  CHECK(fit_peaks(f, response(f, {{100.3, 2, 1, 0}})).empty());
}

TEST_CASE("a mode is found where frequencies are dense about it and sparse elsewhere", "[peaks]") {
  // 20 frequencies as in an adaptive sweep: near the mode a ninth of its width apart.
  std::vector<double> f = {6400, 6480, 6560, 6640, 6680, 6720, 6760, 6800, 6820, 6840,
                           6860, 6880, 6900, 6920, 6960, 7000, 7040, 7120, 7200, 7300};
  const auto found = fit_peaks(f, response(f, {{6854.77, 178, 3105, 0}}));
  REQUIRE(found.size() == 1);
  CHECK(found[0].frequency == Approx(6854.77).epsilon(1e-9));
}

TEST_CASE("modes of what is no spectrum are refused", "[peaks]") {
  const auto f = band(60, 140, 81);
  CHECK_THROWS_WITH(fit_peaks(f, std::vector<double>(80)),
                    "modes: 81 frequencies for 80 values; give one for each");
  CHECK_THROWS_WITH(fit_peaks(band(1, 2, 15), std::vector<double>(15)),
                    "modes: 15 frequencies; give 16 or more");
  CHECK_THROWS_WITH(fit_peaks(band(0, 80, 81), std::vector<double>(81)),
                    Catch::StartsWith("modes: frequency 0 is 0 Hz; "));
  std::vector<double> broken(81);
  broken[1] = NAN;
  CHECK_THROWS_WITH(fit_peaks(f, broken),
                    Catch::StartsWith("modes: the response at 61 Hz is not a finite number; "));
}
