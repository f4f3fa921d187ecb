#include "drawn_pair.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("spheres appear with their colours and positions in every view", "[snapshot]") {
  const Frame frame = pair({0.2, 0.3, 0.4}, {0.7, 0.7, 0.6}, 3);
  check_pair(draw(frame, by_speed("x")), 0.4, 0.2);
  check_pair(draw(frame, by_speed("y")), 0.5, 0.2);
  check_pair(draw(frame, by_speed("z")), 0.5, 0.4);
}
