#include <complex>
#include <fstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/spectrum/peaks.hpp>

using namespace scree::spectrum;

namespace {

struct Curve {
  std::vector<double> frequencies;  // (Hz)
  std::vector<std::complex<double>> response;
};

Curve curve_of(const std::string& file, double highest) {
  std::ifstream lines(SCREE_TEST_SOURCE "/tests/modules/spectrum/" + file);
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
