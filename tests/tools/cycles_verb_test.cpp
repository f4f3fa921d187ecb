#include "cycles_workspace.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>

using scree::test::check_refused;
using scree::test::series_of_cycles;
using scree::test::Workspace;
using scree::test::write_run;

TEST_CASE("cycles of a run takes the series with the lengths and the period of its stage", "[tools]") {
  const Workspace w;
  write_run(w, "run");
  const auto outcome = w.scree("cycles run --load stress");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.starts_with(
      "run/series/box.csv: length_y/length_y0 - length_x/length_x0, 60 cycles of 2 s from 1.5 s, 29 dropped\n"));
  CHECK(outcome.out.find("\nclass         ratcheting: ") != std::string::npos);
  const auto record = w.record("run", "cycles.json");
  CHECK(record["class"] == "ratcheting");
  CHECK(record["cycles"] == 60);
  // L_0 is the length at cycle 29, which is 1 + 29e-6 of the first; round-off of the lengths over 31 cycles.
  CHECK(double(record["fit"]["slope"]) == Approx(1e-6 / (1 + 29e-6)).epsilon(1e-8));
  const std::string table = w.text("run/cycles.csv");
  CHECK(table.starts_with(
      "cycle,time [s],length_y/length_y0 - length_x/length_x0,fit,outlier,loop_area,stiffness\n0,1.5,"));
  CHECK(table.find("\n29,59.5,0,") != std::string::npos);
  CHECK(w.has("run/cycles.png"));
}

TEST_CASE("cycles of a file takes a column, a period and a load", "[tools]") {
  const Workspace w;
  w.write("box.csv", series_of_cycles());
  const auto outcome =
      w.scree("cycles --csv box.csv --strain strain --load stress --period 2 --drop 40 --out out");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  // The polygon of 8 points on an ellipse of 1e-3 and 1; the strain leads, so that the area is negative. The
  // drift of 1e-6 skews it by as little.
  const double polygon = std::numbers::pi * 1e-3 * std::sin(std::numbers::pi / 4) / (std::numbers::pi / 4);
  CHECK(outcome.out.find(fmt::format("mean area {:.3g}", -polygon).substr(0, 15)) != std::string::npos);
  CHECK(w.record("out", "cycles.json")["load"] == "stress [Pa]");
}

TEST_CASE("cycles without a period takes each row for a cycle", "[tools]") {
  const Workspace w;
  std::string text = "time,x\n";
  for (int k = 0; k < 60; ++k) text += fmt::format("{},{}\n", 10 * k, k == 50 ? 1 : 1e-9 * (k % 2));
  w.write("x.csv", text);
  const auto outcome = w.scree("cycles --csv x.csv --strain x");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.starts_with("x.csv: x, 59 cycles from 0 s, 29 dropped\n"));
  CHECK(w.record(".", "cycles.json")["class"] == "periodic");
  CHECK(w.record(".", "cycles.json")["repeats_after"] == 2);
  CHECK(w.record(".", "cycles.json")["outliers"] == std::vector<int>{50});
}

