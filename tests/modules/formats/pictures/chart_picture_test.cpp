#include "sample_frame.hpp"

#include <ctime>
#include <limits>

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

namespace {

// Columns of the plot area with a colour similar to the given one, its lowest and highest row from the top.
struct Trace {
  int columns = 0;
  int first_row = -1;  // of the leftmost column
  int last_row = -1;   // of the rightmost column
};

Trace trace(const Picture& picture, int red, int green, int blue) {
  Trace found;
  for (int x = picture.width / 8; x < picture.width; ++x)
    for (int y = picture.height / 10; y < picture.height * 85 / 100; ++y) {
      const auto c = picture.at(x, y);
      if (std::abs(c[0] - red) > 30 || std::abs(c[1] - green) > 30 || std::abs(c[2] - blue) > 30) continue;
      if (found.first_row < 0) found.first_row = y;
      found.last_row = y;
      ++found.columns;
      break;
    }
  return found;
}

ChartSpec spec_of(std::vector<double> x, std::vector<double> y) {
  ChartSpec spec;
  spec.title = "a chart";
  spec.x_label = "time (s)";
  spec.y_label = "energy (J)";
  spec.series.push_back(
      {"one", std::move(x), std::move(y), std::array<double, 3>{1, 0, 0}, LineStyle::solid, false});
  return spec;
}

Picture draw(const ChartSpec& spec) {
  const ScratchDirectory directory;
  backend().chart(spec, directory / "chart.png");
  return backend().read_png(directory / "chart.png");
}

std::string refusal(const ChartSpec& spec) {
  const ScratchDirectory directory;
  const std::string message = error_of([&] { backend().chart(spec, directory / "chart.png"); });
  CHECK(std::filesystem::is_empty(directory.path()));
  return message;
}

}  // namespace

TEST_CASE("a rising curve rises from left to right across the plot", "[snapshot]") {
  const Picture picture = draw(spec_of({1, 2, 3}, {1e-5, 2e-5, 3e-5}));
  CHECK(picture.width == 1200);
  CHECK(picture.height == 900);
  const Trace red = trace(picture, 255, 0, 0);
  CHECK(red.columns > 800);
  CHECK(red.first_row > 600);
  CHECK(red.last_row < 250);
}

TEST_CASE("a power law is straight between logarithmic axes", "[snapshot]") {
  ChartSpec spec = spec_of({1e-3, 1e-1, 1e3}, {1e-6, 1e-2, 1e6});
  spec.log_x = spec.log_y = true;
  const Picture picture = draw(spec);
  const Trace red = trace(picture, 255, 0, 0);
  REQUIRE(red.columns > 800);
  ChartSpec two_ends = spec_of({1e-3, 1e3}, {1e-6, 1e6});
  two_ends.log_x = two_ends.log_y = true;
  const Picture straight = draw(two_ends);
  int different = 0;
  for (std::size_t k = 0; k < picture.rgb.size(); ++k)
    different += std::abs(picture.rgb[k] - straight.rgb[k]) > 60;
  CHECK(different < 600);
}

TEST_CASE("constant, single and huge values have a valid axis", "[snapshot]") {
  const Trace level = trace(draw(spec_of({0, 1}, {7, 7})), 255, 0, 0);
  CHECK(level.columns > 800);
  CHECK(level.first_row == level.last_row);
  CHECK(trace(draw(spec_of({0, 1}, {0, 0})), 255, 0, 0).columns > 800);
  CHECK(trace(draw(spec_of({5}, {1e-300})), 255, 0, 0).columns > 5);
  CHECK(trace(draw(spec_of({1e9, 1e9 + 1}, {-1e200, 1e200})), 255, 0, 0).columns > 800);
}

TEST_CASE("dashes and markers leave gaps, a solid line does not", "[snapshot]") {
  ChartSpec spec = spec_of({0, 1}, {0, 1});
  const int solid = trace(draw(spec), 255, 0, 0).columns;
  spec.series[0].line = LineStyle::dashed;
  const int dashed = trace(draw(spec), 255, 0, 0).columns;
  spec.series[0].line = LineStyle::none;
  const int markers = trace(draw(spec), 255, 0, 0).columns;
  CHECK(dashed < 0.8 * solid);
  CHECK(dashed > 0.5 * solid);
  CHECK(markers < 40);
  CHECK(markers > 5);
}

