#include "program.hpp"

#include <sstream>

using namespace scree::test;

namespace {

std::string expectation(const std::string& bound) {
  return std::string(discs) + "[[expect]]\nrequirement = 'Ten steps'\nquantity = 'steps'\n" + bound + "\n";
}

}  // namespace

TEST_CASE("a run writes the series of each probe with names and units", "[tools]") {
  const Workspace w(std::string(discs) + "[[probe]]\nname = 'walls'\nplugin = 'box'\nevery = 5e-5\n");
  const Outcome outcome = w.run();
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const auto energy = lines_of(w.text("out/series/energy.csv")),
             walls = lines_of(w.text("out/series/walls.csv"));
  REQUIRE(energy.size() == 1 + 6);
  REQUIRE(walls.size() == 1 + 3);
  CHECK(energy[0].starts_with("time [s],kinetic_translation [J],"));
  CHECK(energy[0].ends_with(",work [J],residual [J]"));
  CHECK(walls[0] ==
        "time [s],length_x [m],length_y [m],stress_xx [Pa],stress_yy [Pa],strain_xx,strain_yy,"
        "deviatoric_stress [Pa],deviatoric_strain,solid_fraction");
  CHECK(energy[1].starts_with("0,"));
  for (const std::string& line : walls) CHECK(std::count(line.begin(), line.end(), ',') == 9);
  CHECK(std::stod(walls[3]) == Approx(1e-4));
}

TEST_CASE("run.json has the inputs and results of a run", "[tools]") {
  const Workspace w(expectation("at_most = 10"));
  CHECK(w.run("--set scene.seed=3").status == 0);
  const nlohmann::json record = w.record();
  CHECK(record["status"] == "finished");
  CHECK(record["seed"] == 3);
  CHECK(record["steps"].is_number_integer());
  CHECK(record["steps"] == 10);
  CHECK(record["version"].get<std::string>().size() >= 5);
  CHECK(w.scree("--version").out == "scree " + record["version"].get<std::string>() + " (commit " +
                                        record["commit"].get<std::string>() + ")\n");
  CHECK(record["scenario"].get<std::string>().find("seed = 3") != std::string::npos);
  CHECK(record["scenario"] == w.text("out/scenario.toml"));
  CHECK(record["wall_s"] > 0);
  CHECK(record["particle_steps_per_second"].get<double>() ==
        Approx(90 / record["stepping_s"].get<double>()).epsilon(1e-6));
  CHECK(record["stepping_s"].get<double>() + record["output_s"].get<double>() ==
        Approx(record["wall_s"].get<double>()).epsilon(1e-9));
  CHECK(record["energy_residual"] < 1e-3);
  CHECK(record["momentum_residual"] < 1e-12);
  CHECK(record["max_overlap_ratio"] >= 0);
  CHECK(record["min_steps_per_contact"] > 1000);
  CHECK(record["state_hash"].get<std::string>().size() == 16);
  REQUIRE(record["expect"].size() == 1);
  CHECK(record["expect"][0]["requirement"] == "Ten steps");
  CHECK(record["expect"][0]["value"] == 10);
  CHECK(record["expect"][0]["met"] == true);
}

TEST_CASE("a run without the energy audit reports no energy that it does not know", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.run("--set time.energy_audit=false --set 'probe=[]'");
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.out, !Catch::Contains("energy residual"));
  CHECK_THAT(outcome.out, Catch::Contains("momentum residual"));
  const auto record = nlohmann::json::parse(w.text("out/run.json"));
  for (const char* unknown :
       {"energy_residual", "energy_created", "elastic_energy", "dissipated_energy", "work"})
    CHECK(record[unknown].is_null());
  CHECK(record["kinetic_energy"] > 0);
}

TEST_CASE("the program prints the size of the scene once", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.run();
  CHECK(outcome.out.starts_with("9 bodies in 2D, 18 degrees of freedom; "));
  CHECK(outcome.out.find("time step 1e-05 s, ") != std::string::npos);
  CHECK(outcome.out.find("state hash " + w.record()["state_hash"].get<std::string>()) != std::string::npos);
  CHECK(outcome.out.find("results in out\n") != std::string::npos);
  const Outcome quiet = w.run("--overwrite --quiet");
  CHECK(quiet.out.starts_with("results in out\n"));
}

TEST_CASE("warnings go to stderr even with --quiet", "[tools]") {
  // 12 steps in the shortest contact, π √(m*/k).
  const Workspace w(with(discs, "1e4", "1e8"));
  const Outcome quiet = w.run("--quiet");
  CHECK(quiet.status == 0);
  CHECK(quiet.err.starts_with("scree: warning: the shortest contact takes "));
  CHECK(w.record()["warnings"].size() >= 1);
  CHECK("scree: warning: " + w.record()["warnings"][0].get<std::string>() + "\n" == quiet.err);
}

TEST_CASE("the end of a run lists every kind of result", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.run();
  for (const char* line : {"out/series                   time series (CSV), 1 file\n",
                           "out/final_packing.csv ", "out/scenario.toml ", "out/run.json "})
    CHECK(outcome.out.find(std::string("  ") + line) != std::string::npos);
  CHECK(outcome.out.find("10 steps in ") != std::string::npos);
  CHECK(outcome.out.find(" s for output\n") != std::string::npos);
}

