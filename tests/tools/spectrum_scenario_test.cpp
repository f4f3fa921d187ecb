#include "program.hpp"

#include <algorithm>

using namespace scree::test;

namespace {

const std::string peak =
    "--set spectrum.from_hz=70 --set spectrum.to_hz=105 --set spectrum.sweep.periods=60 "
    "--set spectrum.sweep.analysed_periods=30 ";

}  // namespace

TEST_CASE("spectrum measures a scenario by all methods and prints what they found", "[tools]") {
  const Workspace w(chain);
  const Outcome outcome = w.scree("spectrum scene.toml --by all --out out " + peak);
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(lines_of(outcome.out).size() <= 27);
  for (const char* part : {"linear ", "pulse ", "sweep ", "particles.z_8, linear:",
                           "results in out: spectrum.csv, peaks.csv, sweep.csv, methods.csv"})
    CHECK(outcome.out.find(part) != std::string::npos);
  CHECK(w.text("out/spectrum.csv")
            .starts_with("method,frequency [Hz],particles.z_1.amplitude [1],particles.z_1.phase [rad],"));
  // Three methods with two columns each; the header.
  CHECK(lines_of(w.text("out/peaks.csv")).size() == 7);
  CHECK(lines_of(w.text("out/spectrum.csv")).size() == 1 + 3 * 71);
  CHECK(lines_of(w.text("out/sweep.csv")).size() == 1 + 71);
  CHECK(lines_of(w.text("out/methods.csv")).size() == 4);
  CHECK(nlohmann::json::parse(w.text("out/spectrum.json"))["status"] == "finished");
  CHECK(nlohmann::json::parse(w.text("out/spectrum.json"))["options"]["by"] == "all");
  CHECK(w.has("out/charts/particles_z_8.png"));
}

TEST_CASE("a sweep that Ctrl-C ends goes on with resume, to the same table", "[tools]") {
  const Workspace w(chain);
  const std::string sweep = "' spectrum scene.toml --quiet " + peak;
  const Outcome outcome =
      w.shell("'" SCREE_TEST_PROGRAM + sweep + "--out whole\n'" SCREE_TEST_PROGRAM + sweep +
              "--out out &\nrun=$!\nuntil test -s out/state.h5; do sleep 0.01; done; sleep 0.2\n"
              "kill -TERM $run; wait $run; echo status $?\nscree resume out --quiet");
  INFO(outcome.err << outcome.out);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.find("status 130") != std::string::npos);
  CHECK(outcome.out.find("go on with: scree resume out") != std::string::npos);
  CHECK(w.text("out/sweep.csv") == w.text("whole/sweep.csv"));
  CHECK(w.text("out/spectrum.csv") == w.text("whole/spectrum.csv"));
}

TEST_CASE("a spectrum that ends in its stages names no files that it has not", "[tools]") {
  const Workspace w(with(chain, "ids = [1, 8]", "ids = [1, 8]\nevery = 1"));
  const Outcome outcome =
      w.shell("'" SCREE_TEST_PROGRAM
              "' spectrum scene.toml --quiet --out out --set time.duration=1000 &\nrun=$!\n"
              "until test -s out/spectrum.json; do sleep 0.01; done; sleep 0.2\n"
              "kill -TERM $run; wait $run; echo status $?");
  INFO(outcome.err << outcome.out);
  CHECK(outcome.out ==
        "interrupted; results so far are saved, go on with: scree resume out\nresults in out\nstatus 130\n");
  CHECK(!w.has("out/spectrum.csv"));
}

TEST_CASE("spectrum refuses what it cannot measure in one line and writes nothing", "[tools]") {
  const Workspace w(chain);
  const auto refused = [&](const std::string& arguments, const std::string& begin, const std::string& end) {
    check_refused(w, w.scree("spectrum " + arguments), begin, end);
    CHECK(!w.has("out"));
  };
  refused("--out out", "neither a scenario nor --csv", "or --csv FILE --column NAME");
  refused("scene.toml --csv x.csv --column y", "--csv analyses a file, not a scenario", "give one of them");
  refused("--csv x.csv --column y --set a=1", "--csv analyses a file, which has no --by and --set",
          "leave them out");
  refused("scene.toml --frequency 50", "--column and --frequency are of a file",
          "[spectrum] of the scenario");
  refused("--csv x.csv", "--csv without --column", "give --column NAME");
  refused("--resume", "--resume without --out", "with the directory of the spectrum");
  refused("scene.toml --resume --out out", "--resume goes on with what the spectrum began",
          "--by and --set out");
  refused("--resume --out out --set a=1", "--resume goes on with what the spectrum began",
          "--by and --set out");
  refused("--resume --out out", "out: contains no spectrum", "give the directory of one");
  const std::string scene = "scene.toml --out out --set ";
  refused(scene + "spectrum.drive=\\'lid.displacement\\'", "--set spectrum.drive=", "there are: floor");
  refused(scene + "spectrum.observe=[\\'particles.z_9\\']",
          "--set spectrum.observe=", "did you mean 'particles.z_1'?");
  for (const std::string amplitude : {"-1e-8", "5e-324"})
    refused(scene + "spectrum.amplitude=" + amplitude,
            "--set spectrum.amplitude=", "give an amplitude of 1e-100 m or more");
  refused(scene + "spectrum.to_hz=1e5", "--set spectrum.to_hz=", "a shorter time.step");
  refused(scene + "boundary.floor.control=\\'fixed\\'", "scene.toml:", "set the control that uses it");
  refused(scene + "spectrum.linear.fewest_contacts=9 --by linear", "no body is held",
          "compress the packing, or give a fewest_contacts below 9");
  const Workspace without;
  check_refused(without, without.scree("spectrum scene.toml --out out"), "scene.toml: has no [spectrum]",
                "from_hz, to_hz and step_hz");
}

