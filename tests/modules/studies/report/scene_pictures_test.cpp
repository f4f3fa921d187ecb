#include "scene_pictures.hpp"

#include "report_support.hpp"

using namespace scree::report;
using scree::test::write;

namespace {

const std::string png = "\x89PNG\r\n\x1a\n";

std::string pictures_of(const scree::test::TemporaryFolder& folder) {
  return scene_pictures({folder.path(), {{"step", 1e-3}}, "run", "run"});
}

}  // namespace

TEST_CASE("the first and the last picture of a run are on its page", "[report]") {
  const scree::test::TemporaryFolder folder;
  CHECK(pictures_of(folder).empty());
  folder.write("final_packing.csv", "id,material,x [m],y [m],radius [m]\n1,a,0,0,1\n");
  CHECK_THAT(pictures_of(folder),
             Catch::Contains("<circle") && Catch::Contains("<figcaption>The bodies at the end</figcaption>"));
  for (const char* name : {"frame_0000000000", "frame_0000000500", "frame_0000012000"})
    write(folder, std::string("images/") + name + ".png", png + name);
  const std::string html = pictures_of(folder);
  CHECK_THAT(html, Catch::Contains("At the start") &&
                       Catch::Contains("After 12\u202F000 steps, t = 12\u00A0s") &&
                       !Catch::Contains("After 500"));
}

TEST_CASE("where there is room for one picture only it is the last", "[report]") {
  const scree::test::TemporaryFolder folder;
  write(folder, "images/frame_0000000000.png", png + std::string(900'000, 'a'));
  write(folder, "images/own.png", png + std::string(900'000, 'b'));
  CHECK_THAT(pictures_of(folder),
             Catch::Contains("<figcaption>own</figcaption>") && !Catch::Contains("At the start"));
}
