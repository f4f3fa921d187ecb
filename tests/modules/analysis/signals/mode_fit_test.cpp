#include "mode_fit.hpp"

#include "responses.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::signals;
using namespace scree::test;

namespace {

const std::vector<Truth> two_modes = {{100, 4, 1, 0.6}, {107, 6, 0.5, -2}};
const std::vector<Pole> start_poles = {{100.8, 5}, {106, 4.5}};

ResponseSpectrum spectrum_of_values(std::vector<Complex> values, int derivative = 0) {
  return {band(88, 120, values.size()), std::move(values), false, derivative};
}

}  // namespace

TEST_CASE("a fit finds the poles of a response without noise", "[mode_fit]") {
  const ResponseSpectrum exact =
      spectrum_of_values(response(band(88, 120, 81), two_modes, {0.02, 0.01}, {1e-3, -2e-3}));
  const ModeFit fit = fit_modes(exact, start_poles);
  CHECK(fit.converged);
  REQUIRE(fit.poles.size() == 2);
  for (std::size_t p = 0; p < 2; ++p) {
    const FittedMode mode = mode_of(fit, p, exact);
    // Round-off, by a condition of 1e4.
    CHECK(mode.frequency == Approx(two_modes[p].frequency).epsilon(1e-11));
    CHECK(mode.width == Approx(two_modes[p].width).epsilon(1e-9));
    CHECK(mode.quality == Approx(two_modes[p].frequency / two_modes[p].width).epsilon(1e-9));
    CHECK(mode.amplitude == Approx(two_modes[p].amplitude).epsilon(1e-9));
    CHECK(mode.phase == Approx(two_modes[p].phase).epsilon(1e-9));
    CHECK(mode.together == 2);
    CHECK(mode.points == 81);
  }
}

// 200 cases tell a standard deviation to 5 %; three of these are allowed.
TEST_CASE("the covariance of a fit is the scatter of its numbers in white noise", "[mode_fit]") {
  const auto f = band(88, 120, 81);
  const std::vector<Complex> exact = response(f, two_modes);
  Noise noise(0.02, 5);
  constexpr int cases = 200;
  Eigen::VectorXd truth(8), square = Eigen::VectorXd::Zero(8), expected = square;
  for (std::size_t p = 0; p < 2; ++p) {
    const Complex strength =
        std::polar(two_modes[p].amplitude * two_modes[p].frequency * two_modes[p].width, two_modes[p].phase);
    truth.segment(4 * Eigen::Index(p), 4) << two_modes[p].frequency, two_modes[p].width, strength.real(),
        strength.imag();
  }
  double excess = 0;
  for (int k = 0; k < cases; ++k) {
    const ModeFit fit = fit_modes(spectrum_of_values(noise.added(exact)), start_poles);
    REQUIRE(fit.converged);
    Eigen::VectorXd found(8);
    for (std::size_t p = 0; p < 2; ++p)
      found.segment(4 * Eigen::Index(p), 4) << fit.poles[p].frequency, fit.poles[p].width,
          fit.poles[p].strength.real(), fit.poles[p].strength.imag();
    square += (found - truth).cwiseAbs2() / cases;
    expected += fit.covariance.diagonal() / cases;
    excess += fit.excess / cases;
  }
  for (Eigen::Index k = 0; k < 8; ++k) {
    CAPTURE(k);
    CHECK(std::sqrt(square[k] / expected[k]) == Approx(1).margin(0.15));
  }
  CHECK(excess < 1.1);  // residuals are white
}

TEST_CASE("a pole stands out if its height is a quarter of what others change over its width", "[mode_fit]") {
  // At its own frequency f0 a pole of height 1 and width w changes by 2/w per Hz. Its neighbour of width v
  // there:
  const auto fit_with = [](double height) {
    return ModeFit{{{100, 4, {400, 0}}, {100, 40, {height * 4000, 0}}}, {}, 0, 0, 0, 1, true};
  };
  // |d/df of 4000 h/(f0^2 - f^2 + 40 i f)| = 4000 h |2 f0 - 40 i|/(40 f0)^2 = h |200 - 40 i|/4000 at f0.
  const double limit = 4 / (4 * std::abs(Complex(200, 40)) / 4000);
  CHECK(stands_out(fit_with(0.99 * limit), 0, false));
  CHECK_FALSE(stands_out(fit_with(1.01 * limit), 0, false));
}
