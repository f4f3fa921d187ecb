#include "tone.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree::spectrum;

namespace {

constexpr double pi = std::numbers::pi, frequency = 50,
                 interval = 1 / (50 * frequency);  // 50 samples in a period

SpectrumPlan plan_of_tone(bool relative = false) {
  SpectrumPlan plan;
  plan.observed.resize(1);
  plan.observed[0].relative = relative;
  plan.sweep.samples_per_period = 50;
  plan.sweep.analysed_periods = 20;
  return plan;
}

}  // namespace

TEST_CASE("a tone has the response over the drive, whatever the column drifts by", "[spectrum]") {
  const bool averaged = GENERATE(false, true);
  const std::complex<double> response = std::polar(3.0, -0.7);
  const double drive_phase = 0.4;
  for (const bool relative : {false, true}) {
    const SpectrumPlan plan = plan_of_tone(relative);
    Tone tone(plan, frequency, 20, averaged);
    double sum = 0;
    for (int k = 0; k < 20 * 50; ++k) {
      const double t = k * interval, angle = 2 * pi * frequency * t + drive_phase;
      const double x = 7 + 0.05 * t + 1e-6 * 3 * std::sin(angle - 0.7);
      tone.add(t, 1e-6 * std::sin(angle), {x});
      sum += x;
    }
    CHECK(tone.amplitude() == Approx(1e-6).epsilon(1e-9));
    const SweepPoint::Column found = tone.columns()[0];
    CHECK(found.mean == Approx(sum / 1000).epsilon(1e-12));
    const double scale = relative ? 1 / found.mean : 1;
    // Round-off of 7 over an amplitude of 3e-6, in the mean of a thousand samples.
    CHECK(std::abs(found.response - scale * response) < scale * 1e-8);
  }
}

TEST_CASE("halves of a tone differ if its amplitude changes between them", "[spectrum]") {
  const auto differs = [](double growth, double scale) {
    SpectrumPlan plan = plan_of_tone();
    plan.sweep.tolerance = 1e-2;
    const double middle = 10 / frequency;
    ToneHalves halves(plan, frequency, middle);
    for (int k = 0; k < 20 * 50; ++k) {
      const double t = k * interval, angle = 2 * pi * frequency * t;
      halves.add(t, 1e-6 * std::sin(angle), {2e-6 * (t < middle ? 1 : 1 + growth) * std::sin(angle)});
    }
    return halves.differ({scale});
  };
  CHECK_FALSE(differs(0, 1));
  CHECK_FALSE(differs(0.009, 1));
  CHECK(differs(0.011, 1));
  // Small beside the scale of the column.
  CHECK_FALSE(differs(0.011, 100));
}
