#include "drawn_pair.hpp"

#include <catch2/catch.hpp>

using namespace scree::pictures;

TEST_CASE("discs appear with their colours and positions", "[snapshot]") {
  check_pair(draw(pair({0.2, 0.3, 0}, {0.7, 0.7, 0}, 2), by_speed("")), 0.5, 0.4);
}
