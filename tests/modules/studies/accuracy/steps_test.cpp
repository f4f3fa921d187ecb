#include "steps.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::accuracy;

namespace {

scenario::Plan plan_with_durations(const std::vector<double>& durations) {
  scenario::Plan plan;
  for (const double duration : durations) {
    Stage stage;
    stage.duration = duration;
    plan.stages.push_back(stage);
  }
  return plan;
}

}  // namespace

TEST_CASE("steps are adjusted to divide the durations of all stages", "[accuracy]") {
  CHECK(fitting_step(plan_with_durations({1}), 0.3) == Approx(0.25));
  CHECK(fitting_step(plan_with_durations({1}), 0.25) == 0.25);
  CHECK(fitting_step(plan_with_durations({0.5, 2}), 0.3) == Approx(0.25));
  CHECK(fitting_step(plan_with_durations({1, 1.1}), 0.3) == 0.3);  // no common divisor nearby
  CHECK(fitting_step(plan_with_durations({}), 0.3) == 0.3);
  CHECK(fitting_step(plan_with_durations({1}), 3) == 1);
}
