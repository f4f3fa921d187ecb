#include "program.hpp"

#if SCREE_TEST_PICTURES

using namespace scree::test;

namespace {

// Nine discs, of which three fall out of the middle.
const std::string pictured = std::string(discs) +
                             "[[group]]\nname = 'middle'\nwhere = { y = [0.03, 0.04] }\nvelocity = [0, 0.5]\n"
                             "[snapshot]\nevery = 5e-5\nimage_every = 5e-5\nwidth = 200\nheight = 200\n";

}  // namespace

TEST_CASE("a run that goes on has the same displacements, groups and pictures", "[tools]") {
  const Workspace w(pictured);
  const auto text = [&](const std::string& field, const std::string& run) {
    const std::string out = field + run + "/", step = "0000000010";
    return w.text(out + "images/frame_" + step + ".png") +
           w.text(out + "snapshots/particles_" + step + ".vtp");
  };
  for (const std::string field : {"displacement", "group"}) {
    const std::string rest = " --quiet --set snapshot.color_by=" + field;
    REQUIRE(w.scree("run scene.toml --out " + field + "_whole" + rest).status == 0);
    REQUIRE(w.scree("run scene.toml --out " + field + "_parts" + rest + " --set time.duration=7e-5").status ==
            0);
    REQUIRE(w.scree("resume " + field + "_parts --until 1e-4 --quiet").status == 0);
    CHECK(text(field, "_parts") == text(field, "_whole"));
  }
  CHECK(text("group", "_whole") != text("displacement", "_whole"));
  const std::string again = "render group_whole --width 200 --height 200 --out again --color-by ";
  CHECK(w.scree(again + "group").status == 0);
  CHECK(w.text("again/frame_0000000010.png") == w.text("group_whole/images/frame_0000000010.png"));
  CHECK(contains(w.scree(again + "displacement --overwrite").err, "these snapshots have no displacement; "));
}

#endif