TEST_CASE("a quiet run prints where its results are, and nothing else", "[tools]") {
  const Workspace w;
  const Outcome quiet = w.run("--quiet");
  CHECK(quiet.status == 0);
  CHECK(quiet.out == "results in out\n");
  CHECK(quiet.err.empty());
  CHECK(w.scree("resume out --until 2e-4 --quiet").out == "results in out\n");
}

TEST_CASE("the state has the same bits for any number of threads, and different ones for another seed",
          "[tools]") {
  const Workspace w(with(discs, "duration = 1e-4", "duration = 0.05"));
  const auto hash = [&](const std::string& options) {
    REQUIRE(w.run("--overwrite " + options).status == 0);
    REQUIRE(w.record()["max_overlap_ratio"] > 0);
    return w.record()["state_hash"].get<std::string>();
  };
  const std::string one = hash("--threads 1");
  CHECK(hash("--threads 2") == one);
  CHECK(hash("--set scene.seed=9") != one);
}

TEST_CASE("an expectation that is not met gives status 1 and keeps the run", "[tools]") {
  const Workspace w(expectation("reference = 11\ntolerance = 0.5"));
  const Outcome outcome = w.run();
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("NOT MET  Ten steps (steps = 10, expected 11 ± 0.5, off by -1)") !=
        std::string::npos);
  CHECK(w.record()["status"] == "finished");
  CHECK(w.record()["expect"][0]["met"] == false);
}

TEST_CASE("a run that blows up reports particle, contact, time and cure, and keeps its output", "[tools]") {
  const Workspace w(with(discs, "duration = 1e-4", "duration = 0.1"));
  const auto check = [&](const std::string& options, const std::vector<std::string>& parts) {
    const Outcome outcome = w.run("--overwrite --quiet " + options);
    INFO(outcome.err);
    CHECK(outcome.status == 3);
    // A forced step that is too long is warned of before.
    for (const std::string& line : lines_of(outcome.err)) CHECK(line.starts_with("scree: "));
    const std::string last = lines_of(outcome.err).back();
    for (const std::string& part : parts) CHECK(last.find(part) != std::string::npos);
    CHECK(w.record()["status"] == "failed");
    CHECK("scree: " + w.record()["error"].get<std::string>() == last);
    CHECK(lines_of(w.text("out/series/energy.csv")).size() >= 2);
  };
  check("--set time.step_guard=false --set particles.random_velocity=50",
        {"contact of particle ", "of the smaller radius at t = ", "; use a "});
  // The fastest disc starts at 0.34138 m/s; a collision makes a disc faster.
  check("--set limits.speed=0.35", {"particle ", " moves at ", " m/s at t = ", "; use a shorter time.step"});
  check("--set time.step_guard=false --set particles.random_velocity=1e100 --set limits.speed=1e300",
        {"particle ", " at t = ", "; use a "});
}

TEST_CASE("bodies that start above the speed limit are bad input", "[tools]") {
  const Workspace w{std::string(discs)};
  const Outcome outcome = w.run("--set limits.speed=1e-3");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("scene.toml:13:1: particle 1 moves at ") != std::string::npos);
}

TEST_CASE("without --out runs are numbered", "[tools]") {
  const Workspace w;
  for (const char* directory : {"runs/scene", "runs/scene-2", "runs/scene-3"}) {
    const Outcome outcome = w.scree("run scene.toml");
    CHECK(outcome.status == 0);
    CHECK(outcome.out.find(std::string("results in ") + directory + "\n") != std::string::npos);
    CHECK(w.record(directory)["status"] == "finished");
  }
}

TEST_CASE("runs started at once end in a directory each", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.shell("for k in 1 2 3 4; do '" SCREE_TEST_PROGRAM
                                  "' run scene.toml --set time.duration=2e-3 --quiet & done; wait");
  INFO(outcome.err);
  CHECK(outcome.err.empty());
  const auto runs = std::filesystem::directory_iterator(w / "runs");
  CHECK(std::distance(runs, {}) == 4);
  for (const char* directory : {"runs/scene", "runs/scene-2", "runs/scene-3", "runs/scene-4"}) {
    CHECK(w.record(directory)["status"] == "finished");
    CHECK_FALSE(w.has(std::string(directory) + "/.lock"));
  }
}

TEST_CASE("the directory of a run that is going on is refused, and nothing in it is touched", "[tools]") {
  const Workspace w(with(discs, "duration = 1e-4", "duration = 5000"));
  const Outcome outcome = w.shell("'" SCREE_TEST_PROGRAM
                                  "' run scene.toml --out out --quiet &\nrun=$!\n"
                                  "until test -s out/series/energy.csv; do sleep 0.05; done\n"
                                  "cp out/run.json out/scenario.toml .\n"
                                  "scree run scene.toml --out out --overwrite; echo second $?\n"
                                  "cmp out/run.json run.json && cmp out/scenario.toml scenario.toml\n"
                                  "kill -TERM $run; wait $run");
  CHECK(outcome.status == 130);
  CHECK(outcome.out.starts_with("second 2\n"));
  CHECK(outcome.err == "scree: out: another run is running there; wait for it, or give another --out\n");
  CHECK(w.record()["status"] == "interrupted");
}

