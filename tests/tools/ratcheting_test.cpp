#include "program.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

using namespace scree::test;

namespace {

// Strain γ = L_y/L_y0 − L_x/L_x0 at the least load of each cycle, as its straight line over the cycles.
struct Accumulation {
  double slope, deviation, range;  // a cycle; root mean square about the line; largest minus smallest
};

Accumulation accumulation_of(const std::string& series, std::size_t dropped) {
  std::istringstream lines(series);
  std::vector<std::pair<double, double>> lengths;
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {
    double time, x, y;
    REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf", &time, &x, &y) == 3);
    lengths.push_back({x, y});
  }
  REQUIRE(lengths.size() > dropped + 20);
  lengths.erase(lengths.begin(), lengths.begin() + std::ptrdiff_t(dropped));
  std::vector<double> strain;
  for (const auto& [x, y] : lengths) strain.push_back(y / lengths[0].second - x / lengths[0].first);
  const double n = double(strain.size()), middle = 0.5 * (n - 1);
  double mean = 0, slope = 0, square = 0;
  for (const double s : strain) mean += s / n;
  for (std::size_t k = 0; k < strain.size(); ++k)
    slope += (double(k) - middle) * (strain[k] - mean) / (n * (n * n - 1) / 12);
  for (std::size_t k = 0; k < strain.size(); ++k)
    square += std::pow(strain[k] - mean - slope * (double(k) - middle), 2) / n;
  const auto [least, most] = std::minmax_element(strain.begin(), strain.end());
  return {slope, std::sqrt(square), *most - *least};
}

Accumulation run(const Workspace& w, const std::string& settings, std::size_t dropped) {
  const Outcome outcome =
      w.scree("run " SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml --quiet --overwrite --out out" +
              settings);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  REQUIRE(outcome.err.empty());
  return accumulation_of(w.text("out/series/load.csv"), dropped);
}

Accumulation run(const Workspace& w, const std::string& law, int seed, const std::string& step) {
  return run(w,
             " --set stage.cycles.cycles=60 --set contact.discs.plugin=" + law +
                 " --set scene.seed=" + std::to_string(seed) + " --set time.step=" + step,
             29);
}

// Elliptic load without slip, [M4] and [M5] with cos(ωt + φ).
Accumulation run_ellipse(const Workspace& w, const std::string& law, double phase_deg) {
  const std::string loaded = " --set stage.cycles.set.box.stress_x_high.";
  return run(w,
             " --set stage.cycles.cycles=36 --set stage.cycles.set.discs.friction=1e9 --set time.step=1e-3"
             " --set contact.discs.plugin=" +
                 law + loaded + "mean=1.15" + loaded + "amplitude=0.15" + loaded +
                 "phase_deg=" + std::to_string(phase_deg - 90),
             15);
}

}  // namespace

// McNamara, García-Rojo, Herrmann 2008, section IV B: the law of the tangential spring decides, with all else
// the same.
TEST_CASE("16 discs ratchet with the spring of Cundall and Strack alone", "[tools]") {
  const Workspace w;
  for (const int seed : {3, 5}) {
    INFO("seed " << seed);
    const Accumulation coarse = run(w, "disc_cundall_strack", seed, "1e-3"),
                       fine = run(w, "disc_cundall_strack", seed, "5e-4");
    CHECK(fine.deviation < std::abs(fine.slope));
    // Exponents of the step as demanded: 0 ± 0.1, and 1 ± 0.1.
    CHECK(std::abs(std::log2(coarse.slope / fine.slope)) < 0.1);

    const Accumulation coarse_corrected = run(w, "disc_corrected", seed, "1e-3"),
                       fine_corrected = run(w, "disc_corrected", seed, "5e-4");
    CHECK(fine_corrected.deviation < std::abs(fine_corrected.slope));
    CHECK(std::log2(coarse_corrected.slope / fine_corrected.slope) == Approx(1).margin(0.1));

    // Demanded: constant below 1e-13. Round-off of the lengths: 1e-16.
    CHECK(run(w, "disc_angular", seed, "1e-3").range < 1e-13);
  }
}

// Section II C, figure 5: Δγ = A sin φ with the spring of Cundall and Strack, 0 with painted points.
TEST_CASE("16 discs without slip ratchet in proportion to the area of an elliptic load", "[tools]") {
  const Workspace w;
  const Accumulation narrow = run_ellipse(w, "disc_cundall_strack", 30),
                     wide = run_ellipse(w, "disc_cundall_strack", 90);
  CHECK(wide.deviation < std::abs(wide.slope));
  // Demanded: R² > 0.99 of the sine, deviations of a tenth.
  CHECK(narrow.slope / wide.slope == Approx(0.5).epsilon(0.1));
  // Demanded: constant below 1e-13. Round-off of the lengths: 1e-16.
  for (const double phase_deg : {30, 90}) CHECK(run_ellipse(w, "disc_angular", phase_deg).range < 1e-13);
}
