#include "no_threads.hpp"
#include "run_support.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

TEST_CASE("two runs of a scene leave the same bytes as their final state, whenever they wrote checkpoints",
          "[run][threads]") {
  const auto final_state = [](std::optional<double> every) {
    Bench bench(two_stages);
    bench.plan.checkpoint.every_time = every;
    CHECK(bench.run().states == (every ? 5u : 2u));
    return text_of(bench.options.out / "final_state.h5");
  };
  const std::string once = final_state({});
  REQUIRE(once.size() > 1000);
  CHECK(final_state({}) == once);
  CHECK(final_state(2.5e-5) == once);
}

TEST_CASE("a final state that cannot be written fails the run after all else is saved", "[run]") {
  Bench bench(with(discs, "every = 2e-5", "every = 3e-5") +
              "[[chart]]\nname = 'c'\nprobe = 'energy'\ny = 'work'\n");
  bench.options.on_start = [&](const Simulation&) {
    std::filesystem::create_directory(bench.options.out / "final_state.h5");
  };
  CHECK_THROWS_WITH(bench.run(), Catch::Contains("final_state.h5: is there and was not written by a run"));
  const auto times = series_of(bench, "energy");
  CHECK(times.find("\n0.0001,") != std::string::npos);
  CHECK(std::filesystem::exists(bench.options.out / "charts/c.png"));
  CHECK(std::filesystem::exists(bench.options.out / "final_packing.csv"));
  CHECK(text_of(bench.options.out / "run.json").find("\"status\": \"failed\"") != std::string::npos);
}

TEST_CASE("a run writes its checkpoints where no thread can be started, and says so once", "[run]") {
  Bench bench(discs, {"checkpoint.every_time=2e-5"});
  std::vector<std::string> warnings;
  bench.options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  {
    const NoThreads none;
    bench.run();
  }
  CHECK(std::count_if(warnings.begin(), warnings.end(), [](const std::string& line) {
          return line.starts_with("no thread can be started");
        }) == 1);
  const auto final_state = state_file::read_state(bench.options.out / "final_state.h5");
  const Bench usual(discs, {"checkpoint.every_time=2e-5"});
  usual.run();
  CHECK(std::filesystem::exists(bench.options.out / "checkpoint/step_000000000000008.h5"));
  CHECK(final_state.at("bodies/position") ==
        state_file::read_state(usual.options.out / "final_state.h5").at("bodies/position"));
}
