#include "averaged_columns.hpp"

#include "responses.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::signals;
using namespace scree::test;

namespace {

ResponseSpectrum spectrum_of_pole(std::size_t count, int derivative) {
  const auto f = band(80, 120, count);
  ResponseSpectrum spectrum{f, response(f, {{100, 6, 3, 0.4}}), false, derivative};
  for (std::size_t k = 0; k < count; ++k) spectrum.values[k] *= spectrum.factor(f[k]);
  return spectrum;
}

}  // namespace

// The column of a pole times its strength is the response itself, before and after averaging: round-off.
TEST_CASE("the column of a pole is the response of a mode of height 1", "[averaged_columns]") {
  for (const std::size_t count : {40, 64, 65, 300})
    for (const int derivative : {0, 2}) {
      CAPTURE(count, derivative);
      const ResponseSpectrum spectrum = spectrum_of_pole(count, derivative);
      const AveragedColumns columns(spectrum);
      CHECK(columns.values().cwiseAbs().maxCoeff() == Approx(1));
      CHECK(columns.values().size() == Eigen::Index(count <= 64 ? count : count == 65 ? 33 : 60));
      const Complex strength = std::polar(3 * std::abs(spectrum.factor(100)), 0.4);
      const Eigen::VectorXcd rest = columns.pole(100, 6) * strength - columns.scale() * columns.values();
      CHECK(rest.cwiseAbs().maxCoeff() < 1e-14 * columns.scale());
    }
}

TEST_CASE("frequencies are averaged in groups of one size, but for the last", "[averaged_columns]") {
  ResponseSpectrum spectrum = spectrum_of_pole(130, 0);  // groups of 3, and one of a single frequency
  const AveragedColumns columns(spectrum);
  REQUIRE(columns.frequencies().size() == 44);
  CHECK(columns.frequencies()[0] == Approx(spectrum.frequencies[1]));
  CHECK(columns.frequencies()[43] == spectrum.frequencies[129]);
}

// Central differences in frequency and width: H' by complex frequency f0 + i w/2 is what both shift.
TEST_CASE("the columns of other poles span shifts of their frequencies and widths", "[averaged_columns]") {
  const ResponseSpectrum spectrum = spectrum_of_pole(60, 0);
  const AveragedColumns columns(spectrum);
  const Eigen::MatrixXcd others = columns.others(100, {{103, 5, {}}});
  REQUIRE(others.cols() == 4);
  CHECK((others.col(0) - Eigen::VectorXcd::Ones(60)).norm() < 1e-14);
  CHECK(others(0, 1).real() == Approx(-1));
  CHECK(others(59, 1).real() == Approx(1));
  // At constant strength R, d/df0 of R/(f0^2 - f^2 + i f w) is -2 f0 R/(...)^2.
  const double h = 1e-4;
  const Eigen::VectorXcd by_frequency =
      (columns.pole(103 + h, 5) / (103 + h) - columns.pole(103 - h, 5) / (103 - h)) * (103 / (2 * h));
  CHECK((by_frequency + 2 * 103 / (103.0 * 5) * others.col(3)).norm() < 1e-6 * by_frequency.norm());
}
