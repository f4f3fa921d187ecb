#include "drawn_pair.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;
using Catch::Contains;

TEST_CASE("arrows begin at the centres, in the colours of their lengths", "[snapshot]") {
  const Frame frame = pair({0.2, 0.5, 0}, {0.6, 0.5, 0}, 2);
  const ScratchDirectory directory;
  // The first points up, and is too short to be seen; the second points right.
  const ArrowField arrows = {
      .vectors = {0, 1e-3, 0, 5, 0, 0}, .longest = 0.3, .title = "share", .note = "arrows"};
  backend().render_arrows(frame, arrows, {}, directory / "arrows.png");
  const Picture picture = backend().read_png(directory / "arrows.png");
  const Blob yellow = find_blob(picture, is_yellow), violet = find_blob(picture, is_violet);
  CHECK(violet.pixels == 0);
  REQUIRE(yellow.pixels > 300);
  // Its middle is right of the centre of its body, which is right of the middle of the scene.
  const Blob bodies =
      find_blob(picture, [](const Rgb& c) { return c[0] > 190 && c[0] < 220 && c[0] == c[2]; });
  REQUIRE(bodies.pixels > 300);
  CHECK(yellow.x > bodies.x + 50);
  const ArrowField one = {.vectors = {1, 0, 0}, .longest = 1, .title = "", .note = ""};
  CHECK_THROWS_WITH(backend().render_arrows(frame, one, {}, directory / "x.png"),
                    Contains("give one for each"));
}
