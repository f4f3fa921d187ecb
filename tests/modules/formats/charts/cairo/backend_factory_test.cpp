#include "drawn_chart.hpp"

#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

using namespace scree::charts;
using Catch::Contains;

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
