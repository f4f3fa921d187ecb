#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

TEST_CASE("a wall time has a number and a unit", "[scenario]") {
  CHECK(parse_wall_time("30 s") == 30.0);
  CHECK(parse_wall_time("1.5min") == 90.0);
  CHECK(parse_wall_time("2 h") == 7200.0);
  CHECK(parse_wall_time("1e-1 d") == 8640.0);
  CHECK_FALSE(parse_wall_time("never"));
  for (const std::string wrong :
       {"", "10", "min", "10 m", "10 min ", "0 s", "-1 s", "inf s", "nan s", "1e308 d"}) {
    INFO(wrong);
    CHECK(message([&] {
            parse_wall_time(wrong);
          }).starts_with("'" + wrong + "' is not a wall time; give a number above 0"));
  }
}

TEST_CASE("states are written every ten minutes and at the end, unless the scene says otherwise",
          "[scenario]") {
  const CheckpointPlan usual = plan_of(discs).checkpoint;
  CHECK(usual.every == 600.0);
  CHECK_FALSE(usual.every_time);
  CHECK(usual.final_state);
  const CheckpointPlan own =
      plan_of(discs, {"checkpoint.every=never", "checkpoint.every_time=2e-5", "checkpoint.final_state=false"})
          .checkpoint;
  CHECK_FALSE(own.every);
  CHECK(own.every_time == 2e-5);
  CHECK_FALSE(own.final_state);
}

TEST_CASE("an interval between states that is no wall time or shorter than a step is refused at its key",
          "[scenario]") {
  const std::string scene = std::string(discs) + "[checkpoint]\n";  // 27
  CHECK(refusal(scene + "every = 'soon'\n").starts_with("scene.toml:28:9: 'soon' is not a wall time; "));
  CHECK(refusal(scene + "every_time = 1e-9\n").starts_with("scene.toml:28:14: "));
}

TEST_CASE("an interval of wall time without a unit is refused", "[scenario]") {
  const auto set = [](const std::string& override_text) { return refusal(discs, {override_text}); };
  const std::string cure =
      "give a number above 0 with s, min, h or d, such as \"30 s\", \"10 min\", \"2 h\" or \"never\"";
  CHECK(set("checkpoint.every=30") ==
        "--set checkpoint.every=30: checkpoint.every is not a text with a unit; " + cure +
            ", or every_time in s of simulated time");
  CHECK(set("checkpoint.every='30'") == "--set checkpoint.every='30': '30' is not a wall time; " + cure);
  CHECK_THAT(set("checkpoint.interval=30"), Catch::Contains("known keys: every, every_time, final_state"));
}
