#include "chain.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/accuracy/report.hpp>
#include <scree/accuracy/study.hpp>

using namespace scree;
using namespace scree::accuracy;
using test::Chain;
using test::driven_plan_of;

namespace {

StudyOptions of_peak(const std::string& quantity) {
  StudyOptions options;
  options.count = 3;
  options.integrations = {Integration::velocity_verlet};
  options.quantities = {quantity};
  options.tolerance = 1e-4;
  return options;
}

// Relative shift of a mode by velocity Verlet: sin(ω'h/2) = ωh/2, so that ω'/ω − 1 = (ωh)²/24 + O((ωh)⁴).
double shift(double hz, double step) { return std::pow(2 * std::numbers::pi * hz * step, 2) / 24; }

constexpr const char* grid =
    "from_hz = 70\nto_hz = 105\nstep_hz = 0.5\npulse.decay = 1e-7\nlinear.fewest_contacts = 1\npulse.samples_per_period = 20\n";

}  // namespace

TEST_CASE("a study of a peak finds the shift of its frequency by the step", "[accuracy]") {
  const Convergence result =
      study(test::driven_plan_of(Chain().text(grid)), of_peak("peaks.pulse.particles.z_8.peak_1"));
  REQUIRE(result.of_peaks);
  REQUIRE(result.quantities.size() == 2);  // no positions
  CHECK(result.quantities[0].name == "peaks.pulse.particles.z_8.peak_1.frequency");
  CHECK(result.quantities[1].name == "peaks.pulse.particles.z_8.peak_1.quality");
  const double mode = Chain::mode_hz(2);
  // The fit leaves 1e-5 of the other modes.
  CHECK(result.quantities[0].reference == Approx(mode).epsilon(1e-4));
  int compared = 0;
  for (const SettingResult& o : result.outcomes) {
    CAPTURE(o.setting.step, o.errors[0], o.problem);
    // The next term is smaller by (ωh)² = 0.012 at most; damping, Q = 20, shifts the mode by 1/(8 Q²) = 3e-4
    // of itself.
    CHECK(o.errors[0] == Approx(shift(mode, o.setting.step)).epsilon(0.02));
    ++compared;
  }
  CHECK(compared == 3);
  REQUIRE(result.orders[0].of_quantities[0]);
  CHECK(*result.orders[0].of_quantities[0] == Approx(2).margin(0.02));
  // (ωh)²/24 = 1e-4.
  REQUIRE(result.longest_steps[0].of_quantities[0]);
  CHECK(*result.longest_steps[0].of_quantities[0] ==
        Approx(std::sqrt(24e-4) / (2 * std::numbers::pi * mode)).epsilon(0.02));
  const std::string report = text_report(result);
  INFO(report);
  CHECK(report.find("peaks.pulse.particles.z_8.peak_1.frequency: observed order, and longest step (s) within "
                    "0.0001\n") != std::string::npos);
}

TEST_CASE("a study of a peak of the linear method finds no error of the step", "[accuracy]") {
  StudyOptions options = of_peak("peaks.linear.particles.z_8.3lambda/4.frequency");
  options.count = 2;
  const Convergence result =
      study(test::driven_plan_of(
                Chain().text("from_hz = 20\nto_hz = 160\nstep_hz = 0.5\nlinear.fewest_contacts = 1\n"
                             "shape_from = 'profile'\n") +
                Chain::layers),
            options);
  REQUIRE(result.quantities.size() == 1);
  CHECK(result.quantities[0].reference == Approx(Chain::mode_hz(2)).epsilon(1e-4));
  for (const SettingResult& o : result.outcomes) CHECK(o.errors[0] < 1e-10);
  CHECK(*result.longest_steps[0].of_worst == 4 * Chain::step);
}

TEST_CASE("a study compares peaks that [[expect]] names, and refuses to mix them with those of a run",
          "[accuracy]") {
  const std::string text = Chain().text(grid);
  const std::string expect =
      "[[expect]]\nrequirement = 'r'\nquantity = 'peaks.linear.particles.z_8.peak_1.frequency'\nat_least = 1\n";
  StudyOptions options = of_peak("");
  options.count = 2;
  options.quantities.clear();
  CHECK(study(test::driven_plan_of(text + expect), options).quantities.size() == 1);
  const auto refused = [&](const std::vector<std::string>& quantities) {
    options.quantities = quantities;
    return test::message([&] { study(test::driven_plan_of(text), options); });
  };
  CHECK(refused({"peaks.pulse.particles.z_8.peak_1.frequncy"}).find("did you mean") != std::string::npos);
  CHECK(refused({"particles.z_1.last", "peaks.pulse.particles.z_8.peak_1"})
            .find("study them one after the other") != std::string::npos);
  CHECK(refused({"particles.z_1.last"}).find("says nothing of how long it lasts") != std::string::npos);
  CHECK(refused({"peaks.linear.particles.z_8.peak_9"}).find("nothing is left to compare") !=
        std::string::npos);
}
