#include "run_support.hpp"

#include <algorithm>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/files/directory_lock.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/state_file/state_file.hpp>

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

TEST_CASE("a state that the simulation refuses is passed over for the one before", "[run]") {
  Bench bench(stages);
  bench.plan.checkpoint.every_time = 3e-5;
  bench.run();
  const std::filesystem::path out = bench.options.out;
  const std::string energy = series_of(bench, "energy");
  std::filesystem::remove(out / "final_state.h5");
  const auto spoil = [&](const char* name) {
    State state = state_file::read_state(out / "checkpoint" / name);
    std::vector<double> positions = std::get<std::vector<double>>(state.at("bodies/position").values);
    positions[0] += 1e-3;
    StateArray other = state.at("bodies/position");
    other.values = positions;
    state.put("bodies/position", other);
    state_file::write_state(out / "checkpoint" / name, state);
  };
  spoil("step_000000000000009.h5");
  std::vector<std::string> warnings;
  bench.options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  SECTION("the run goes on from the one before") {
    resume(bench, {});
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0],
               Catch::Contains("step_000000000000009.h5: 'state_hash' is not that of the numbers"));
    CHECK(series_of(bench, "energy") == energy);
  }
  SECTION("without one it is refused") {
    spoil("step_000000000000006.h5");
    std::filesystem::remove_all(out / "states");
    CHECK_THAT(refused(bench, {}), Catch::Contains("step_000000000000009.h5: 'state_hash' is not that"));
    CHECK(warnings.empty());
  }
}

TEST_CASE("a run goes on from a stage that needs no spins, which the friction of the scene did", "[run]") {
  Bench bench(with(with(stages, "normal_damping = 0\n",
                        "normal_damping = 0\ntangential_stiffness = 5e3\nstatic_friction = 0.4\n"),
                   "name = 'second'\n", "name = 'second'\nset.linear_spring_dashpot.static_friction = 0\n"));
  bench.plan.checkpoint.every_time = 3e-5;
  bench.run();
  const std::string energy = series_of(bench, "energy");
  std::filesystem::remove(bench.options.out / "final_state.h5");
  resume(bench, {});
  CHECK(series_of(bench, "energy") == energy);
}

TEST_CASE("two runs of a scene leave the same bytes as their final state, whenever they wrote checkpoints",
          "[run][threads]") {
  const auto final_state = [](std::optional<double> every) {
    Bench bench(stages);
    bench.plan.checkpoint.every_time = every;
    CHECK(bench.run().states == (every ? 5u : 2u));
    return text_of(bench.options.out / "final_state.h5");
  };
  const std::string once = final_state({});
  REQUIRE(once.size() > 1000);
  CHECK(final_state({}) == once);
  CHECK(final_state(2.5e-5) == once);
}

TEST_CASE("a run that goes on counts its wall time and its states on", "[run]") {
  const Bench bench(stages, {"checkpoint.every_time=3e-5"});
  bench.run();
  const auto record = [&] { return nlohmann::json::parse(text_of(bench.options.out / "run.json")); };
  // As if it had taken long.
  auto before = record();
  const std::uint64_t states = before["states"];
  before["wall_s"] = 100, before["output_s"] = 60, before["states_s"] = 30;
  bench.folder.write("out/run.json", before.dump());
  const RunResult prolonged = resume(bench, {}, 2e-4);
  for (const auto& [now, then] : {std::pair(prolonged.wall, 100), std::pair(prolonged.output, 60),
                                  std::pair(prolonged.state_output, 30)}) {
    CHECK(now >= then);
    CHECK(now < then + 10);  // ten steps
  }
  CHECK(prolonged.states > states);
  CHECK(record()["states"] == prolonged.states);
}

