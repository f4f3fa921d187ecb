#include "bodies_drawing.hpp"

#include "report_support.hpp"

using namespace scree::report;
using scree::test::TemporaryFolder;

namespace {

std::string drawing_of(const std::string& table) {
  const TemporaryFolder folder;
  return bodies_drawing(folder.write("p.csv", table));
}

std::size_t circles_in(const std::string& svg) {
  std::size_t count = 0;
  for (std::size_t at = svg.find("<circle"); at != svg.npos; at = svg.find("<circle", at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("discs are drawn to scale", "[report]") {
  // 4 m wide and 2 m high: 270 of the 1080 units between the margins for each metre.
  const std::string svg =
      drawing_of("id,material,x [m],y [m],radius [m]\n1,a,0,0,1\n2,b,2,0,1\n3,a,nan,0,1\n");
  CHECK(circles_in(svg) == 2);
  CHECK_THAT(svg, Catch::Contains("cx=\"330.0\" cy=\"450.0\" r=\"270.0\"") &&
                      Catch::Contains("cx=\"870.0\"") && Catch::Contains(">0.5\u00A0m</text>"));
  CHECK(scree::test::misplaced_tag(svg).empty());
}

TEST_CASE("spheres in front cover those behind, which are paler", "[report]") {
  const std::string svg =
      drawing_of("id,material,x [m],y [m],z [m],radius [m]\n1,a,0,0,0,1\n2,a,0.5,1,0,1\n");
  const std::size_t pale = svg.find("#b5c9dc"), full = svg.find("#4878a8");
  CHECK(pale < full);
  CHECK(full != svg.npos);
  // A row along y is seen from the side.
  const std::string row = drawing_of("id,material,x [m],y [m],z [m],radius [m]\n1,a,0,0,0,1\n2,a,0,2,0,1\n");
  CHECK_THAT(row, Catch::Contains("cx=\"330.0\"") && Catch::Contains("cx=\"870.0\""));
}

TEST_CASE("without bodies, or with too many, there is no drawing", "[report]") {
  CHECK(bodies_drawing("none.csv").empty());
  CHECK(drawing_of("id,material,x [m],y [m],radius [m]\n").empty());
  CHECK(drawing_of("other\nword\n").empty());
  std::string many = "id,material,x [m],y [m],radius [m]\n";
  for (int k = 0; k < 2001; ++k) many += std::to_string(k) + ",a," + std::to_string(k) + ",0,1\n";
  CHECK(drawing_of(many).empty());
}
