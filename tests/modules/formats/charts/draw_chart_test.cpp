#include "drawn_chart.hpp"

#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

using namespace scree::charts;
using Catch::Contains;
using scree::test::TemporaryFolder;

namespace {

std::string refusal(const ChartSpec& spec, const std::string& name = "chart.png") {
  const TemporaryFolder folder;
  std::string message;
  try {
    draw_chart(spec, folder / name);
  } catch (const scree::Error& error) {
    message = error.what();
  }
  CHECK(std::filesystem::is_empty(folder.path()));
  return message;
}

}  // namespace

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

TEST_CASE("constant, single and huge values have a valid axis", "[charts]") {
  const Trace level = trace(drawn(spec_of({0, 1}, {7, 7})), red);
  CHECK(level.columns > 800);
  CHECK(level.first_row == level.last_row);
  CHECK(trace(drawn(spec_of({0, 1}, {0, 0})), red).columns > 800);
  CHECK(trace(drawn(spec_of({5}, {1e-300})), red).columns > 5);
  CHECK(trace(drawn(spec_of({1e9, 1e9 + 1}, {-1e200, 1e200})), red).columns > 800);
}

TEST_CASE("the formats are what their programs take, with the title as text", "[charts]") {
  ChartSpec spec = spec_of({0, 1}, {0, 1});
  spec.title = "load & strain <axial>";
  spec.series.push_back({"a second curve", {0, 1}, {1, 2}});
  CHECK(file_of(spec, "png").starts_with("\x89PNG\r\n"));
  const std::string svg = file_of(spec, "svg");
  CHECK(svg.starts_with("<?xml"));
  CHECK_THAT(svg, Contains("<title>load &amp; strain &lt;axial&gt;</title>") &&
                      Contains("<desc>energy (J) over time (s); one; a second curve</desc>") &&
                      Contains("width=\"480pt\" height=\"360pt\"") && Contains("</svg>"));
  const std::string pdf = file_of(spec, "pdf");
  CHECK(pdf.starts_with("%PDF-1."));
  CHECK_THAT(pdf, Contains("/Title") && Contains("DejaVuSans") && Contains("%%EOF"));
  CHECK_THAT(refusal(spec, "chart.jpg"),
             Contains("chart.jpg: is no name of a chart; give one that ends in .png, .svg, .pdf"));
  CHECK_THAT(refusal(spec, "chart"), Contains("is no name of a chart"));
}

TEST_CASE("a chart has the same bytes whenever it is drawn", "[charts]") {
  const ChartSpec spec = spec_of({0, 1, 2}, {0, 1, 0});
  for (const char* format : {"png", "svg", "pdf"}) {
    const std::string first = file_of(spec, format);
    if (format == std::string("pdf"))
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // its dates have seconds
    CHECK((file_of(spec, format) == first));
  }
}

TEST_CASE("the folder of a chart is made, but none above", "[charts]") {
  const TemporaryFolder folder;
  draw_chart(spec_of({0, 1}, {0, 1}), folder / "charts/a.png");
  CHECK(std::filesystem::exists(folder / "charts/a.png"));
  CHECK_THROWS_WITH(draw_chart(spec_of({0, 1}, {0, 1}), folder / "removed/charts/a.png"),
                    Contains("removed/charts/a.png: cannot be opened for writing; "));
  CHECK_FALSE(std::filesystem::exists(folder / "removed"));
}

TEST_CASE("series that cannot be drawn are refused by name", "[charts]") {
  CHECK_THAT(refusal(ChartSpec{}), Contains("no series"));
  CHECK_THAT(refusal(spec_of({}, {})), Contains("\"one\"") && Contains("0 x and 0 y"));
  CHECK_THAT(refusal(spec_of({1, 2}, {1})), Contains("2 x and 1 y"));
  CHECK_THAT(refusal(spec_of({INFINITY}, {1})), Contains("no point can be drawn (it has no value); "));
  ChartSpec spec = spec_of({1, 2}, {0, -1});
  spec.log_y = true;
  CHECK_THAT(refusal(spec), Contains("no point can be drawn (they have no logarithm); use linear axes"));
}
