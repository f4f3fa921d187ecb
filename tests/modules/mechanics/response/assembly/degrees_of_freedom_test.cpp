#include <catch2/catch.hpp>

#include <scree/response/degrees_of_freedom.hpp>

using scree::response::DegreesOfFreedom;

TEST_CASE("motions are numbered body by body, then the walls that forces move", "[response]") {
  constexpr auto none = DegreesOfFreedom::none;
  const DegreesOfFreedom freedom(3, 3, {true, false, true}, {false, true, true}, {false, true, true});
  CHECK(freedom.bodies() == 3);
  CHECK(freedom.walls() == 3);
  CHECK(freedom.size() == 3 + 0 + 6 + 2);
  for (int k = 0; k < 3; ++k) {
    CHECK(freedom.translation(0, k) == k);
    CHECK(freedom.rotation(0, k) == none);
    // Without translations it has no rotations.
    CHECK(freedom.translation(1, k) == none);
    CHECK(freedom.rotation(1, k) == none);
    CHECK(freedom.translation(2, k) == 3 + k);
    CHECK(freedom.rotation(2, k) == 6 + k);
  }
  CHECK(freedom.wall(0) == none);
  CHECK(freedom.wall(1) == 9);
  CHECK(freedom.wall(2) == 10);
}

TEST_CASE("bodies without spins have no rotations, and in two dimensions one", "[response]") {
  const DegreesOfFreedom smooth(2, 0, {true, true}, {true, true}), rough(2, 1, {true, true}, {true, true});
  CHECK(smooth.size() == 4);
  CHECK(smooth.rotation(1, 0) == DegreesOfFreedom::none);
  CHECK(rough.size() == 6);
  CHECK(rough.rotation(0, 0) == 2);
  CHECK(rough.translation(1, 0) == 3);
}
