#include "temporary_folder.hpp"

#include <limits>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/run/recorded_load.hpp>

using namespace scree::run;
using scree::test::TemporaryFolder;

TEST_CASE("the load of a run is cycled in the last stage with a period", "[run]") {
  const TemporaryFolder run;
  run.write("scenario.toml",
            "[[stage]]\nperiod = 7\n[[stage]]\ncycles = 60\nperiod = 2\n[[stage]]\nduration = 1\n");
  run.write("run.json",
            R"({"stages": [{"start": 0, "end": 1}, {"start": 1, "end": 121}, {"start": 121, "end": 122}]})");
  const auto load = recorded_load(run.path());
  REQUIRE(load);
  CHECK(load->period == 2);
  CHECK(load->start == 1);
  CHECK(load->end == 121);
  CHECK(load->status.empty());
}

TEST_CASE("a stage that has not ended has no end yet, and one that has not begun is refused", "[run]") {
  const TemporaryFolder run;
  run.write("scenario.toml", "[[stage]]\nduration = 1\n[[stage]]\nperiod = 2\n");
  run.write("run.json",
            R"({"status": "running", "stages": [{"start": 0, "end": 1}, {"start": 1, "end": 3}]})");
  const auto load = recorded_load(run.path());
  REQUIRE(load);
  CHECK(load->end == std::numeric_limits<double>::max());
  CHECK(load->status == "running");
  CHECK(unfinished_status(run.path()) == "running");
  run.write("run.json", R"({"status": "running", "stages": [{"start": 0, "end": 1}]})");
  CHECK_THROWS_WITH(recorded_load(run.path()),
                    Catch::Contains("stage 2, which has the period, has not run; "));
}

TEST_CASE("a run without a period has no recorded load, a quasi-static one has it in its record", "[run]") {
  const TemporaryFolder run;
  run.write("scenario.toml", "[[stage]]\nduration = 1\n");
  run.write("run.json", R"({"status": "finished", "stages": [{"start": 0, "end": 1}]})");
  CHECK_FALSE(recorded_load(run.path()));
  CHECK(unfinished_status(run.path()).empty());
  run.write("quasi_static.json", R"({"status": "failed", "period": 0, "start": 1, "end": 5})");
  const auto load = recorded_load(run.path());
  REQUIRE(load);
  CHECK(load->period == 0);
  CHECK(load->end == 5);
  CHECK(load->status == "failed");
}
