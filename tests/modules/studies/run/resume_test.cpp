#include "foreign_state.hpp"
#include "oscillator.hpp"
#include "run_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/files/directory_lock.hpp>
#include <scree/run/run_directory.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

namespace {

std::uint64_t steps_of(const RunResult& result) {
  return result.stages.back().first_step + result.stages.back().steps;
}

const std::string probed = std::string(discs) +
                           "[[probe]]\nplugin = 'particles'\nids = [2, 5]\nevery = 1e-5\n"
                           "[[probe]]\nplugin = 'touching'\nids = [3]\nevery = 1e-5\n"
                           "[[probe]]\nplugin = 'mean_squared_displacement'\nids = [1, 9]\nevery = 1e-5\n";

// Stopped after five of ten steps, with a state that others may change: its seal is right then too.
struct Stopped : Bench {
  std::filesystem::path state = options.out / "checkpoint/step_000000000000005.h5";

  Stopped() : Bench(probed, {"checkpoint.every_time=5e-5", "checkpoint.final_state=false"}) {
    run();
    std::filesystem::remove(options.out / "checkpoint/step_000000000000010.h5");
  }
};

}  // namespace

// At the time of the state other discs lie in the region of the group: those that it fixed at the start stay
// fixed.
TEST_CASE("a run with fixed bodies goes on to the same bits", "[run]") {
  const std::string fixed =
      with(discs, "random_velocity = 0.1\n", "random_velocity = 0.1\nvelocity = [-200, 0]\n") +
      "[limits]\nspeed = 1e4\noverlap_ratio = 1e9\n"
      "[[group]]\nname = 'left'\nfixed = true\nwhere = { x = [0, 0.02] }\n";
  const std::vector<std::string> unguarded = {"time.step_guard=false"};
  const Bench whole(fixed, unguarded), halves(with(fixed, "duration = 1e-4", "duration = 5e-5"), unguarded);
  whole.run();
  halves.run();
  const RunResult resumed = resume(halves, {}, 1e-4);
  const State at_end = state_file::read_state(whole.options.out / "final_state.h5");
  CHECK(state_file::read_state(halves.options.out / "final_state.h5").at("bodies/fixed") ==
        at_end.at("bodies/fixed"));
  CHECK(state_file::read_state(halves.options.out / "final_state.h5").at("state_hash") ==
        at_end.at("state_hash"));
  CHECK(series_of(halves, "energy") == series_of(whole, "energy"));
  std::size_t now_in_region = 0, are_fixed = 0;
  for (const Body& body : present_bodies(at_end))
    now_in_region += body.position[0] < 0.02, are_fixed += body.fixed;
  CHECK(are_fixed == 3);
  CHECK(now_in_region > 3);
}

// At the time of the state other discs lie in the region of the group: those that count at the start go on to
// count.
TEST_CASE("a run that goes on counts the same bodies in its probes", "[run]") {
  const std::string chosen =
      with(discs, "random_velocity = 0.1\n", "random_velocity = 0.1\nvelocity = [-200, 0]\n") +
      "[limits]\nspeed = 1e4\noverlap_ratio = 1e9\n"
      "[[group]]\nname = 'left'\nwhere = { x = [0, 0.02] }\n"
      "[[probe]]\nplugin = 'momentum'\ngroups = ['left']\nevery = 1e-5\n"
      "[[probe]]\nname = 'others'\nplugin = 'layer'\nleave_out = ['left']\nat = 0.033\nhalf_width = 1\nevery = 1e-5\n";
  const std::vector<std::string> unguarded = {"time.step_guard=false"};
  const Bench whole(chosen, unguarded), halves(with(chosen, "duration = 1e-4", "duration = 5e-5"), unguarded);
  whole.run();
  halves.run();
  resume(halves, {}, 1e-4);
  for (const char* probe : {"momentum", "others"}) CHECK(series_of(halves, probe) == series_of(whole, probe));
  CHECK(series_of(whole, "others").find("\n0,6,") != std::string::npos);
}

