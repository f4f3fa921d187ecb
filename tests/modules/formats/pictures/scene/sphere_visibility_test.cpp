#include "drawn_pair.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("the nearer sphere hides the farther one", "[snapshot]") {
  const Picture picture = draw(pair({0.5, 0.5, 0.8}, {0.5, 0.5, 0.2}, 3), by_speed("z"));
  CHECK(find_blob(picture, is_violet).pixels > 1000);
  CHECK(find_blob(picture, is_yellow).pixels == 0);
}

// Below the cut the nearer sphere has 0.75 of its area, as its centre is half a radius above.
TEST_CASE("what a cut takes away hides nothing", "[snapshot]") {
  RenderOptions options = by_speed("z");
  options.cut[2] = {0, 0.75};
  const Picture picture = draw(pair({0.5, 0.5, 0.8}, {0.5, 0.5, 0.2}, 3), options);
  CHECK(find_blob(picture, is_violet).pixels > 1000);
  CHECK(find_blob(picture, is_yellow).pixels > 500);
}
