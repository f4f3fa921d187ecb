#include "oscillator.hpp"
#include "run_support.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/run/run_in_memory.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("a lock-in measures the response of a driven oscillator", "[run]") {
  // As in the text.
  constexpr double stiffness = 1e4, damping = 10, frequency = 20, drive = 1e-6, drive_phase = pi / 6;
  const std::complex<double> i(0, 1);
  const double w = 2 * pi * frequency;
  // m x" = k (u − x) − k x + γ (u' − x') − γ x'
  const std::complex<double> response = drive * std::exp(i * drive_phase) * (stiffness + i * w * damping) /
                                        (2 * stiffness - w * w + 2.0 * i * w * damping);
  const std::vector<double> found = run_in_memory(plan_of(oscillator), {}).quantities;
  // (ω_0 h)² = 8e-4 is the step error of second order; the motion at the start has decayed by exp(−25).
  CHECK(found[0] == Approx(std::abs(response)).epsilon(8e-4));
  CHECK(found[1] == Approx(std::arg(response)).epsilon(0).margin(8e-4));
  CHECK(found[2] == 1000);
  CHECK(found[3] < 1e-6 * std::abs(response));
}

TEST_CASE("a record beyond the end of the run is refused where its probe stands", "[run]") {
  const scenario::Plan plan = plan_of(oscillator, {"probe.response.from=4"});
  const std::string line = message([&] { run_in_memory(plan, {}); });
  INFO(line);
  CHECK(line.find("scene.toml:") != std::string::npos);
  CHECK(line.find("probe lock_in: from = 4 s is not before 3.5 s, when the run") != std::string::npos);
}