TEST_CASE("points without a logarithm or a value are gaps, and a note below the title counts them",
          "[snapshot]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ChartSpec spec = spec_of({0, 1, 10, 100}, {1, 1, 2, 3});
  spec.log_x = true;
  const Picture first_left_out = draw(spec);
  const auto has_ink = [](const Picture& picture, int from, int to) {
    for (int y = from; y < to; ++y)
      for (int x = 0; x < picture.width; ++x)
        if (picture.at(x, y)[0] < 128) return true;
    return false;
  };
  spec.series[0].x[0] = 1;  // where the next point is: the same line, and nothing to count
  const Picture whole = draw(spec);
  CHECK(trace(first_left_out, 255, 0, 0).columns == trace(whole, 255, 0, 0).columns);
  // The title is in the upper 50 of 900 pixels.
  CHECK(has_ink(first_left_out, 52, 75));
  CHECK_FALSE(has_ink(whole, 52, 60));
  // A gap of a third of the line: 1 to 10 remains, from 10 to 1000 there are two decades.
  const int all = trace(draw(spec_of({0, 1, 2, 3}, {1, 1, 1, 1})), 255, 0, 0).columns;
  const int gap = trace(draw(spec_of({0, 1, 2, 3}, {1, 1, nan, 1})), 255, 0, 0).columns;
  CHECK(gap > all / 4);
  CHECK(gap < all / 2);
}

TEST_CASE("where colours repeat, curves have other dashes", "[snapshot]") {
  // The pieces of curve number k, a level line; the others are red points.
  const auto pieces_of = [](int k) {
    ChartSpec spec = spec_of({}, {});
    spec.series.assign(std::size_t(k),
                       {"other", {0}, {0}, std::array<double, 3>{1, 0, 0}, LineStyle::none, false});
    spec.series.push_back({"one", {0, 1}, {1, 1}, std::nullopt, LineStyle::solid, false});
    const Picture picture = draw(spec);
    int pieces = 0;
    bool before = false;
    for (int x = picture.width / 8; x < picture.width / 2; ++x) {
      bool blue = false;
      for (int y = picture.height / 10; y < picture.height * 85 / 100; ++y) {
        const auto c = picture.at(x, y);
        blue |= c[0] < 100 && c[2] > 120;
      }
      pieces += blue && !before;
      before = blue;
    }
    return pieces;
  };
  // In 450 pixels dashes of 23, dots of 9 and pairs of 30 pixels.
  CHECK(pieces_of(0) == 1);
  CHECK(pieces_of(7) == Approx(20).margin(1));
  CHECK(pieces_of(14) == Approx(51).margin(2));
  CHECK(pieces_of(21) == Approx(30).margin(2));
}

TEST_CASE("the legend is placed where there are no curves", "[snapshot]") {
  ChartSpec spec = spec_of({0, 1}, {0, 1});
  const Picture alone = draw(spec);
  spec.series.push_back({"two", {0, 1}, {0, 0.9}, std::array<double, 3>{0, 0, 1}, LineStyle::solid, false});
  const Picture both = draw(spec);
  CHECK(trace(both, 255, 0, 0).columns >= trace(alone, 255, 0, 0).columns - 5);
}

TEST_CASE("series that cannot be drawn are refused by name", "[snapshot]") {
  CHECK_THAT(refusal(ChartSpec{}), Contains("no series"));
  CHECK_THAT(refusal(spec_of({}, {})), Contains("\"one\"") && Contains("0 x and 0 y"));
  CHECK_THAT(refusal(spec_of({1, 2}, {1})), Contains("2 x and 1 y"));
  CHECK_THAT(refusal(spec_of({std::numeric_limits<double>::infinity()}, {1})),
             Contains("no point can be drawn (it has no value); "));
  ChartSpec spec = spec_of({1, 2}, {0, -1});
  spec.log_y = true;
  CHECK_THAT(refusal(spec), Contains("no point can be drawn (they have no logarithm); use linear axes"));
}

TEST_CASE("a file that is not a picture is refused", "[snapshot]") {
  const ScratchDirectory directory;
  std::ofstream(directory / "text.png") << "not a picture";
  CHECK_THAT(error_of([&] { backend().read_png(directory / "text.png"); }), Contains("text.png"));
  CHECK_THAT(error_of([&] { backend().read_png(directory / "absent.png"); }), Contains("absent.png"));
}

TEST_CASE("a title of any length is drawn in little time", "[snapshot]") {
  ChartSpec spec = spec_of({1, 2, 3}, {1, 2, 3});
  for (const std::string& title : {std::string(50000, 'm'), [] {
                                     std::string words;
                                     for (int k = 0; k < 10000; ++k) words += "word ";
                                     return words;
                                   }()}) {
    spec.title = spec.x_label = spec.series[0].name = title;
    const std::clock_t start = std::clock();
    CHECK(trace(draw(spec), 255, 0, 0).columns > 300);
    // A chart takes 0.2 s; measuring all of the text again for each letter took minutes.
    CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 5);
  }
}
