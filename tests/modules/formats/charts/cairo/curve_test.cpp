#include "drawn_chart.hpp"

#include <ctime>

#include <catch2/catch.hpp>

using namespace scree::charts;

TEST_CASE("dashes and markers leave gaps, a solid line does not", "[charts]") {
  ChartSpec spec = spec_of({0, 1}, {0, 1});
  const int solid = trace(drawn(spec), red).columns;
  spec.series[0].line = LineStyle::dashed;
  const int dashed = trace(drawn(spec), red).columns;
  spec.series[0].line = LineStyle::none;
  const int markers = trace(drawn(spec), red).columns;
  CHECK(solid > 800);
  CHECK(dashed < 0.8 * solid);
  CHECK(dashed > 0.5 * solid);
  CHECK(markers < 40);
  CHECK(markers > 5);
}

TEST_CASE("where colours repeat, curves have other dashes", "[charts]") {
  // The pieces of curve number k, a level line; the others are red points.
  const auto pieces_of = [](std::size_t k) {
    ChartSpec spec = spec_of({}, {});
    spec.series.assign(k, {"other", {0}, {0}, std::array<double, 3>{1, 0, 0}, LineStyle::none, false});
    spec.series.push_back({"one", {0, 1}, {1, 1}, std::nullopt, LineStyle::solid, false});
    const Pixels picture = drawn(spec);
    const Plot plot = Plot::of(picture);
    int pieces = 0;
    bool before = false;
    for (int x = plot.left + 100; x < plot.left + 550; ++x) {
      bool is_blue = false;
      for (int y = plot.top + 1; y < plot.bottom; ++y)
        is_blue |= picture.at(x, y)[0] < 100 && picture.at(x, y)[2] > 120;
      pieces += is_blue && !before;
      before = is_blue;
    }
    return pieces;
  };
  // In 450 pixels dashes of 23.1, dots of 8.8 and pairs of 30.1 pixels.
  CHECK(pieces_of(0) == 1);
  CHECK(pieces_of(7) == Approx(19.5).margin(1));
  CHECK(pieces_of(14) == Approx(51.1).margin(1));
  CHECK(pieces_of(21) == Approx(29.9).margin(1));
}

TEST_CASE("a single point of many is seen, and noise of 300000 points takes little time", "[charts]") {
  constexpr std::size_t n = 300'000;
  std::vector<double> x(n), level(n), noise(n);
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = double(k);
    noise[k] = double(k * 2654435761u % 1000);
  }
  level[n / 2] = 1;
  const Pixels picture = drawn(spec_of(x, level));
  const Plot plot = Plot::of(picture);
  int columns = 0;
  for (int i = plot.left + 1; i < plot.right; ++i)
    columns += picture.at(i, (plot.top + plot.bottom) / 2)[1] < 128;  // not white
  CHECK(columns >= 1);
  CHECK(columns <= 4);  // a line to the point and back, 2.4 pixels wide
  // All pieces of the line would take a minute.
  const std::clock_t start = std::clock();
  CHECK(trace(drawn(spec_of(x, noise)), red).columns > 800);
  CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 10);
}
