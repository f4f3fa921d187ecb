#include "static/static_packing.hpp"

#include "column.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::response;
using test::column;
using test::column_discs;
using test::disc_stiffness;

// Four springs in line. 1e-10: the stress of the overlaps, and round-off.
TEST_CASE("a displaced wall shares its displacement among the springs of a column", "[response]") {
  const Simulation simulation(column(-1));
  const StaticPacking packing(simulation, {.fewest_contacts = 1}, [] { return true; });
  Eigen::VectorXd walls = Eigen::VectorXd::Zero(4);
  walls[3] = -1;  // the upper wall, downwards
  const PackingMotion motion = packing.displace(walls);
  CHECK(motion.residual < 1e-10);
  for (std::uint32_t i = 0; i < column_discs; ++i) {
    CHECK(packing.is_held(i));
    CHECK(packing.component(motion, i, 0) == Approx(0).margin(1e-10));
    CHECK(packing.component(motion, i, 1) == Approx(-(double(i) + 1) / (column_discs + 1)).epsilon(1e-10));
  }
  CHECK(packing.component(motion, column_discs, 1) == 0);
  CHECK(packing.component(motion, column_discs + 1, 1) == -1);
  REQUIRE(packing.contacts().size() == column_discs + 1);
  for (const ContactTerms& contact : packing.contacts())
    CHECK(packing.force_change(motion, contact).norm() ==
          Approx(disc_stiffness / (column_discs + 1)).epsilon(1e-10));
}
