#include <catch2/catch.hpp>

#include <scree/counted.hpp>

using scree::counted;

TEST_CASE("a noun is in the singular after 1 alone") {
  CHECK(counted(0, "wall") == "0 walls");
  CHECK(counted(1, "wall") == "1 wall");
  CHECK(counted(2, "wall") == "2 walls");
  CHECK(counted(21, "body", "bodies") == "21 bodies");
  CHECK(counted(1, "body", "bodies") == "1 body");
  CHECK(counted(1, "mode is", "modes are") == "1 mode is");
}
