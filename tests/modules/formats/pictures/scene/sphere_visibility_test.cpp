#include "drawn_pair.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("the nearer sphere hides the farther one", "[snapshot]") {
  const Picture picture = draw(pair({0.5, 0.5, 0.8}, {0.5, 0.5, 0.2}, 3), by_speed("z"));
  CHECK(find_blob(picture, is_violet).pixels > 1000);
  CHECK(find_blob(picture, is_yellow).pixels == 0);
}