TEST_CASE("checkpoints after the state from which a run goes on are removed", "[run]") {
  const Bench bench(stages, {"checkpoint.every_time=2e-5", "checkpoint.final_state=false"});
  bench.run();
  const auto later = bench.options.out / "checkpoint/step_000000000000008.h5";
  REQUIRE(std::filesystem::exists(later));
  std::filesystem::resize_file(later, 100);
  std::vector<std::string> warnings;
  RunOptions options = bench.options;
  options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  options.on_start = [&](const Simulation&) { CHECK_FALSE(std::filesystem::exists(later)); };
  resume_run(options, {}, host());
  CHECK(warnings.size() == 1);
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

TEST_CASE("messages about the directory of a run that goes on ask for no other", "[run]") {
  const Bench bench(discs);
  bench.run();
  SECTION("another process uses it") {
    RunDirectory other(bench.options.out, RunDirectory::Existing::keep);
    other.take();
    CHECK(refused(bench, {}, 2e-4).ends_with("another run is running there; wait for it"));
  }
  SECTION("its list of files was lost") {
    std::filesystem::remove(bench.options.out / "written.txt");
    CHECK(refused(bench, {}, 2e-4).ends_with("can be neither replaced nor resumed; move it elsewhere"));
  }
  SECTION("its list is no file") {
    std::filesystem::remove(bench.options.out / "written.txt");
    std::filesystem::create_directory(bench.options.out / "written.txt");
    CHECK(refused(bench, {}, 2e-4).ends_with("written.txt: is not a file; remove it"));
  }
}

TEST_CASE("a run that goes on in its directory is not told to take another", "[run]") {
  const Bench bench(stages);
  bench.run();
  const auto lock = files::DirectoryLock::take(bench.options.out);
  const std::string line = refused(bench, {}, 2e-4);
  INFO(line);
  CHECK(line.ends_with("out: another run is running there; wait for it"));
}

TEST_CASE("a scenario that is edited beside a run that goes on is reported, and restored", "[run]") {
  const TemporaryFolder folder;
  folder.write("bodies.csv", "x,y,radius\n0.02,0.02,0.01\n0.05,0.03,0.01\n");
  const auto scene = folder.write(
      "scene.toml",
      with(stages,
           "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\nrandom_velocity = 0.1\n",
           "file = 'bodies.csv'\n"));
  RunOptions options;
  options.out = folder / "out";
  run_plan(scenario::read_plan(scene, {}, host()), options);
  std::vector<std::string> warnings;
  options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  const auto prolong = [&](double until) { resume_run(options, {{}, until, {}}, host()); };
  const auto scenario_now = [&] { return text_of(folder / "out/scenario.toml"); };
  prolong(2e-4);
  prolong(3e-4);
  CHECK(warnings.empty());
  const std::string before = scenario_now();
  CHECK_THAT(before, Catch::Contains((folder / "bodies.csv").string()));
  SECTION("a value") {
    folder.write("out/scenario.toml", with(before, "normal_stiffness = 1", "normal_stiffness = 2"));
  }
  SECTION("the file of bodies") {
    folder.write("out/scenario.toml", with(before, "bodies.csv", "others.csv"));
  }
  SECTION("no TOML any more") { folder.write("out/scenario.toml", "edit"); }
  SECTION("removed") { std::filesystem::remove(folder / "out/scenario.toml"); }
  prolong(4e-4);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Catch::Contains("out/scenario.toml: is not the scenario with which these results began") &&
                 Catch::Contains("begin a new run from a state (particles.state)"));
  CHECK_THAT(scenario_now(), Catch::Contains("normal_stiffness = 1") && Catch::Contains("bodies.csv") &&
                                 !Catch::Contains("others.csv"));
}

TEST_CASE("a run that is killed before its first state begins again as it was, also with its warnings",
          "[run]") {
  // 12 steps in the shortest contact, and a wave of less than two steps.
  const std::string drive =
      "[[boundary]]\nplugin = 'plane'\nname = 'drive'\npoint = [-1, 0]\nnormal = [1, 0]\ncontrol = 'displacement'\n"
      "displacement = { amplitude = 1e-6, frequency_hz = 60000 }\n";
  const Bench bench(with(stages, "1e4", "1e8") + drive,
                    {"checkpoint.final_state=false", "checkpoint.stage_states=false"});
  const RunResult whole = bench.run();
  REQUIRE(whole.warnings.size() == 2);
  std::string record = text_of(bench.options.out / "run.json");
  // As it is written before the first step.
  record.replace(record.find("finished"), 8, "running");
  bench.folder.write("out/run.json", record);
  std::vector<std::string> warnings;
  RunOptions options = bench.options;
  options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  bool edited = false;
  SECTION("left alone") {}
  SECTION("edited") {
    const auto file = bench.options.out / "scenario.toml";
    bench.folder.write("out/scenario.toml", with(text_of(file), "name = \"drive\"", "name = \"wall\""));
    edited = true;
  }
  CHECK_THROWS_WITH(resume_run(options, {}, host()),
                    Catch::Contains("give --overwrite to replace its results"));
  options.overwrite = true;
  const RunResult again = resume_run(options, {}, host());
  CHECK(again.warnings == whole.warnings);
  CHECK(again.state_hash == whole.state_hash);
  REQUIRE(warnings.size() == (edited ? 4 : 3));
  if (edited) CHECK_THAT(warnings[0], Catch::Contains("is not the scenario with which these results began"));
  CHECK_THAT(text_of(bench.options.out / "scenario.toml"), Catch::Contains("drive"));
}