TEST_CASE("cycles with the touches of bodies names rattlers and their touches before outliers", "[tools]") {
  const Workspace w;
  std::filesystem::create_directories(w / "run/series");
  std::string
      lengths = "time,length_x,length_y\n",
      touching = "time,observations,touched_12,last_touch_12,touched_3,last_touch_3,touched_4,last_touch_4\n";
  // In each cycle of a hundred observations body 3 always touches, body 4 once, 9 s before the minimum; body
  // 12 once in every tenth cycle, 8 s before the minimum, or 0.5 s before that at 500 s, whose strain is off.
  double touched = 0, last = 0;
  for (int k = 0; k <= 60; ++k) {
    const int t = 10 * k;
    if (k % 10 == 0) touched += 1, last = t - (k == 50 ? 0.5 : 8);
    lengths += fmt::format("{},1,{}\n", t, k == 50 ? 1.001 : 1 + 1e-9 * (k * k % 7));
    touching += fmt::format("{},{},{},{},{},{},{},{}\n", t, 100 * k, touched, last, 100 * k, t, k, t - 9);
  }
  w.write("run/series/load.csv", lengths);
  w.write("run/series/touching.csv", touching);
  const auto outcome = w.scree("cycles run --touching touching --period 10 --start 0");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.status == 0);
  // From cycle 29 to 60 those of 30, 40, 50, 60: 4 of 3100 observations.
  CHECK(
      outcome.out.find(
          "rattlers      body 4 (touches in 1 % of the observations), body 12 (touches in 0.13 % of the observations)\n"
          "last touch    outliers: 0.5 s before the minimum (median of 1; 0.5 to 0.5 s)\n"
          "              other cycles: 9 s before the minimum (median of 31; 8 to 9 s)\n") !=
      std::string::npos);
  CHECK(outcome.out.find("              cycle 50: body 12 0.5 s before its minimum\n") != std::string::npos);
  CHECK(w.record("run", "cycles.json")["rattlers"][1]["id"] == 12);
  CHECK(w.text("run/cycles.csv").find("\n50,500,") != std::string::npos);
  CHECK(w.text("run/cycles.csv").find(",1,12,0.5\n") != std::string::npos);

  check_refused(w, w.scree("cycles run --out out --touching load --period 10 --start 0"),
                "run/series/load.csv: there is no column touched_<id>", "of the kind touching");
  w.write("run/series/touching.csv", touching.substr(0, touching.find("\n300,") + 1));
  check_refused(w, w.scree("cycles run --out out --touching touching --period 10 --start 0"),
                "run/series/touching.csv: there is no row at 300 s", "`stages` that of the load");
}

TEST_CASE("cycles of a creep and of a line behind a settling part writes their laws", "[tools]") {
  const Workspace w;
  std::string text = "time,creep,late\n";
  for (int k = 0; k < 272; ++k)
    text += fmt::format("{},{},{}\n", k, 1e-4 * std::sqrt(k + 1), 1e-5 * k - 1e-3 * std::exp(-k / 5.0));
  w.write("x.csv", text);
  REQUIRE(w.scree("cycles --csv x.csv --strain creep --drop 0 --out creep").status == 0);
  const auto creep = w.record("creep", "cycles.json");
  CHECK(creep["class"] == "creep");
  CHECK(creep["law"]["form"] == "constant + amplitude (1 + k/scale)^exponent");
  CHECK(double(creep["law"]["exponent"]) == Approx(0.5).epsilon(0.01));
  REQUIRE(w.scree("cycles --csv x.csv --strain late --drop 0 --out late").status == 0);
  const auto late = w.record("late", "cycles.json");
  CHECK(late["class"] == "late ratcheting");
  CHECK(late["ratchets"] == true);
  CHECK(late["ratchets_from"] == 24);  // 5 log(100)
  CHECK(double(late["fit_from_there"]["slope"]) == Approx(1e-5).epsilon(1e-3));
}