TEST_CASE("a run that cannot go on leaves its series as they are", "[run]") {
  // The last row is behind the state at the end, so that going on would drop it.
  const Bench bench(with(discs, "every = 2e-5", "every = 3e-5") +
                    "[[probe]]\nname = 'walls'\nplugin = 'box'\nevery = 3e-5\n");
  bench.run();
  const std::string energy = series_of(bench, "energy");
  SECTION("a series was removed") {
    std::filesystem::remove(bench.options.out / "series/walls.csv");
    CHECK(resume_refusal(bench, {}, 2e-4).find("walls.csv: cannot be opened") != std::string::npos);
  }
  SECTION("a series was shortened") {
    std::filesystem::resize_file(bench.options.out / "series/walls.csv", 20);
    CHECK(resume_refusal(bench, {}, 2e-4).find("walls.csv: is shorter") != std::string::npos);
  }
  SECTION("the list of files was shortened") {
    std::filesystem::resize_file(bench.options.out / "written.txt", 40);
    CHECK(resume_refusal(bench, {}, 2e-4).find("written.txt: has no line that ends") != std::string::npos);
  }
  CHECK(series_of(bench, "energy") == energy);
}

TEST_CASE("a prolonged run ends where --until says, and its scenario says so too", "[run]") {
  SECTION("the last of several stages") {
    const Bench bench(two_stages);
    bench.run();
    CHECK(steps_of(resume(bench, {}, 2e-4)) == 20);
    const Bench whole(two_stages, {"stage.second.duration=1.5e-4"});
    whole.run();
    CHECK(series_of(bench, "energy") == series_of(whole, "energy"));
    // (2e-4 - 5e-5) s has an error of round-off.
    CHECK(plan_of(text_of(bench.options.out / "scenario.toml")).stages[1].duration.value() ==
          Approx(1.5e-4).epsilon(1e-14));
  }
  SECTION("a stage of cycles") {
    const Bench bench(
        with(two_stages, "name = 'second'\nduration = 5e-5", "name = 'second'\ncycles = 1\nperiod = 5e-5"));
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
    const Bench bench(with(two_stages, "name = 'first'\nduration = 5e-5",
                           "name = 'first'\nuntil = { kinetic_over_elastic = 1e12, at_most = 1 }") +
                      "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -1e4]\n");
    const RunResult first = bench.run();
    const double began = first.stages[1].start;
    CHECK(resume(bench, {}, began + 8e-5).stages[1].steps == 8);
  }
}

TEST_CASE("only lengths of stages that are not over can be set when a run goes on", "[run]") {
  const Bench bench(two_stages);
  bench.run();
  const auto contains = [&](const std::string& override_text, const char* part) {
    INFO(override_text);
    const std::string line = resume_refusal(bench, {override_text}, 2e-4);
    INFO(line);
    CHECK(line.find(part) != std::string::npos);
  };
  contains("stage.first.duration=1e-4", "stage 'first' is over");
  contains("stage.second.at_most=1", "unknown key 'at_most'");
  contains("probe.energy.duration=1", "can change only how long");
  CHECK(resume_refusal(bench, {}, 1e-4).find("finished at t = 0.0001 s; give a later --until") !=
        std::string::npos);
}

TEST_CASE("a run that was killed behind its last state is completed", "[run]") {
  const Bench bench(two_stages);
  const RunResult first = bench.run();
  const std::filesystem::path out = bench.options.out;
  const std::string energy = series_of(bench, "energy"), packing = text_of(out / "final_packing.csv");
  std::string record = text_of(out / "run.json");
  record.replace(record.find("finished"), 8, "running");
  bench.folder.write("out/run.json", record);
  std::filesystem::remove(out / "final_packing.csv");
  const RunResult completed = resume(bench);
  CHECK(completed.state_hash == first.state_hash);
  CHECK(completed.verdicts.size() == first.verdicts.size());
  CHECK(series_of(bench, "energy") == energy);
  CHECK(text_of(out / "final_packing.csv") == packing);
  CHECK(text_of(out / "run.json").find("\"status\": \"finished\"") != std::string::npos);
  CHECK(resume_refusal(bench).find("the run has finished") != std::string::npos);
}

