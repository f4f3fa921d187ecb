#include "run_support.hpp"

#include <atomic>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

double value(const RunResult& result, const std::string& name) {
  for (const auto& [key, number] : result.quantities)
    if (key == name) return number;
  return -1;
}

}  // namespace

TEST_CASE("a run writes its series, run.json and its final packing", "[run]") {
  const Bench bench;
  const RunResult result = bench.run();
  CHECK(value(result, "steps") == 10);
  CHECK(value(result, "time") == Approx(1e-4));
  CHECK_FALSE(result.interrupted);
  const std::string series = text_of(bench.options.out / "series/energy.csv");
  CHECK(series.starts_with("time [s],kinetic_translation [J],kinetic_rotation [J],"));
  CHECK(lines_of(series).size() == 1 + 6);  // header, t = 0, 2e-5, ..., 1e-4
  CHECK(text_of(bench.options.out / "run.json").find("\"status\": \"finished\"") != std::string::npos);
  CHECK(fs::exists(bench.options.out / "final_packing.csv"));
  CHECK_FALSE(fs::exists(bench.options.out / "snapshots"));
}

TEST_CASE("the resolved scenario and the final packing of a run can be run again", "[run]") {
  const Bench bench(discs, {"scene.seed=5"});
  const RunResult first = bench.run();
  RunOptions options;
  options.out = bench.folder / "again";
  const Plan same = read_plan(bench.options.out / "scenario.toml", {}, host());
  CHECK(run_plan(same, options).state_hash == first.state_hash);
  const std::string file = "file = '" + (bench.options.out / "final_packing.csv").string() + "'\n";
  const Plan on = plan_of(with(discs,
                               "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                               "random_velocity = 0.1\n",
                               file));
  REQUIRE(on.scene.bodies.size() == 9);
  CHECK(on.scene.bodies[0].velocity[0] != 0);
}

TEST_CASE("a probe samples only in its stages, each time once", "[run]") {
  const Bench bench(
      with(with(discs, "duration = 1e-4\n", ""), "every = 2e-5", "every = 2e-5\nstages = ['b', 'c']") +
      "[[stage]]\nname = 'a'\nduration = 1e-4\n[[stage]]\nname = 'b'\nduration = 1e-4\n"
      "[[stage]]\nname = 'c'\nduration = 4e-5\n");
  bench.run();
  std::istringstream rows(text_of(bench.options.out / "series/energy.csv"));
  std::vector<double> times;
  std::string line;
  std::getline(rows, line);
  while (std::getline(rows, line)) times.push_back(std::stod(line));
  REQUIRE(times.size() == 8);  // 1.0, 1.2, ..., 2.0, 2.2, 2.4 in 1e-4 s
  for (std::size_t k = 0; k < times.size(); ++k) CHECK(times[k] == Approx(1e-4 + 2e-5 * double(k)));
}

TEST_CASE("a run reports its start once and has the same bits with more threads", "[run][threads]") {
  Bench one, two;
  int starts = 0;
  one.options.on_start = [&](const Simulation& s) { starts += s.steps() == 0 ? 1 : 100; };
  two.options.threads = 2;
  CHECK(one.run().state_hash == two.run().state_hash);
  CHECK(starts == 1);
}

TEST_CASE("expectations are judged by their bounds", "[run]") {
  const Bench bench(
      std::string(discs) +
      "[[expect]]\nrequirement = 'a'\nquantity = 'steps'\nreference = 10\ntolerance = 0\n"
      "[[expect]]\nrequirement = 'b'\nquantity = 'steps'\nreference = 11\ntolerance = 0.5\n"
      "[[expect]]\nrequirement = 'c'\nquantity = 'energy.time.max'\nat_most = 1.1e-4\nat_least = 1e-5\n"
      "[[expect]]\nrequirement = 'd'\nquantity = 'energy.time.mean'\nat_least = 1\n"
      "[[expect]]\nrequirement = 'e'\nquantity = 'energy.time.first'\nreference = 0\ntolerance = 0\n");
  const std::vector<Verdict> verdicts = bench.run().verdicts;
  REQUIRE(verdicts.size() == 5);
  const bool met[] = {true, false, true, false, true};
  for (std::size_t k = 0; k < 5; ++k) CHECK(verdicts[k].met == met[k]);
  CHECK(verdicts[3].value == Approx(5e-5));
}

