#include "run_support.hpp"

#include <algorithm>
#include <fstream>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

namespace {

const std::string stages = with(discs, "duration = 1e-4\n", "") +
                           "[[stage]]\nname = 'first'\nduration = 5e-5\n"
                           "[[stage]]\nname = 'second'\nduration = 5e-5\n";

RunResult resume(const Bench& bench, const std::vector<std::string>& overrides,
                 std::optional<double> until = {}) {
  return resume_run(bench.options, {overrides, until, {}}, host());
}

std::uint64_t steps_of(const RunResult& result) {
  return result.stages.back().first_step + result.stages.back().steps;
}

std::string refused(const Bench& bench, const std::vector<std::string>& overrides,
                    std::optional<double> until = {}) {
  return message([&] { resume(bench, overrides, until); });
}

std::string series_of(const Bench& bench, const std::string& probe) {
  return text_of(bench.options.out / "series" / (probe + ".csv"));
}

}  // namespace

TEST_CASE("a run that cannot go on leaves its series as they are", "[run]") {
  // The last row is behind the state at the end, so that going on would drop it.
  const Bench bench(with(discs, "every = 2e-5", "every = 3e-5") +
                    "[[probe]]\nname = 'walls'\nplugin = 'box'\nevery = 3e-5\n");
  bench.run();
  const std::string energy = series_of(bench, "energy");
  SECTION("a series was removed") {
    std::filesystem::remove(bench.options.out / "series/walls.csv");
    CHECK(refused(bench, {}, 2e-4).find("walls.csv: cannot be opened") != std::string::npos);
  }
  SECTION("a series was shortened") {
    std::filesystem::resize_file(bench.options.out / "series/walls.csv", 20);
    CHECK(refused(bench, {}, 2e-4).find("walls.csv: is shorter") != std::string::npos);
  }
  SECTION("the list of files was shortened") {
    std::filesystem::resize_file(bench.options.out / "written.txt", 40);
    CHECK(refused(bench, {}, 2e-4).find("written.txt: has no line that ends") != std::string::npos);
  }
  CHECK(series_of(bench, "energy") == energy);
}

TEST_CASE("a prolonged run ends where --until says, and its scenario says so too", "[run]") {
  SECTION("the last of several stages") {
    const Bench bench(stages);
    bench.run();
    CHECK(steps_of(resume(bench, {}, 2e-4)) == 20);
    const Bench whole(stages, {"stage.second.duration=1.5e-4"});
    whole.run();
    CHECK(series_of(bench, "energy") == series_of(whole, "energy"));
    // (2e-4 - 5e-5) s has an error of round-off.
    CHECK(plan_of(text_of(bench.options.out / "scenario.toml")).stages[1].duration.value() ==
          Approx(1.5e-4).epsilon(1e-14));
  }
  SECTION("a stage of cycles") {
    const Bench bench(
        with(stages, "name = 'second'\nduration = 5e-5", "name = 'second'\ncycles = 1\nperiod = 5e-5"));
    bench.run();
    CHECK(steps_of(resume(bench, {}, 2e-4)) == 20);
  }
  SECTION("a single stage with a name") {
    const Bench bench(with(discs, "duration = 1e-4\n", "") + "[[stage]]\nname = 'only'\nduration = 1e-4\n");
    bench.run();
    CHECK(steps_of(resume(bench, {}, 2e-4)) == 20);
  }
  SECTION("a last stage that begins when a condition is met") {
    // Discs that do not touch have no elastic energy; pressed by gravity they do.
    const Bench bench(with(stages, "name = 'first'\nduration = 5e-5",
                           "name = 'first'\nuntil = { kinetic_over_elastic = 1e12, at_most = 1 }") +
                      "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -1e4]\n");
    const RunResult first = bench.run();
    const double began = first.stages[1].start;
    CHECK(resume(bench, {}, began + 8e-5).stages[1].steps == 8);
  }
}

TEST_CASE("only lengths of stages that are not over can be set when a run goes on", "[run]") {
  const Bench bench(stages);
  bench.run();
  const auto contains = [&](const std::string& override_text, const char* part) {
    INFO(override_text);
    const std::string line = refused(bench, {override_text}, 2e-4);
    INFO(line);
    CHECK(line.find(part) != std::string::npos);
  };
  contains("stage.first.duration=1e-4", "stage 'first' is over");
  contains("stage.second.at_most=1", "unknown key 'at_most'");
  contains("probe.energy.duration=1", "can change only how long");
  CHECK(refused(bench, {}, 1e-4).find("finished at t = 0.0001 s; give a later --until") != std::string::npos);
}

TEST_CASE("a run that was killed behind its last state is completed", "[run]") {
  const Bench bench(stages);
  const RunResult first = bench.run();
  const std::filesystem::path out = bench.options.out;
  const std::string energy = series_of(bench, "energy"), packing = text_of(out / "final_packing.csv");
  std::string record = text_of(out / "run.json");
  record.replace(record.find("finished"), 8, "running");
  bench.folder.write("out/run.json", record);
  std::filesystem::remove(out / "final_packing.csv");
  const RunResult completed = resume(bench, {});
  CHECK(completed.state_hash == first.state_hash);
  CHECK(completed.verdicts.size() == first.verdicts.size());
  CHECK(series_of(bench, "energy") == energy);
  CHECK(text_of(out / "final_packing.csv") == packing);
  CHECK(text_of(out / "run.json").find("\"status\": \"finished\"") != std::string::npos);
  CHECK(refused(bench, {}).find("the run has finished") != std::string::npos);
}

TEST_CASE("a prolonged run that is killed at once is still prolonged", "[run]") {
  const Bench bench(stages);
  bench.run();
  RunOptions killed = bench.options;
  killed.on_start = [](const Simulation&) { throw std::runtime_error("killed"); };
  CHECK_THROWS(resume_run(killed, {{}, 2e-4, {}}, host()));
  const RunResult completed = resume(bench, {});
  CHECK(completed.stages.back().end == Approx(2e-4));
}

TEST_CASE("a damaged checkpoint is passed over for the one before", "[run]") {
  const Bench bench(stages, {"checkpoint.every_time=2e-5", "checkpoint.final_state=false"});
  const RunResult whole = bench.run();
  const std::string energy = series_of(bench, "energy");
  std::vector<std::filesystem::path> states;
  for (const auto& entry : std::filesystem::directory_iterator(bench.options.out / "checkpoint"))
    states.push_back(entry.path());
  std::sort(states.begin(), states.end());
  REQUIRE(states.size() == 2);
  std::string bytes = text_of(states.back());
  bytes[bytes.size() / 2] ^= 1;
  std::ofstream(states.back(), std::ios::binary) << bytes;
  std::vector<std::string> warnings;
  RunOptions options = bench.options;
  options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  const RunResult resumed = resume_run(options, {}, host());
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find(states.back().filename().string()) != std::string::npos);
  CHECK(resumed.state_hash == whole.state_hash);
  CHECK(series_of(bench, "energy") == energy);
}