TEST_CASE("a prolonged run that is killed at once is still prolonged", "[run]") {
  const Bench bench(two_stages);
  bench.run();
  RunOptions killed = bench.options;
  killed.on_start = [](const Simulation&) { throw std::runtime_error("killed"); };
  CHECK_THROWS(resume_run(killed, {{}, 2e-4, {}}, host()));
  const RunResult completed = resume(bench);
  CHECK(completed.stages.back().end == Approx(2e-4));
}

TEST_CASE("a run goes on from a stage that needs no spins, which the friction of the scene did", "[run]") {
  Bench bench(with(with(two_stages, "normal_damping = 0\n",
                        "normal_damping = 0\ntangential_stiffness = 5e3\nstatic_friction = 0.4\n"),
                   "name = 'second'\n", "name = 'second'\nset.linear_spring_dashpot.static_friction = 0\n"));
  bench.plan.checkpoint.every_time = 3e-5;
  bench.run();
  const std::string energy = series_of(bench, "energy");
  std::filesystem::remove(bench.options.out / "final_state.h5");
  resume(bench);
  CHECK(series_of(bench, "energy") == energy);
}

TEST_CASE("messages about the directory of a run that goes on ask for no other", "[run]") {
  const Bench bench(discs);
  bench.run();
  SECTION("another process uses it") {
    RunDirectory other(bench.options.out, RunDirectory::Existing::keep);
    other.take();
    CHECK(resume_refusal(bench, {}, 2e-4).ends_with("another run is running there; wait for it"));
  }
  SECTION("its list of files was lost") {
    std::filesystem::remove(bench.options.out / "written.txt");
    CHECK(
        resume_refusal(bench, {}, 2e-4).ends_with("can be neither replaced nor resumed; move it elsewhere"));
  }
  SECTION("its list is no file") {
    std::filesystem::remove(bench.options.out / "written.txt");
    std::filesystem::create_directory(bench.options.out / "written.txt");
    CHECK(resume_refusal(bench, {}, 2e-4).ends_with("written.txt: is not a file; remove it"));
  }
}

TEST_CASE("a run that goes on in its directory is not told to take another", "[run]") {
  const Bench bench(two_stages);
  bench.run();
  const auto lock = files::DirectoryLock::take(bench.options.out);
  const std::string line = resume_refusal(bench, {}, 2e-4);
  INFO(line);
  CHECK(line.ends_with("out: another run is running there; wait for it"));
}

