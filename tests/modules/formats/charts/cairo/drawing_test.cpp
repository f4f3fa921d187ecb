#include "drawn_chart.hpp"

#include <catch2/catch.hpp>

using namespace scree::charts;

TEST_CASE("points of a curve are where the axes put them", "[charts]") {
  // Margins: 2 % of the range of x at both ends, 5 % of that of y.
  const Pixels picture = drawn(spec_of({0, 1, 2}, {0, 4, 1}));
  CHECK(picture.width == 1200);
  CHECK(picture.height == 900);
  const Plot plot = Plot::of(picture);
  REQUIRE(plot.right - plot.left > 900);
  REQUIRE(plot.bottom - plot.top > 600);
  const auto x_of = [&](double x) { return plot.left + (x / 2 + 0.02) / 1.04 * (plot.right - plot.left); };
  const auto y_of = [&](double y) { return plot.bottom - (y / 4 + 0.05) / 1.1 * (plot.bottom - plot.top); };
  // The middle of the line in the column: it is 2.4 pixels wide, the edges of the frame are known to a pixel.
  const auto row_of = [&](double x) {
    double sum = 0, count = 0;
    for (int y = plot.top + 1; y < plot.bottom; ++y)
      if (is_near(picture.at(int(std::lround(x_of(x))), y), red)) sum += y, ++count;
    return count > 0 ? sum / count : -1;
  };
  // The line rises by 1.3 pixels a pixel, and its corner is round.
  CHECK(row_of(0.5) == Approx(y_of(2)).margin(3));
  CHECK(row_of(1.5) == Approx(y_of(2.5)).margin(3));
  CHECK(row_of(1) == Approx(y_of(4)).margin(5));
}

TEST_CASE("a power law is straight between logarithmic axes", "[charts]") {
  const auto chart = [](std::vector<double> x, std::vector<double> y) {
    ChartSpec spec = spec_of(std::move(x), std::move(y));
    spec.log_x = spec.log_y = true;
    return drawn(spec);
  };
  const Pixels bent = chart({1e-3, 1e-1, 1e3}, {1e-6, 1e-2, 1e6}), straight = chart({1e-3, 1e3}, {1e-6, 1e6});
  CHECK(trace(bent, red).columns > 800);
  int different = 0;
  for (int y = 0; y < bent.height; ++y)
    for (int x = 0; x < bent.width; ++x) different += !is_near(bent.at(x, y), straight.at(x, y));
  CHECK(different < 20);  // at the joint
}
