#include <complex>
#include <fstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/signals/peaks.hpp>

using namespace scree::signals;

namespace {

struct Curve {
  std::vector<double> frequencies;  // (Hz)
  std::vector<std::complex<double>> response;
};

Curve curve_of(const std::string& file, double highest) {
  std::ifstream lines(SCREE_TEST_SOURCE "/tests/modules/analysis/signals/" + file);
  std::string comment, head;
  std::getline(lines, comment), std::getline(lines, head);
  Curve curve;
  double frequency = 0, real = 0, imaginary = 0;
  for (char comma = 0; lines >> frequency >> comma >> real >> comma >> imaginary;) {
    if (frequency > highest) break;
    curve.frequencies.push_back(frequency);
    curve.response.emplace_back(real, imaginary);
  }
  return curve;
}

}  // namespace

// The fit of four poles about 24 kHz, of the round before, does not come to rest once the modes above are known better.
TEST_CASE("a mode whose group no longer comes to rest from the poles of an earlier round is found",
          "[spectrum]") {
  for (const double highest : {60e3, 110e3}) {
    const Curve curve = curve_of("packing_22_kPa.csv", highest);
    REQUIRE(curve.frequencies.size() > 200);
    const std::vector<Mode> modes = find_modes(curve.frequencies, curve.response);
    CAPTURE(highest);
    REQUIRE(modes.size() >= 3);
    // The maxima of the curve are at 8164, 24100 and 39700 Hz, 300 Hz apart at the latter two.
    CHECK(modes[0].frequency == Approx(8164).margin(10));
    CHECK(modes[1].frequency == Approx(24100).margin(300));
    CHECK(modes[2].frequency == Approx(39700).margin(300));
  }
}

// Twelve numbers of two poles 0.01 Hz apart, with opposite phases, fit 37 values of a single mode, 84 Hz wide, best of all.
TEST_CASE("a mode is not split in two in one place", "[spectrum]") {
  const Curve curve = curve_of("packing_113_kPa.csv", 60e3);
  REQUIRE(curve.frequencies.size() > 300);
  const std::vector<Mode> modes = find_modes(curve.frequencies, curve.response);
  REQUIRE(modes.size() == 3);
  // The maxima of the curve, found within the spacing of its frequencies; flanks of other modes move those of wide modes by a share of the
  // width, which is 1 and 5 kHz at the upper two.
  CHECK(modes[0].frequency == Approx(10850).margin(12.5));
  CHECK(modes[1].frequency == Approx(32125).margin(250 + 0.1 * modes[1].width));
  CHECK(modes[2].frequency == Approx(52250).margin(250 + 0.1 * modes[2].width));
  // Half a spacing beside its peak, the curve is 1.1 % below it; the background, from the curve at 9 and 13 kHz less the flanks of the mode,
  // is less than 1 % of it.
  CHECK(modes[0].amplitude == Approx(8692.7).epsilon(0.021));
  for (const Mode& mode : modes) CHECK(mode.amplitude_error < mode.amplitude);
}
