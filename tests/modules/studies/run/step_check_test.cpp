#include "run_support.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/step_check.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

TEST_CASE("a time step too long for the contacts is refused before anything is written, unless it is forced",
          "[run]") {
  const std::string slow = with(discs, "every = 2e-5", "every = 1");
  const Bench bench(slow, {"time.step=1e-2", "time.duration=1", "particles.random_velocity=0.01"});
  try {
    bench.run();
    FAIL("the step is too long");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::bad_input);
    CHECK(std::string(error.what()).find("too long: the contacts of law 'linear_spring_dashpot' allow ") !=
          std::string::npos);
  }
  CHECK_FALSE(std::filesystem::exists(bench.options.out));
  CHECK(step_problem(*set_up(plan_of(discs))) == std::nullopt);
  CHECK_NOTHROW(set_up(plan_of(slow, {"time.step=1e-2", "time.duration=1", "time.step_guard=false"})));
}

TEST_CASE("a time step is described by the shortest contact and the longest stable step", "[run]") {
  CHECK_THAT(
      describe_step(*set_up(plan_of(discs))),
      Catch::Matches("time step 1e-05 s, [0-9.e+]+ steps in the shortest contact, 0\\.[0-9]+ of the longest "
                     "stable step"));
}
