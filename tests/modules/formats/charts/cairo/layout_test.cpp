#include "drawn_chart.hpp"

#include <ctime>

#include <catch2/catch.hpp>

using namespace scree::charts;

namespace {

ChartSpec with_second(std::vector<double> x, std::vector<double> y) {
  ChartSpec spec = spec_of({0, 1}, {0, 1});
  spec.series.push_back({"two", std::move(x), std::move(y), std::array<double, 3>{0, 0, 1}});
  return spec;
}

}  // namespace

TEST_CASE("the legend hides no curve", "[charts]") {
  const Pixels alone = drawn(spec_of({0, 1}, {0, 1}));
  const Pixels both = drawn(with_second({0, 1}, {0, 0.9}));
  // The second curve covers the first where both begin.
  CHECK(trace(both, red).columns >= trace(alone, red).columns - 10);
  // Curves in all corners: the legend is beside the plot, which is narrower.
  const Plot wide = Plot::of(alone), narrow = Plot::of(drawn(with_second({0, 1, 1, 0, 0}, {0, 0, 1, 1, 0})));
  CHECK(narrow.right < wide.right - 50);
}

TEST_CASE("a legend of many curves stays in the picture", "[charts]") {
  ChartSpec spec = spec_of({0, 1}, {0, 1});
  for (int k = 0; k < 60; ++k)
    spec.series.push_back({"curve", {0, 1}, {1 - k / 60.0, k / 60.0}, std::array<double, 3>{0, 1, 0}});
  spec.series.back().color = {0, 0, 1};
  const Pixels picture = drawn(spec);
  const Plot plot = Plot::of(picture);
  int samples = 0;  // of the last curve, beside the plot; its line is thinner than a pixel
  for (int y = 0; y < picture.height; ++y)
    for (int x = plot.right + 5; x < picture.width; ++x)
      samples += picture.at(x, y)[2] > picture.at(x, y)[1] + 60;
  CHECK(samples > 0);
}

TEST_CASE("a title of any length is drawn in little time", "[charts]") {
  ChartSpec spec = spec_of({1, 2, 3}, {1, 2, 3});
  std::string words;
  for (int k = 0; k < 10000; ++k) words += "word ";
  for (const std::string& title : {std::string(50000, 'm'), words}) {
    spec.title = spec.x_label = spec.series[0].name = title;
    const std::clock_t start = std::clock();
    CHECK(trace(drawn(spec), red).columns > 300);
    // A chart takes 0.1 s; measuring all of the text again for each letter would take minutes.
    CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 5);
  }
}

TEST_CASE("bars of errors are within the plot", "[charts]") {
  ChartSpec spec = spec_of({0, 1, 2}, {1, 1, 1});
  spec.series[0].line = LineStyle::none;
  spec.series[0].markers = true;
  spec.series[0].y_error = {NAN, 1, NAN};
  const Pixels picture = drawn(spec);
  const Plot plot = Plot::of(picture);
  // The bar goes over all of the plot but its margins; its caps are wider than the mark is.
  int rows = 0;
  for (int y = plot.top; y < plot.bottom; ++y) {
    bool found = false;
    for (int x = plot.left + 1; x < plot.right && !found; ++x) found = is_near(picture.at(x, y), red);
    rows += found;
  }
  CHECK(rows > 0.85 * (plot.bottom - plot.top));
  // On a logarithmic axis it has no lower end, and the values alone give the range.
  spec.log_y = true;
  spec.series[0].y_error = {NAN, 1.5, NAN};
  CHECK(Plot::of(drawn(spec)).bottom > 0);
}