TEST_CASE("a spectrum of too few frequencies for peaks says so", "[tools]") {
  const Workspace w(chain);
  const Outcome outcome = w.scree("spectrum scene.toml --by linear --out out --set spectrum.step_hz=20");
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.find(
            "particles.z_8: no peaks, which need 16 frequencies or more; give a smaller step_hz\n") !=
        std::string::npos);
}

TEST_CASE("a scenario of a spectrum without stages is checked, but not run", "[tools]") {
  const Workspace w(chain);
  const Outcome checked = w.scree("check scene.toml");
  CHECK(checked.status == 0);
  CHECK(checked.out.find("spectrum: 281 frequencies from 20 to 160 Hz") != std::string::npos);
  check_refused(w, w.run(), "scene.toml: the scenario says nothing of how long it lasts",
                "or run scree spectrum with it");
  check_refused(w, w.scree("accuracy scene.toml --out out"),
                "scene.toml: the scenario says nothing of how long", "or run scree spectrum with it");
}

TEST_CASE("a misspelt table of a study is named, not the duration that it replaces", "[tools]") {
  std::string text = chain;
  for (std::size_t at; (at = text.find("\n[spectrum")) != std::string::npos;)
    text.replace(at, 10, "\n[spectrm");
  const Workspace w(text);
  const Outcome outcome = w.run();
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("unknown key 'spectrm' in the file; did you mean 'spectrum'?") != std::string::npos);
}

TEST_CASE("run and check read the table of a study that they do not use", "[tools]") {
  const Workspace w(
      with(chain, "ids = [1, 8]", "ids = [1, 8]\nevery = 1e-3") +
      "[[expect]]\nrequirement = 'r'\nquantity = 'peaks.linear.particles.z_8.peak_1.frequency'\n"
      "at_least = 1\n");
  for (const char* verb : {"run scene.toml --out out", "check scene.toml"})
    check_refused(w, w.scree(std::string(verb) + " --set time.duration=0.01 --set spectrum.sweep.priods=9"),
                  "--set spectrum.sweep.priods=9: unknown key 'priods' in [spectrum.sweep]",
                  "did you mean 'periods'? known keys: direction, periods, analysed_periods, "
                  "samples_per_period, rise_periods, detrend, adaptive, tolerance");
  REQUIRE(w.scree("run scene.toml --out out --quiet --set time.duration=0.01").status == 0);
  const Outcome longer = w.scree("resume out --quiet --until 0.02");
  INFO(longer.err);
  CHECK(longer.status == 0);
}

TEST_CASE("resume of a spectrum changes nothing about it", "[tools]") {
  const Workspace w(chain);
  REQUIRE(w.scree("spectrum scene.toml --by linear --out out --quiet").status == 0);
  const std::string table = w.text("out/spectrum.csv");
  const auto refused = [&](const std::string& arguments, const char* problem) {
    const Outcome outcome = w.scree(arguments);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(problem) != std::string::npos);
  };
  refused("resume out --until 1", "out: holds a spectrum, which goes on as it began; give no --set, --until");
  refused("resume out", "out: the spectrum is finished; give --overwrite");
  refused("spectrum scene.toml --out out", "out: already contains a spectrum; give another --out");
  CHECK(w.text("out/spectrum.csv") == table);
  // Nor does an overwriting spectrum that is refused.
  const std::string over = "spectrum scene.toml --by linear --out out --quiet --overwrite";
  refused(over + " --set spectrum.observe=[\\'particles.x_1\\']", "'particles.x_1' does not respond");
  CHECK(w.text("out/spectrum.csv") == table);
  const std::string staged = " --set time.duration=1e-3 --set probe.every=1e-3";
  refused(over + staged + " --set spectrum.observe=[\\'particles.x_1\\']",
          "'particles.x_1' does not respond");
  CHECK(w.text("out/spectrum.csv") == table);
  CHECK(w.scree(over + staged).status == 0);
  CHECK(w.scree(over).status == 0);
  w.write("out/spectrum.json", "{\"status\": 5}");
  refused("resume out", "out: no saved state to resume the spectrum from; give --overwrite");
}

TEST_CASE("a spectrum that does not meet an expectation says so and fails", "[tools]") {
  const std::string expect =
      "[[expect]]\nrequirement = \"The second mode\"\nquantity = \"peaks.linear.particles.z_8.peak_1.frequency\"\n"
      "tolerance = 0.01\nreference = ";
  const std::string linear = "spectrum scene.toml --by linear --out out " + peak;
  const Workspace right(chain + expect + "87.11\n");
  const Outcome met = right.scree(linear);
  INFO(met.err << met.out);
  CHECK(met.status == 0);
  CHECK(met.out.find("met      The second mode (peaks.linear.particles.z_8.peak_1.frequency = 87.1") !=
        std::string::npos);
  const Workspace wrong(chain + expect + "88\n");
  const Outcome unmet = wrong.scree(linear + "--quiet");
  CHECK(unmet.status == 1);
  CHECK(unmet.out.find("NOT MET  The second mode") != std::string::npos);
  CHECK(nlohmann::json::parse(wrong.text("out/spectrum.json"))["expect"][0]["met"] == false);
}
