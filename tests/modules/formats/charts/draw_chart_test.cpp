#include "drawn_chart.hpp"

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

TEST_CASE("the bytes of a chart are those of its file", "[charts]") {
  const ChartSpec spec = spec_of({0, 1}, {0, 1});
  for (const char* format : {"svg", "png"}) CHECK(chart_bytes(spec, format) == file_of(spec, format));
}

TEST_CASE("a name without a known format is refused", "[charts]") {
  const ChartSpec spec = spec_of({0, 1}, {0, 1});
  CHECK_THAT(refusal(spec, "chart.jpg"),
             Contains("chart.jpg: is no name of a chart; give one that ends in .png, .svg, .pdf"));
  CHECK_THAT(refusal(spec, "chart"), Contains("is no name of a chart"));
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
