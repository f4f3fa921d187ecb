#include "run_support.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

TEST_CASE("run.json tells each stage, and the series number them", "[run]") {
  const std::string stages =
      "[[stage]]\nname = 'a'\nduration = 4e-5\n"
      "[[stage]]\nname = 'b'\nuntil = { kinetic_over_elastic = 1e30, at_most = 1 }\n"
      "[[stage]]\nname = 'c'\nduration = 2e-5\n";
  const Bench bench(with(discs, "duration = 1e-4\n", "") + stages);
  const std::vector<StageResult> told = bench.run().stages;
  REQUIRE(told.size() == 3);
  CHECK(told[0].steps == 4);
  CHECK(told[0].ended == "duration");
  CHECK(told[1].name == "b");
  CHECK(told[1].start == told[0].end);
  CHECK(told[1].steps % 100 == 0);  // a condition is tested every 100 steps
  CHECK(told[1].ended == "condition");
  CHECK(told[2].start == told[1].end);
  CHECK(told[2].end == Approx(told[2].start + 2e-5));
  const std::string series = text_of(bench.options.out / "series/energy.csv");
  CHECK(series.substr(0, series.find('\n')).ends_with(",residual [J],stage"));
  CHECK(series.ends_with(",3\n"));
  CHECK(text_of(bench.options.out / "run.json").find("\"ended\": \"condition\"") != std::string::npos);
  const Bench single;
  single.run();
  CHECK(text_of(single.options.out / "series/energy.csv").find("stage") == std::string::npos);
}

TEST_CASE("the time for pictures and series is not counted as stepping", "[run]") {
  const Bench bench(discs, {"probe.every=1e-5"});
  const RunResult result = bench.run();
  CHECK(result.output > 0);
  CHECK(result.output < result.wall_time);
  CHECK(result.particle_steps_per_second == Approx(90 / (result.wall_time - result.output)));
}

TEST_CASE("a run that goes on counts its wall time and its states on", "[run]") {
  const Bench bench(two_stages, {"checkpoint.every_time=3e-5"});
  bench.run();
  const auto record = [&] { return nlohmann::json::parse(text_of(bench.options.out / "run.json")); };
  // As if it had taken long.
  auto before = record();
  const std::uint64_t states = before["states"];
  before["wall_s"] = 100, before["output_s"] = 60, before["states_s"] = 30;
  bench.folder.write("out/run.json", before.dump());
  const RunResult prolonged = resume(bench, {}, 2e-4);
  for (const auto& [now, then] : {std::pair(prolonged.wall_time, 100), std::pair(prolonged.output, 60),
                                  std::pair(prolonged.state_output, 30)}) {
    CHECK(now >= then);
    CHECK(now < then + 10);  // ten steps
  }
  CHECK(prolonged.states > states);
  CHECK(record()["states"] == prolonged.states);
}

TEST_CASE("a run whose bodies have left the range of numbers fails instead of ending without a packing",
          "[run]") {
  const Bench bench(with(discs, "step = 1e-5", "step = 1e200\nstep_guard = false"),
                    {"time.duration=1e201", "limits.speed=1e300", "boundary=[]", "probe=[]"});
  CHECK_THROWS_WITH(
      bench.run(),
      Catch::Contains("is beyond the range of numbers, so that final_packing.csv is not written"));
}