TEST_CASE("a scene that is refused leaves no directory, nor the folder of runs", "[tools]") {
  const Workspace w;
  CHECK(w.scree("run scene.toml --set time.step=1").status == 2);
  CHECK_FALSE(w.has("runs"));
}

TEST_CASE("a run loads cairo for a chart, VTK for pictures of the scene, and neither without", "[tools]") {
  const Workspace w;
  const auto loads = [&](const std::string& options, const std::string& library) {
    const Outcome outcome = w.shell(
        "rm -f loaded.*; LD_DEBUG=files; LD_DEBUG_OUTPUT=loaded; export LD_DEBUG LD_DEBUG_OUTPUT\n"
        "scree run scene.toml --out out --overwrite " +
        options);
    REQUIRE(outcome.status == 0);
    std::string loaded;
    for (const auto& entry : std::filesystem::directory_iterator(w / ""))
      if (entry.path().filename().string().starts_with("loaded.")) loaded += text_of(entry.path());
    REQUIRE(loaded.find("linear_spring_dashpot.so") != std::string::npos);
    return loaded.find(library) != std::string::npos;
  };
  for (const char* library : {"libvtk", "libcairo"}) CHECK_FALSE(loads("", library));
  const std::string chart = "--set \"chart={name='work',probe='energy',y='work'}\"";
  CHECK(loads(chart, "libcairo"));
  CHECK_FALSE(loads(chart, "libvtk"));
  CHECK(w.has("out/charts/work.png"));
}

TEST_CASE("an interval of more steps than can be counted is never due", "[tools]") {
  for (const char* every : {"1e14", "1e20", "1e300"}) {
    const Workspace w;
    const Outcome outcome =
        w.shell("timeout 20 '" SCREE_TEST_PROGRAM "' run scene.toml --out out --set probe.every=" +
                std::string(every));
    CHECK(outcome.status == 0);
    CHECK(lines_of(w.text("out/series/energy.csv")).size() == 1 + 2);  // at the start and at the end
  }
}

TEST_CASE("an energy balance that is not a number is warned of", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.run(
      "--quiet --set material.density=1e300 --set particles.random_velocity=1e10 --set limits.speed=1e300 "
      "--set time.step=1e-20 --set time.duration=1e-19 --set time.step_guard=false --set probe.every=1e-19");
  CHECK((outcome.out + outcome.err).find("the energies are no longer finite numbers") != std::string::npos);
}

TEST_CASE("what is printed does not get into data where the standard streams are closed", "[tools]") {
  const Workspace w;
  const Outcome outcome = w.shell("scree run scene.toml --out out --set probe.every=1e-5 <&- >&- 2>&-");
  CHECK(outcome.status == 0);
  const auto energy = lines_of(w.text("out/series/energy.csv"));
  REQUIRE(energy.size() == 1 + 11);
  for (const std::string& line : energy) CHECK(std::count(line.begin(), line.end(), ',') == 17);
}

#if SCREE_TEST_PICTURES
TEST_CASE(
    "snapshots of a scene with control characters in its title can be drawn, and one with a NUL is refused",
    "[tools]") {
  const Workspace w(with(discs, "[scene]", "[scene]\ntitle = \"\\u0001\\t\\n\\u001b\\u007f\\u009b\"") +
                    "[snapshot]\nevery = 1e-4\n");
  REQUIRE(w.run().status == 0);
  CHECK(w.scree("render out --width 200 --height 200").status == 0);
  w.write("scene.toml", with(w.text("scene.toml"), "\\u0001", "\\u0000"));
  const Outcome refused = w.scree("run scene.toml --out other");
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Catch::StartsWith("scree: scene.toml:2:9: the text ") &&
                              Catch::EndsWith("has a character U+0000; remove it\n"));
  CHECK_FALSE(w.has("other"));
}
#endif

TEST_CASE("control characters in titles, stages and requirements are printed escaped", "[tools]") {
  const Workspace w(
      with(with(discs, "[scene]", "[scene]\ntitle = \"one\\n\\u001b[31mtwo\""), "duration = 1e-4\n", "") +
      "[[stage]]\nname = \"a\\nb\"\nduration = 1e-4\n"
      "[[expect]]\nrequirement = \"r\\u001b[1m\"\nquantity = 'steps'\nat_most = 10\n");
  std::string printed = w.scree("check scene.toml").out;
  printed += w.run().out;
  printed += w.run("--overwrite --set expect.at_most=1").out;
  CHECK(printed.find('\x1b') == std::string::npos);
  for (const char* part :
       {"valid, one\\n\\x1B[31mtwo\n", "  stage a\\nb: ", "met      r\\x1B[1m (", "NOT MET  r\\x1B[1m ("})
    CHECK(printed.find(part) != std::string::npos);
}
