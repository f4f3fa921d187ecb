#include "horizon.hpp"

#include "plan_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/accuracy/report.hpp>
#include <scree/accuracy/study.hpp>

using namespace scree;
using namespace scree::accuracy;
using test::plan_of;

TEST_CASE("a chaotic scene is compared at the time until which its reference is trustworthy", "[accuracy]") {
  // Nine hard discs in a box, with many collisions each: a deviation grows severalfold per collision.
  const std::string chaos = test::with(test::discs, "duration = 1e-4", "duration = 10");
  StudyOptions options;
  options.coarsest = 20;
  options.count = 2;
  options.integrations = {Integration::velocity_verlet};
  const Convergence result = study(plan_of(test::with(chaos, "every = 2e-5", "every = 0.1")), options);
  REQUIRE(result.horizon.has_value());
  CHECK(*result.horizon < 10);
  CHECK(result.duration == Approx(*result.horizon));
  CHECK(text_report(result).find("trustworthy until t = ") != std::string::npos);
}

TEST_CASE("the longest duration is that of all stages, with the limit of those that end by a condition",
          "[accuracy]") {
  scenario::Plan plan;
  plan.stages.resize(3);
  plan.stages[0].duration = 1;
  plan.stages[1].until.at_most = 2;
  plan.stages[2].duration = 0.5;
  CHECK(longest_duration(plan) == 3.5);
}

TEST_CASE("the distance of positions is the root mean square of those of the bodies", "[accuracy]") {
  CHECK(distance_between({Vec3{{0, 0, 0}}, Vec3{{1, 1, 1}}}, {Vec3{{3, 0, 4}}, Vec3{{1, 1, 1}}}) ==
        Approx(5 / std::sqrt(2.0)));
  CHECK(distance_between({}, {}) == 0);
}