TEST_CASE("a run that is killed before its first state begins again as it was, also with its warnings",
          "[run]") {
  // 12 steps in the shortest contact, and a wave of less than two steps.
  const std::string drive =
      "[[boundary]]\nplugin = 'plane'\nname = 'drive'\npoint = [-1, 0]\nnormal = [1, 0]\ncontrol = 'displacement'\n"
      "displacement = { amplitude = 1e-6, frequency_hz = 60000 }\n";
  const Bench bench(with(two_stages, "1e4", "1e8") + drive,
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

TEST_CASE("the bodies of a probe are found again if a state has other indices for them", "[run]") {
  const Stopped bench;
  const std::string particles = series_of(bench, "particles"), touching = series_of(bench, "touching"),
                    displacement = series_of(bench, "mean_squared_displacement");
  const double wrong = GENERATE(1e16, -1.0, 9.0, 10.0, double(NAN), double(INFINITY));
  change_number(bench.state, "run/probes/1/state", 0, wrong);
  change_number(bench.state, "run/probes/2/state", 3, wrong);
  change_number(bench.state, "run/probes/3/state", 5 + 3 * 2 + 1, wrong);
  resume(bench);
  CHECK(series_of(bench, "particles") == particles);
  CHECK(series_of(bench, "touching") == touching);
  CHECK(series_of(bench, "mean_squared_displacement") == displacement);
}

TEST_CASE("a state of a run that does not tell its step is passed over by name", "[run]") {
  Stopped bench;
  std::vector<std::string> warnings;
  bench.options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  remove_array(bench.state, "clock/steps");
  CHECK_THAT(resume_refusal(bench),
             Catch::EndsWith("none of its states can be read; run the scenario again"));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::StartsWith(bench.state.string() + ": the state has no 'clock/steps'; "));
}

TEST_CASE("a state of a run that does not fit is refused, and nothing is changed", "[run]") {
  const Stopped bench;
  const std::string record = text_of(bench.options.out / "run.json");
  const auto refused = [&](const auto& change) {
    const std::string before = text_of(bench.state);
    change();
    const std::string line = resume_refusal(bench);
    bench.folder.write("out/checkpoint/step_000000000000005.h5", before);
    CHECK(line.find("; ") != std::string::npos);
    return line;
  };
  for (const char* array : {"bodies/velocity", "walls/planes/point", "clock/time", "run/stages/began"})
    CHECK(refused([&] { change_number(bench.state, array, 0, double(INFINITY)); }).find(array) !=
          std::string::npos);
  for (const std::string path :
       {"run/probes/2/state", "run/scenario", "run/stages/stage", "bodies/radius", "bodies/velocity"})
    CHECK_THAT(refused([&] { remove_array(bench.state, path); }),
               Catch::StartsWith(bench.state.string() + ": the state has no '" + path + "'; "));
  CHECK(refused([&] {
          change_state(bench.state, "run/probes/2/state", shorten);
        }).find("has 3 numbers instead of 4") != std::string::npos);
  CHECK(refused([&] {
          change_number(bench.state, "run/stages/stage", 0, std::uint64_t(9));
        }).find("from 0 to 1") != std::string::npos);
  refused([&] { change_number(bench.state, "run/scenario", 0, with(probed, "duration = 1e-4\n", "")); });
  CHECK(text_of(bench.options.out / "run.json") == record);
}

TEST_CASE("a length that was set when a run went on holds when it goes on from a stage", "[run]") {
  const Bench bench(two_stages);
  bench.run();
  RunOptions options = bench.options;
  std::vector<std::string> warnings;
  options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  ResumeChanges longer;
  longer.overrides = {"stage.second.duration=3e-4"};
  CHECK(resume_run(options, longer, host()).stages.back().steps == 30);
  ResumeChanges from;
  from.from = "first";
  options.overwrite = true;
  CHECK(resume_run(options, from, host()).stages.back().steps == 30);
  CHECK(warnings.empty());
}

TEST_CASE("a run that is resumed in the middle of a record measures the same bits", "[run]") {
  const std::vector<std::string> settings = {
      "time.duration=1",          "probe.response.from=0.2",    "probe.response.periods=15",
      "probe.response.every=0.1", "checkpoint.every_time=0.43", "checkpoint.final_state=false"};
  const Bench bench(oscillator, settings);
  const RunResult whole = bench.run();
  const std::string series = text_of(bench.options.out / "series/response.csv");
  // Only the state at 0.43 s remains, after a quarter of the record.
  std::vector<std::filesystem::path> states;
  for (const auto& entry : std::filesystem::directory_iterator(bench.options.out / "checkpoint"))
    states.push_back(entry.path());
  REQUIRE(states.size() == 2);
  std::filesystem::remove(std::max(states[0], states[1]));
  const RunResult resumed = resume_run(bench.options, {}, host());
  CHECK(text_of(bench.options.out / "series/response.csv") == series);
  REQUIRE(resumed.verdicts.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) CHECK(resumed.verdicts[k].value == whole.verdicts[k].value);
  CHECK(resumed.verdicts[2].value == 750);
}

TEST_CASE("a run with derived quantities goes on to the same bits", "[run]") {
  const std::string text =
      std::string(discs) +
      "[derived]\np = 'energy.kinetic_translation / 3'\nq = 'atan(derived.p) ^ 2 * time'\n";
  const Bench whole(text), halves(with(text, "duration = 1e-4", "duration = 5e-5"));
  whole.run();
  halves.run();
  resume(halves, {}, 1e-4);
  CHECK(series_of(halves, "derived") == series_of(whole, "derived"));
  CHECK(series_of(whole, "derived").starts_with("time [s],p [J],q [rad^2 s]\n"));
}
