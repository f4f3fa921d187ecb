#include "run_support.hpp"

#include <atomic>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;

TEST_CASE("progress to a condition is told by its quantity and goal, not by a share", "[run]") {
  Bench bench(with(discs, "duration = 1e-4\n", "") +
              "[[stage]]\nname = 'rest'\nuntil = { kinetic_over_elastic = 1e-30, at_most = 1000 }\n"
              "[[stage]]\nname = 'after'\nduration = 1\n");
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](const Progress& p) {
    CHECK_FALSE(p.share.has_value());
    CHECK(p.stage_number == 1);
    CHECK(p.stages == 2);
    CHECK(p.kinetic_over_elastic.has_value());
    CHECK(p.goal == 1e-30);
    stop = true;
  };
  CHECK(bench.run().interrupted);
}

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
  CHECK(result.output < result.wall);
  CHECK(result.particle_steps_per_second == Approx(90 / (result.wall - result.output)));
}