TEST_CASE("cycles of several runs counts the classes and the signs", "[tools]") {
  const Workspace w;
  write_run(w, "a");
  write_run(w, "b");
  const auto outcome = w.scree("cycles a b/ --out out");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(
      outcome.out.find(
          "2 runs: 0 constant, 2 ratcheting, 0 late ratcheting, 0 periodic, 0 outliers, 0 shakedown, 0 creep, 0 settling, 0 irregular\n"
          "ratcheting: geometric mean of |slope| 9.9997e-07 per cycle; 2 with slopes above 0, 0 below\n") !=
      std::string::npos);
  const std::string table = w.text("out/verdicts.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 3);
  CHECK_FALSE(w.has("a/cycles.csv"));
}

TEST_CASE("cycles takes a ramp that was followed after a cycle for no cycle", "[tools]") {
  using scree::test::with;
  const std::string biaxial = scree::test::text_of(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml");
  const std::string ramp =
      "[[stage]]\nname = 'ramp'\nduration = 300\nset.box.stress_y_high = { from = 1, to = 1.01, duration = 300 }\n";
  const Workspace w(with(biaxial, "[[probe]]", ramp + "[[probe]]"));
  const auto followed =
      w.scree("quasi-static scene.toml --set stage.cycles.cycles=1 --increments 60 --out ramp");
  INFO(followed.out << followed.err);
  REQUIRE(followed.status == 0);
  REQUIRE(w.record("ramp", "quasi_static.json")["period"] == 0);
  check_refused(w, w.scree("cycles ramp --drop 0 --out out"),
                "ramp: the last stage, which was followed, has no period; ", "with --period");
  const auto given = w.scree("cycles ramp --drop 0 --period 10 --out out");
  INFO(given.err);
  CHECK(given.status == 0);
  CHECK(double(w.record("out", "cycles.json")["first_minimum"]) ==
        double(w.record("ramp", "quasi_static.json")["start"]));
  w.write("ramp/quasi_static.json", R"({"start": 0, "end": 1})");
  const auto without = w.scree("cycles ramp");
  CHECK(without.status == 2);
  CHECK(without.err == "scree: ramp/quasi_static.json: has no period; analyse a series with --csv\n");
}

TEST_CASE("cycles refuses what it cannot analyse in one line", "[tools]") {
  const Workspace w;
  w.write("box.csv", series_of_cycles());
  const auto refused = [&](const std::string& arguments, const std::string& begin, const std::string& end) {
    check_refused(w, w.scree("cycles --out out " + arguments), begin, end);
  };
  const std::string strain = "--csv box.csv --strain strain --period 2 ";
  refused("", "neither a run directory nor --csv", "or --csv FILE");
  refused("run --csv box.csv", "--csv analyses a file, not runs", "give one of them");
  refused("run", "run: there is no series/*.csv", "or --csv FILE");
  std::filesystem::create_directories(w / "campaign");
  w.write("campaign/campaign.json", "{}");
  refused("campaign", "campaign: is a campaign; ", "give its runs: campaign/*/");
  refused("--csv box.csv --strain strian --period 2", "box.csv:1:1: there is no column 'strian'",
          "did you mean 'strain'?");
  refused(strain + "--load none", "box.csv: the load is 7 from 1.5 s to 3.5 s: there is no cycle in it; ",
          "or another --period or --start");
  refused(strain + "--load stress --start 2.5", "box.csv: the load is 6 at 2.5 s, ",
          "with --start, and its --period");
  refused(strain + "--drop 50", "box.csv: 60 cycles, the first 50 of which are dropped: too few",
          "give 65 cycles or more, or drop fewer");
  refused(strain + "--start nan", "--start: nan is not a finite number; ", "see scree cycles --help");
  refused(strain + "--start -inf", "--start: -inf is not a finite number; ", "see scree cycles --help");
  for (const std::string drop : {"1e9", "-1", "1000000001", "2.5"})
    refused(strain + "--drop " + drop,
            "--drop: " + drop + " is not a whole number from 0 to 1000000000, in digits; ",
            "see scree cycles --help");
  refused("--csv box.csv --load stress", "box.csv: --load and --start without a period", "give --period");
  w.write("t.csv", "time,x\n0,1\n1,nan\n");
  refused("--csv t.csv --strain x", "t.csv:3:3: ", "the run that wrote this may have failed");
  w.write("t.csv", "time,x\n0,1\n0,2\n");
  refused("--csv t.csv --strain x", "t.csv:3:1: time 0 follows 0", "in the first column");
  write_run(w, "run");
  std::filesystem::create_directories(w / "bare/series");
  refused("run --strain stran",
          (w / "run").filename().string() + "/series: no series has the columns 'stran'", "with --probe");
  w.write("bare/series/energy.csv", "time [s],kinetic [J]\n0,1\n1,1\n");
  for (const char* kinds : {"one", "two"}) {
    CAPTURE(kinds);
    refused("bare", "bare/series: no series has length_x and length_y", "of another strain with --strain");
    w.write("bare/series/contact.csv", "time [s],overlap [m]\n0,1\n1,1\n");
  }
  refused("--csv bare/series/energy.csv", "bare/series/energy.csv: has no length_x and length_y",
          "name the column of the strain with --strain");
  refused("run --probe bax", "run/series/bax.csv: there is no such file", "check the path");
  w.write("run/run.json", R"({"stages": [{"start": 0, "end": 1.5}]})");
  refused("run", "run/run.json: stage 2, which has the period, has not run", "with scree resume");
  w.write("cycles.csv", series_of_cycles());
  const auto own = w.scree("cycles --csv cycles.csv --strain strain --period 2");
  CHECK(own.status == 2);
  CHECK(own.err ==
        "scree: cycles.csv: the cycles would replace this file; give another directory with --out\n");
}
