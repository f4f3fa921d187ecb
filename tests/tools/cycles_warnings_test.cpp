#include "cycles_workspace.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>

using scree::test::Workspace;
using scree::test::write_run;

TEST_CASE("cycles warns of a period that is a multiple of the load's", "[tools]") {
  const Workspace w;
  write_run(w, "run");
  const std::string warning =
      "scree: warning: run/series/box.csv: in each 4 s the load has 2 periods; give --period 2 to see each of its cycles\n";
  // By its load, and by the period of the stage.
  CHECK(w.scree(
             "cycles --csv run/series/box.csv --strain strain --load stress --drop 10 --period 4 --start 1.5")
            .err == warning);
  CHECK(w.scree("cycles run --drop 10 --period 4").err == warning);
  CHECK(w.scree("cycles run --load stress --drop 10 --period 2 --start 1.5").err.empty());
}

TEST_CASE("cycles warns of a period that is not quite the load's", "[tools]") {
  const Workspace w;
  std::string elastic = "time,strain,stress\n";
  for (int k = 0; k <= 480; ++k)
    elastic += fmt::format("{},{},{}\n", 0.25 * k, -1e-3 * std::cos(0.25 * k * std::numbers::pi),
                           5 - std::cos(0.25 * k * std::numbers::pi));
  w.write("box.csv", elastic);
  const std::string command = "cycles --csv box.csv --strain strain --load stress --drop 10 --period ";
  CHECK(w.scree(command + "2").err.empty());
  const auto off = w.scree(command + "2.003");
  INFO(off.err);
  CHECK(off.status == 0);
  CHECK(off.err.starts_with("scree: warning: box.csv: the load at the minima differs by up to "));
  CHECK(off.err.ends_with(
      "; give the exact --period and --start, or more samples, unless the load is meant to change\n"));
  // Met in the middle the differences have no slope; and one sample in a cycle has no loops.
  CHECK(w.scree("cycles --csv box.csv --strain strain --load stress --drop 29 --start 0.073 --period 1.999")
            .err.starts_with("scree: warning: box.csv: the load at the minima "));
  std::string sparse = "time,strain,stress\n";
  for (int k = 0; k < 60; ++k)
    sparse += fmt::format("{},{},{}\n", 1.9995 * k, -1e-3 * std::cos(1.9995 * k * std::numbers::pi),
                          5 - std::cos(1.9995 * k * std::numbers::pi));
  w.write("sparse.csv", sparse);
  CHECK(w.scree("cycles --csv sparse.csv --strain strain --load stress --drop 10 --period 2 --out sparse")
            .err.starts_with("scree: warning: sparse.csv: the load at the minima "));
  // The ratcheting of a stress by its area.
  std::string ratchets = "time,strain,stress\n";
  for (int k = 0; k <= 480; ++k)
    ratchets += fmt::format("{},{},{}\n", 0.25 * k, -1e-3 * std::cos(0.25 * k * std::numbers::pi) + 1e-9 * k,
                            5 - std::cos(0.25 * k * std::numbers::pi) + 1e-8 * k);
  w.write("ratchets.csv", ratchets);
  CHECK(w.scree("cycles --csv ratchets.csv --strain strain --load stress --drop 10 --period 2 --out ratchets")
            .err.empty());
}

TEST_CASE("cycles of a run that did not finish says so", "[tools]") {
  const Workspace w;
  write_run(w, "run");
  const auto said = [&](const std::string& arguments, const std::string& status) {
    const auto outcome = w.scree("cycles run --out out --overwrite " + arguments);
    CHECK(outcome.status == 0);
    CHECK(outcome.err ==
          "scree: warning: run/series/box.csv: the run is " + status + ": these are its cycles so far\n");
  };
  const auto record = [&](const std::string& status, double end, const std::string& ended) {
    w.write("run/run.json",
            fmt::format(R"({{"status": "{}", "stages": [{{"start": 0, "end": 1.5, "ended": "duration"}}, )"
                        R"({{"start": 1.5, "end": {}, "ended": "{}"}}]}})",
                        status, end, ended));
  };
  record("interrupted", 101.5, "interrupted");
  said("", "interrupted");
  // A record that is as old as the beginning of the stage does not hide the rows that are there.
  record("running", 1.5, "running");
  said("", "running");
  record("failed", 101.5, "duration");
  said("", "failed");
  // Without a period each row is a cycle.
  w.write("run/scenario.toml", "[[stage]]\nduration = 121.5\n");
  said("--strain strain", "failed");
  w.write("run/run.json", R"({"status": "finished", "stages": [{"start": 0, "end": 121.5}]})");
  CHECK(w.scree("cycles run --out out --overwrite --strain strain").err.empty());
}
