#include "mode_model.hpp"

#include "responses.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::signals;
using namespace scree::test;

namespace {

// Two modes on a background, of displacements, velocities or accelerations.
struct Example {
  std::vector<Truth> modes = {{100, 4, 1, 0.6}, {104, 6, 0.5, -2}};
  ResponseSpectrum spectrum;

  explicit Example(int derivative) {
    spectrum.frequencies = band(90, 114, 41);
    spectrum.values = response(spectrum.frequencies, modes, {0.02, 0.01}, {1e-3, -2e-3});
    spectrum.derivative = derivative;
    for (std::size_t k = 0; k < 41; ++k) spectrum.values[k] *= spectrum.factor(spectrum.frequencies[k]);
  }
  Example amplitudes() const {
    Example sized = *this;
    sized.spectrum.only_amplitudes = true;
    for (Complex& value : sized.spectrum.values) value = std::abs(value);
    return sized;
  }
  std::vector<Pole> poles() const {
    return {{modes[0].frequency, modes[0].width}, {modes[1].frequency, modes[1].width}};
  }
};

}  // namespace

// A linear problem with a condition below 1e4: round-off 1e-12 of the parameters.
TEST_CASE("with the true frequencies and widths a model starts at the true strengths", "[mode_model]") {
  for (const int derivative : {0, 1, 2}) {
    const Example example(derivative);
    const ModeModel model(example.spectrum, 2);
    const Eigen::VectorXd at = model.start(example.poles());
    for (std::size_t p = 0; p < 2; ++p) {
      const Truth& mode = example.modes[p];
      const Complex strength = std::polar(mode.amplitude * mode.frequency * mode.width, mode.phase);
      CHECK(std::abs(Complex(at[4 * Eigen::Index(p) + 2], at[4 * Eigen::Index(p) + 3]) - strength) <
            1e-10 * std::abs(strength));
    }
    double largest = 0;
    for (const Complex& value : example.spectrum.values) largest = std::max(largest, std::abs(value));
    CHECK(model.evaluate(at, nullptr).cwiseAbs().maxCoeff() < 1e-11 * largest);
  }
}

// |H|^2 of poles far apart on no background is the sum of theirs and of their interference, which the model
// has in full.
TEST_CASE("the model of amplitudes has the squares of strengths of poles", "[mode_model]") {
  Example example(0);
  example.modes = {{100, 4, 1, 0.6}};
  example.spectrum.values = response(example.spectrum.frequencies, example.modes);
  const Example sized = example.amplitudes();
  const ModeModel model(sized.spectrum, 1);
  CHECK(model.free_parameters() == model.parameters() - 2);
  CHECK(model.residuals() == 41);
  const Eigen::VectorXd at = model.start({{100, 4}});
  CHECK(at[2] == Approx(400.0 * 400.0).epsilon(1e-9));
  CHECK(model.evaluate(at, nullptr).cwiseAbs().maxCoeff() < 1e-10);
}

// Central differences with steps h of 1e-5 of a parameter: errors of h^2 and of 1e-16/h.
TEST_CASE("the derivatives of a model are those of its residuals", "[mode_model]") {
  for (const int derivative : {0, 1, 2})
    for (const bool only_amplitudes : {false, true})
      for (const int degree : {1, 2}) {
        CAPTURE(derivative, only_amplitudes, degree);
        const Example complex(derivative), example = only_amplitudes ? complex.amplitudes() : complex;
        const ModeModel model(example.spectrum, 2, degree);
        Eigen::VectorXd at = model.start({{100.3, 4.2}, {103.6, 5.5}});
        Eigen::MatrixXd derivatives;
        const Eigen::VectorXd rest = model.evaluate(at, &derivatives);
        REQUIRE(rest.allFinite());
        for (Eigen::Index k = 0; k < model.parameters(); ++k) {
          const bool fixed = only_amplitudes && k >= model.of_poles() && k % 2 == 1;
          if (fixed) {
            CHECK(derivatives.col(k).norm() == 0);
            continue;
          }
          const double step = 1e-5 * std::max(std::abs(at[k]), 1e-3), before = at[k];
          at[k] = before + step;
          const Eigen::VectorXd more = model.evaluate(at, nullptr);
          at[k] = before - step;
          const Eigen::VectorXd less = model.evaluate(at, nullptr);
          at[k] = before;
          const Eigen::VectorXd expected = (more - less) / (2 * step);
          CAPTURE(k);
          CHECK((derivatives.col(k) - expected).norm() < 1e-6 * expected.norm());
        }
      }
}
