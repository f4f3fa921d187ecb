#include "run_support.hpp"

#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/run/set_up.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/state_file/state_file.hpp>
#include <scree/state_transfer.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

TEST_CASE("a scenario that is edited beside a run that goes on is reported, and restored", "[run]") {
  const TemporaryFolder folder;
  folder.write("bodies.csv", "x,y,radius\n0.02,0.02,0.01\n0.05,0.03,0.01\n");
  const auto scene = folder.write(
      "scene.toml",
      with(two_stages,
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

namespace {

// The directory of an interrupted quasi-static load of `discs`.
struct Interrupted {
  TemporaryFolder folder;
  scenario::Plan plan = plan_of(discs);

  Interrupted() {
    RunDirectory directory(folder / "out", RunDirectory::Existing::refuse, RunDirectory::Kind::quasi_static);
    directory.create();
    directory.write_file("scenario.toml", plan.resolved_text);
    directory.write_file("quasi_static.json", record("interrupted", plan.resolved_text));
    write_state("quasi_static", plan.resolved_text);
  }
  static std::string record(const std::string& status, const std::string& scenario) {
    return nlohmann::json{{"status", status}, {"scenario", scenario}}.dump();
  }
  void write_state(const std::string& group, std::string scenario) const {
    State state = set_up(plan)->state();
    StateTransfer::saving_to(state).below(group).value("scenario", "", scenario);
    state_file::write_state(folder / "out/state.h5", state);
  }
  Unfinished found() const { return unfinished_in(folder / "out", quasi_static_results, host(), {}); }
  std::string refused() const {
    return message([&] { found(); });
  }
};

}  // namespace

TEST_CASE("interrupted results go on with their state, plan and directory", "[run]") {
  const Interrupted results;
  const Unfinished from = results.found();
  CHECK(from.file == results.folder / "out/state.h5");
  CHECK(from.plan.resolved_text == results.plan.resolved_text);
  CHECK(from.plan.text_for_any_folder.empty());  // scenario.toml is as it was
  REQUIRE(from.plan.scene.bodies.size() == 9);
  CHECK(from.plan.scene.bodies[4].position == results.plan.scene.bodies[4].position);
  CHECK(from.state.at("bodies/position") == set_up(results.plan)->state().at("bodies/position"));
  CHECK_THAT(results.refused(), Catch::Contains("another quasi-static load is running there; wait for it"));
}

TEST_CASE("results that cannot go on are refused with what is wrong and what to do", "[run]") {
  const Interrupted results;
  const std::string& scenario = results.plan.resolved_text;
  const auto write_record = [&](const std::string& text) {
    results.folder.write("out/quasi_static.json", text);
  };
  SECTION("finished") {
    write_record(Interrupted::record("finished", scenario));
    CHECK_THAT(results.refused(),
               Catch::Contains("out: the quasi-static load is finished; give --overwrite"));
  }
  SECTION("no state") {
    std::filesystem::remove(results.folder / "out/state.h5");
    CHECK_THAT(results.refused(),
               Catch::Contains("out: no saved state to resume the quasi-static load from; "));
  }
  SECTION("a state of another kind") {
    results.write_state("spectrum", scenario);
    CHECK_THAT(results.refused(),
               Catch::Contains("state.h5: is not the state of a quasi-static load; put back"));
  }
  SECTION("a state of another scenario") {
    write_record(Interrupted::record("interrupted", with(scenario, "1000", "1001")));
    CHECK_THAT(results.refused(),
               Catch::Contains(
                   "state.h5: is the state of another quasi-static load than that in quasi_static.json; "));
  }
  SECTION("no record") {
    std::filesystem::remove(results.folder / "out/quasi_static.json");
    CHECK_THAT(results.refused(),
               Catch::Contains("out: contains no quasi-static load; give the directory of one"));
  }
}