TEST_CASE("a stopped run saves its results", "[run]") {
  Bench bench(discs, {"time.duration=1000"});
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](const Progress& p) {
    CHECK(p.stage == "run");
    CHECK(p.share < 1);
    stop = true;
  };
  const RunResult result = bench.run();
  CHECK(result.interrupted);
  CHECK(result.verdicts.empty());
  CHECK(text_of(bench.options.out / "run.json").find("\"status\": \"interrupted\"") != std::string::npos);
  CHECK(fs::exists(bench.options.out / "final_packing.csv"));
}

TEST_CASE("an end condition that is not reached is a failure that keeps the results", "[run]") {
  const Bench bench(with(discs, "duration = 1e-4\n", "") +
                    "[[stage]]\nname = 'rest'\nuntil = { kinetic_over_elastic = 1e-30, at_most = 1e-3 }\n");
  try {
    bench.run();
    FAIL("the run should not end");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::not_reached);
    CHECK(std::string(error.what()).starts_with("stage 'rest': after 0.001 s kinetic_over_elastic is "));
  }
  CHECK(text_of(bench.options.out / "run.json").find("\"error\": \"stage 'rest': ") != std::string::npos);
  CHECK(text_of(bench.options.out / "run.json").find("\"ended\": \"failed\"") != std::string::npos);
  CHECK(lines_of(text_of(bench.options.out / "series/energy.csv")).size() > 10);
}

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
  CHECK_FALSE(fs::exists(bench.options.out));
  CHECK(step_problem(*set_up(plan_of(discs))) == std::nullopt);
  CHECK_NOTHROW(set_up(plan_of(slow, {"time.step=1e-2", "time.duration=1", "time.step_guard=false"})));
}

TEST_CASE("a stage that makes contacts too stiff for the time step is refused before the run starts",
          "[run]") {
  const Bench bench(with(discs, "duration = 1e-4\n", "") +
                    "[[stage]]\nname = 'soft'\nduration = 1e-4\n[[stage]]\nname = 'stiff'\n"
                    "duration = 1e-4\nset.linear_spring_dashpot.normal_stiffness = 1e14\n");
  try {
    bench.run();
    FAIL("the step is too long");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::bad_input);
    CHECK(std::string(error.what())
              .find("scene.toml:4:8: in stage 'stiff' the time step of 1e-05 s is too long: ") !=
          std::string::npos);
    CHECK_FALSE(fs::exists(bench.options.out));
  }
}

TEST_CASE("errors of the scene as a whole have a position in the file too", "[run]") {
  const std::string head =
      with(discs,
           "[particles]\nlattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n"
           "radius = 0.01\nrandom_velocity = 0.1\n",
           "[[particle]]\nradius = 0.01\nposition = [0, 0]\n[[particle]]\nradius = 0.01\n"
           "position = [0.001, 0]\n");
  const auto reason = [](const Plan& plan) { return message([&] { set_up(plan); }); };
  const auto overlap = reason(plan_of(head));
  CHECK(overlap.find(
            "scene.toml:13:1: contact of particle 1 with particle 2: overlap is 1.9 of the smaller radius") !=
        std::string::npos);
  const Plan narrow =
      plan_of(with(head,
                   "plugin = 'box'\nx_low = 'fixed'\nx_high = 'fixed'\ny_low = 'fixed'\n"
                   "y_high = 'fixed'\ngap = 0.005\n",
                   "plugin = 'periodic'\naxes = 'x'\nlower = [-0.015, 0]\nupper = [0.015, 0]\n"));
  CHECK(reason(narrow).find("scene.toml:20:10: the periodic length 0.03 m along x is under twice ") !=
        std::string::npos);
  const Plan no_walls = plan_of(with(discs,
                                     "plugin = 'box'\nx_low = 'fixed'\nx_high = 'fixed'\ny_low = 'fixed'\n"
                                     "y_high = 'fixed'\ngap = 0.005\n",
                                     "plugin = 'plane'\npoint = [0, -1]\nnormal = [0, 1]\n"),
                                {"probe={plugin='box',every=1e-5}"});
  CHECK(reason(no_walls).starts_with(
      "--set probe={plugin='box',every=1e-5}: probe box: the box probe needs walls"));
}
