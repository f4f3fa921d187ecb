#include "program.hpp"

#include <cmath>
#include <map>

using namespace scree::test;

namespace {

const std::string folder = SCREE_TEST_SOURCE "/scenarios/lemrich2017/";

// The frequency (Hz) of each peak with a name, by wavelengths. Up to 5λ/4, of which modes do not overlap,
// names occur once.
std::map<double, double> frequencies_of(const nlohmann::json& record) {
  std::map<double, double> frequencies;
  for (const nlohmann::json& peak : record["peaks"]["linear"]["strain.distance"]) {
    if (!peak.contains("name")) continue;
    const double wavelengths = peak["wavelengths"];
    CHECK((wavelengths > 1.25 || !frequencies.contains(wavelengths)));
    frequencies[wavelengths] = peak["frequency"];
  }
  return frequencies;
}

// Under 10 kPa, with seed 1.
std::filesystem::path prepared_state(const Workspace& w) {
  for (const auto& entry : std::filesystem::directory_iterator(w / "out/prepare")) {
    const std::string scenario = text_of(entry.path() / "scenario.toml");
    if (scenario.find("stress = 10000") != std::string::npos &&
        scenario.find("\nseed = 1\n") != std::string::npos)
      return entry.path() / "final_state.h5";
  }
  return {};
}

double amplitude_at(const std::string& table, const std::string& method, const std::string& hz) {
  const std::size_t line = table.find(method + ',' + hz + ',');
  REQUIRE(line != std::string::npos);
  return std::stod(table.substr(line + method.size() + hz.size() + 2));
}

}  // namespace

// 448 beads of paper L's packing: as high, a third as wide.
TEST_CASE("slender packings have the peaks and the exponent of Lemrich et al.", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.scree("campaign " + folder + "slender.toml --out out --jobs 2");
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);

  double exponent = 0;
  for (const char* seed : {"1", "2"}) {
    const auto peaks = [&](const std::string& stress) {
      const std::string run = "out/case=" + stress + ",upper=0.0033333_1_0.0033333,seed=" + seed;
      return frequencies_of(w.record(run, "spectrum.json"));
    };
    const std::map<double, double> low = peaks("10kPa"), high = peaks("113kPa");
    // 1 : 3 : 5. A layer of a bead's height has about 16 beads, so that its stiffness is uncertain by a
    // quarter and that of a quarter of a wavelength, four layers, by an eighth; frequencies by half of that,
    // their ratios by 9 %. Twice that is allowed.
    CHECK(low.at(0.75) / low.at(0.25) == Approx(3).epsilon(0.18));
    CHECK(low.at(1.25) / low.at(0.25) == Approx(5).epsilon(0.18));
    exponent += 0.5 * std::log(high.at(0.75) / low.at(0.75)) / std::log(11.3);
  }
  CHECK(std::abs(exponent - 1.0 / 6) < 0.03);

  // The stepped sweep against the linear method at the peak. Of the transient, exp(-π 40/13) = 6e-5 is left;
  // at ten times this drive, where rolling resistance reaches its largest torque in some contacts, both
  // differ by 1 %.
  const std::string scene =
      "spectrum " + folder + "spectrum.toml --quiet --set particles.state=" + prepared_state(w).string() +
      " --set boundary.periodic.upper=[3.3333e-3,1,3.3333e-3] --set boundary.bottom.area=1.1111e-5"
      " --set time.step=1.2e-7 --set spectrum.from_hz=19e3 --set spectrum.to_hz=20e3"
      " --set spectrum.step_hz=500 --set spectrum.amplitude=1e-11 --set spectrum.sweep.periods=60"
      " --set spectrum.sweep.analysed_periods=20 ";
  REQUIRE(w.scree(scene + "--by sweep --out sweep").status == 0);
  REQUIRE(w.scree(scene + "--by linear --out linear").status == 0);
  const std::string sweep = w.text("sweep/spectrum.csv"), linear = w.text("linear/spectrum.csv");
  for (const char* hz : {"19000", "19500", "20000"})
    CHECK(amplitude_at(sweep, "sweep", hz) == Approx(amplitude_at(linear, "linear", hz)).epsilon(3e-3));
}
