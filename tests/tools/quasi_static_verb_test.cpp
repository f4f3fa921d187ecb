#include "program.hpp"

using namespace scree::test;

namespace {

const std::string biaxial = text_of(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml");

}  // namespace

TEST_CASE("quasi-static follows the last stage, and cycles reads it", "[tools]") {
  const Workspace w(biaxial);
  const Outcome outcome =
      w.scree("quasi-static scene.toml --set scene.seed=12 --set stage.cycles.cycles=50 --out out");
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.starts_with("16 bodies, 50 degrees of freedom; "));
  const nlohmann::json record = w.record("out", "quasi_static.json");
  CHECK(record["status"] == "finished");
  CHECK(record["period"] == 10);
  CHECK(record["hand_overs"].empty());
  CHECK(double(record["end"]) - double(record["start"]) == Approx(500));
  CHECK(
      w.text("out/series/quasi_static.csv")
          .starts_with("time [s],length_x [m],length_y [m],stress_xx [Pa],stress_yy [Pa],strain_xx,strain_yy,"
                       "contacts,sliding,dynamic\n"));
  CHECK(w.has("out/charts/strain.png"));
  const Outcome cycles = w.scree("cycles out");
  INFO(cycles.err << cycles.out);
  REQUIRE(cycles.status == 0);
  CHECK(cycles.out.find("class         ratcheting") != std::string::npos);
  // Packing 12 by dynamics: -2.857e-9 in cycles 29 to 50 (scenarios/mcnamara2008). The increment is wrong by
  // its square: 20 of them by 1.3 %, 40 by a quarter of that; the rate of the dynamics by as much.
  const double slope = w.record("out", "cycles.json")["fit"]["slope"];
  CHECK(slope == Approx(-2.857e-9).epsilon(0.01));

  // What cycles has written goes with the results that it is of, and is replaced while they stay.
  REQUIRE(w.scree("cycles out").status == 0);
  REQUIRE(w.scree("quasi-static scene.toml --set stage.cycles.cycles=1 --overwrite --out out").status == 0);
  CHECK(w.has("out/quasi_static.json"));
  for (const char* name : {"out/cycles.csv", "out/cycles.json", "out/cycles.png"}) CHECK_FALSE(w.has(name));
}

TEST_CASE("resume goes on with quasi-static loads that were interrupted, and names what it cannot go on with",
          "[tools]") {
  const Workspace w(biaxial);
  const std::string follow =
      "quasi-static scene.toml --increments 50 --set scene.seed=12 --set stage.cycles.cycles=";
  REQUIRE(w.scree(follow + "200 --out whole").status == 0);
  const Outcome interrupted = w.shell(
      "'" SCREE_TEST_PROGRAM "' " + follow +
      "200 --out out &\nrun=$!\nuntil test -s out/state.h5; do sleep 0.01; done; kill -TERM $run; wait $run");
  INFO(interrupted.err << interrupted.out);
  REQUIRE(interrupted.status == 130);
  CHECK(interrupted.out.find("go on with: scree resume out\n") != std::string::npos);
  const auto refused = [&](const std::string& arguments, const std::string& problem) {
    const Outcome outcome = w.scree("resume " + arguments);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(problem) != std::string::npos);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
  };
  refused("whole", "whole: the quasi-static load is finished; give --overwrite with the scenario");
  refused("out --until 3",
          "out: holds a quasi-static load, which goes on as it began; give no --set, --until");
  // As one that was killed leaves it behind.
  w.write("out/series/quasi_static.csv", w.text("out/series/quasi_static.csv") + "1e9,1,1");
  nlohmann::json record = w.record("out", "quasi_static.json");
  const std::string scenario = record["scenario"];
  record["status"] = "running";
  record["scenario"] = scenario + "# of another load\n";
  w.write("out/quasi_static.json", record.dump());
  refused("out",
          "state.h5: is the state of another quasi-static load than that in quasi_static.json; put back");
  record["scenario"] = scenario;
  w.write("out/quasi_static.json", record.dump());
  CHECK(w.scree(follow + "200 --out out")
            .err.find("already contains a quasi-static load; go on with it: scree resume out, or ") !=
        std::string::npos);
  const Outcome resumed = w.scree("resume out");
  INFO(resumed.err << resumed.out);
  CHECK(resumed.status == 0);
  CHECK(w.text("out/series/quasi_static.csv") == w.text("whole/series/quasi_static.csv"));
  CHECK(w.record("out", "quasi_static.json")["status"] == "finished");
  CHECK(w.record("out", "quasi_static.json")["options"] == record["options"]);
  CHECK(int(record["options"]["increments"]) == 50);
  // The state of a run.
  w.write("out/quasi_static.json", record.dump());
  std::filesystem::copy_file(w / "out/final_state.h5", w / "out/state.h5");
  refused("out", "state.h5: is not the state of a quasi-static load; put back that of this directory");
  // Modes have none.
  std::filesystem::remove(w / "out/state.h5");
  refused("out", "out: no saved state to resume the quasi-static load from; give --overwrite");
}

