#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <scree/cycles/rattlers.hpp>

using scree::cycles::Rattlers;
using scree::cycles::read_rattlers;

TEST_CASE("rattlers touch in fewer than half of the observations after the dropped cycles", "[rattlers]") {
  const scree::test::TemporaryFolder folder;
  // Body 12 touches in 4 of the 10 observations after the first cycle, body 3 in 5, body 4 in 1.
  const auto file =
      folder.write("touching.csv",
                   "time,observations,touched_12,last_touch_12,touched_3,last_touch_3,touched_4,"
                   "last_touch_4\n"
                   "0,0,0,0,0,0,0,0\n"
                   "2,10,10,2,10,2,10,1.75\n"
                   "3,12,11,3,11,3,10,1.75\n"
                   "4,20,14,3.5,15,4,11,3.75\n");
  const Rattlers found = read_rattlers(file, {0, 2, 4}, 1);
  REQUIRE(found.bodies.size() == 2);
  CHECK(found.bodies[0].id == 4);
  CHECK(found.bodies[0].share == Approx(0.1));
  CHECK(found.bodies[1].id == 12);
  CHECK(found.bodies[1].share == Approx(0.4));
  REQUIRE(found.touches.size() == 3);
  CHECK(found.touches[1].body == 12);
  CHECK(found.touches[1].before == 0);
  CHECK(found.touches[2].body == 4);
  CHECK(found.touches[2].before == 0.25);
  CHECK_THROWS_WITH(read_rattlers(file, {0, 2, 5}, 1), Catch::Contains("there is no row at 5 s"));
}
