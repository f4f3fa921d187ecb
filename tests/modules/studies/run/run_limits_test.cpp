#include "no_threads.hpp"
#include "run_support.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/run/run.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

RunResult run_in(const TemporaryFolder& folder, const Plan& plan) {
  RunOptions options;
  options.out = folder / "out";
  return run_plan(plan, options);
}

}  // namespace

TEST_CASE("the scenario of a run that started from a packing can be run again from its folder", "[run]") {
  const TemporaryFolder folder;
  folder.write("bodies.csv", "x,y,radius\n0,0,0.01\n1,0,0.01\n");
  const std::string text = with(discs,
                                "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                                "random_velocity = 0.1\n",
                                "file = 'bodies.csv'\n");
  const Plan plan = read_plan(folder.write("scene.toml", text), {}, host());
  RunOptions options;
  options.out = folder / "out";
  const RunResult first = run_plan(plan, options);
  const Plan same = read_plan(options.out / "scenario.toml", {}, host());
  options.out = folder / "again";
  CHECK(run_plan(same, options).state_hash == first.state_hash);
}

TEST_CASE("a run whose bodies have left the range of numbers fails instead of ending without a packing",
          "[run]") {
  const TemporaryFolder folder;
  const Plan plan = plan_of(with(discs, "step = 1e-5", "step = 1e200\nstep_guard = false"),
                            {"time.duration=1e201", "limits.speed=1e300", "boundary=[]", "probe=[]"});
  CHECK_THROWS_WITH(
      run_in(folder, plan),
      Catch::Contains("is beyond the range of numbers, so that final_packing.csv is not written"));
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