TEST_CASE("where a packing has no equilibrium nearby, quasi-static goes on by dynamics", "[tools]") {
  const Workspace w(biaxial);
  const Outcome outcome =
      w.scree("quasi-static scene.toml --set scene.seed=13 --set stage.cycles.cycles=2 --out out");
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.find(" s by dynamics, in ") != std::string::npos);
  const nlohmann::json record = w.record("out", "quasi_static.json");
  REQUIRE(!record["hand_overs"].empty());
  CHECK(double(record["hand_overs"][0]["to"]) > double(record["hand_overs"][0]["from"]));
  CHECK(std::uint64_t(record["dynamic_steps"]) > 0);
}

TEST_CASE("a load that jumps, that does not change, or is hardly seen is named by quasi-static", "[tools]") {
  const Workspace w(biaxial);
  const auto warned = [&](const std::string& arguments, const std::string& problem) {
    const Outcome outcome =
        w.scree("quasi-static scene.toml --set stage.cycles.cycles=1 --overwrite --out out " + arguments);
    INFO(outcome.err << outcome.out);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.find(problem) != std::string::npos);
    return w.record("out", "quasi_static.json");
  };
  const nlohmann::json jump =
      warned("--set stage.cycles.set.box.stress_y_high.from=5",
             "the packing is not in balance with the loads at the start of the last stage");
  CHECK(jump["hand_overs"][0]["from"] == jump["start"]);
  CHECK(double(jump["hand_overs"][0]["to"]) > double(jump["start"]));
  warned("--set stage.cycles.set.box.stress_y_high=1", "no load on a wall changes in the last stage");
  warned("--increments 3", "--increments 3 leaves most loads of a period out; give at least 8");
  const nlohmann::json once =
      warned("--increments 1", "--increments 1 leaves most loads of a period out; give at least 8");
  CHECK(once["warnings"].size() == 1);  // none of loads that do not change
}

TEST_CASE("quasi-static refuses what it cannot follow in one line and writes nothing", "[tools]") {
  const Workspace w(biaxial);
  const auto refused = [&](const std::string& arguments, const std::string& problem) {
    const Outcome outcome = w.scree("quasi-static scene.toml --out out " + arguments);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(problem) != std::string::npos);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    CHECK(!w.has("out"));
  };
  refused("--elastic", "--elastic belongs to scree modes, which finds modes; leave it out");
  refused("--set stage.cycles.set.box.x_low=velocity --set stage.cycles.set.box.velocity_x_low=1e-3",
          "wall box.x_low is moved with 0.001 m/s");
  refused("--near 5", "--near belongs to scree modes, which finds modes; leave it out");
  refused(
      "--set stage.cycles.set.box.y_high=displacement "
      "--set 'stage.cycles.set.box.displacement_y_high={from=0,to=1e-3,period=10}'",
      "wall box.y_high is moved with ");
  CHECK(w.scree("modes scene.toml --quasi-static").err ==
        "scree: --quasi-static is a command of its own: scree quasi-static SCENARIO\n");
  CHECK(w.scree("response scene.toml").err ==
        "scree: scree response is now scree modes, or for quasi-static loads scree quasi-static\n");
  const std::string cylinder =
      biaxial + "\n[[boundary]]\nplugin = \"cylinder\"\npoint = [0, 0]\nradius = 100\n";
  w.write("scene.toml", cylinder + "torque = 0\ninertia = 1e6\n");
  refused(
      "",
      "surface cylinder is turned by torques, and quasi-static loads displace walls without turning them");
  w.write("scene.toml", cylinder + "spin = 1\n");
  refused("", "wall cylinder turns by a program");
  w.write("scene.toml", biaxial.substr(0, biaxial.find("[[stage]]\nname = \"cycles\"")));
  refused("", "the last stage is followed, and has no duration");
}
