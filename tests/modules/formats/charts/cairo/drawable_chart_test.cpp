#include "drawn_chart.hpp"

#include <catch2/catch.hpp>

using namespace scree::charts;

TEST_CASE("points without a logarithm or a value are gaps, and a note below the title counts them",
          "[charts]") {
  ChartSpec spec = spec_of({0, 1, 10, 100}, {1, 1, 2, 3});
  spec.log_x = true;
  const Pixels first_left_out = drawn(spec);
  spec.series[0].x[0] = 1;  // where the next point is: the same line, and nothing to count
  const Pixels whole = drawn(spec);
  CHECK(trace(first_left_out, red).columns == trace(whole, red).columns);
  const auto has_ink = [](const Pixels& picture, int from, int to) {
    for (int y = from; y < to; ++y)
      for (int x = 0; x < picture.width; ++x)
        if (picture.at(x, y)[0] < 128) return true;
    return false;
  };
  // The title is in the upper 50 of 900 pixels, the note below it.
  CHECK(has_ink(first_left_out, 52, 75));
  CHECK_FALSE(has_ink(whole, 52, 60));
  // The gap at 2 leaves a third of the line, from 0 to 1, and a dot at 3.
  const int all = trace(drawn(spec_of({0, 1, 2, 3}, {1, 1, 1, 1})), red).columns;
  const int gap = trace(drawn(spec_of({0, 1, 2, 3}, {1, 1, NAN, 1})), red).columns;
  CHECK(gap > all / 4);
  CHECK(gap < all / 2);
}

TEST_CASE("text of any bytes is drawn, and nothing else is lost by it", "[charts]") {
  ChartSpec spec = spec_of({1, 2, 3}, {1, 2, 3});
  spec.title = spec.x_label = spec.y_label = spec.series[0].name = "a\xFFz\n\x01\xC3";
  CHECK(trace(drawn(spec), red).columns > 800);
  CHECK(file_of(spec, "svg").find("<title>a?z  ?</title>") != std::string::npos);
}

TEST_CASE("errors are as many as values, and go with their points", "[charts]") {
  ChartSpec spec = spec_of({0, 1, 2}, {NAN, 1, 2});
  spec.series[0].y_error = {0.1, 0.1};
  CHECK_THROWS_WITH(
      file_of(spec, "svg"),
      Catch::Contains("series \"one\" has 3 y values and 2 errors; give one for each, or none"));
  spec.series[0].y_error = {5, 0.1, NAN};
  CHECK(drawn(spec).width > 0);
}
