#include "program.hpp"

#include <algorithm>

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

TEST_CASE("a film has the pictures of a run before and after it went on", "[tools]") {
  const Workspace w(pictured);
  const std::string film = " --set snapshot.film=true --set snapshot.film_rate_hz=5 --set snapshot.width=201";
  const Outcome without =
      w.shell("PATH=/nowhere\nscree run scene.toml --out out --quiet --set time.duration=5e-5" + film);
  CHECK(without.status == 0);
  CHECK(contains(without.err,
                 "scree: warning: film.mp4 was not made: the program ffmpeg is not on the PATH; "
                 "apt install ffmpeg, then ffmpeg -framerate 5 "));
  CHECK(std::count(without.err.begin(), without.err.end(), '\n') == 1);
  CHECK_FALSE(w.has("out/film.mp4"));
  if (w.shell("command -v ffmpeg && command -v ffprobe").status != 0) return;  // the packages of tests
  const Outcome resumed = w.scree("resume out --until 1e-4 --quiet");
  CHECK(resumed.err.empty());
  // Of an even width, as players need it; 3 pictures: at the start and after 5 and 10 steps.
  CHECK(
      w.shell("ffprobe -v error -count_frames -show_entries stream=width,height,r_frame_rate,nb_read_frames "
              "-of csv=p=0 out/film.mp4")
          .out == "202,200,5/1,3\n");
  CHECK(contains(w.text("out/written.txt"), "film.mp4\n"));
}

#endif
