#include "run_support.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/run/run_in_memory.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

namespace {

// Bodies that fall freely from rest, with v = -100 t m/s at every step.
const std::string from_rest = with(discs, "random_velocity = 0.1\n", "") +
                              "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -100]\n"
                              "[[probe]]\nplugin = 'particles'\nids = [2]\nevery = 1e-5\n";

// Rows of numbers of a series, with the stage at the end if there are several.
std::vector<std::vector<double>> rows_of(const Bench& bench, const std::string& probe) {
  std::istringstream text(series_of(bench, probe));
  std::string line, cell;
  std::getline(text, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(text, line)) {
    rows.emplace_back();
    for (std::istringstream row(line); std::getline(row, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

}  // namespace

TEST_CASE("a derived quantity is computed from columns of the same time", "[run]") {
  // The energies are written every two steps, the quantity at each.
  const Bench bench(from_rest +
                    "[derived]\nv = '-particles.vy_2'\n"
                    "m = 'energy.kinetic_translation / (particles.vy_2 ^ 2 / 2)'\n");
  bench.run();
  CHECK(series_of(bench, "derived").starts_with("time [s],v [m/s],m [J s^2/m^2]\n"));
  const auto rows = rows_of(bench, "derived");
  REQUIRE(rows.size() == 11);
  CHECK(rows_of(bench, "energy").size() == 6);
  CHECK(std::isnan(rows[0][2]));  // 0/0
  const double mass = 9 * 1000 * M_PI * 0.01 * 0.01;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    // Round-off of ten additions.
    CHECK(rows[k][1] == Approx(100 * rows[k][0]).epsilon(1e-14));
    CHECK(rows[k][2] == Approx(mass).epsilon(1e-13));
  }
}

TEST_CASE("a stage ends at the step at which a derived quantity passes its bound", "[run]") {
  // (v/100)² passes (4.5e-5 s)² between steps 4 and 5.
  const Bench bench(
      with(from_rest, "duration = 1e-4\n", "") +
      "[derived]\nt2 = '(particles.vy_2 / 100) ^ 2'\n"
      "[[stage]]\nname = 'fall'\nuntil = { 'derived.t2' = { above = 2.025e-9 }, at_most = 1 }\n");
  const RunResult result = bench.run();
  REQUIRE(result.stages.size() == 1);
  CHECK(result.stages[0].steps == 5);
}

TEST_CASE("charts and expectations take derived quantities, with or without files", "[run]") {
  const std::string text =
      from_rest +
      "[derived]\nt = '-particles.vy_2 / 100'\ny = 'particles.y_2 - 0.5 * particles.vy_2 ^ 2 / -100'\n"
      "[[chart]]\nname = 'fall'\nformat = 'svg'\nx = 'derived.t'\ny = 'derived.y'\n"
      "[[expect]]\nrequirement = 'time by speed'\nquantity = 'derived.t.last'\nreference = 1e-4\ntolerance = 1e-17\n"
      "[[expect]]\nrequirement = 'mean'\nquantity = 'derived.t.mean'\nreference = 5e-5\ntolerance = 1e-17\n";
  // m - m/s/(m/s²), where the number 100 has no unit.
  CHECK(refusal(text).find("'-' of the units m and m^2/s^2") != std::string::npos);
  const std::string vouched = with(text, "'particles.y_2 - 0.5 * particles.vy_2 ^ 2 / -100'",
                                   "{ formula = 'particles.y_2 + particles.vy_2 ^ 2 / 200', unit = 'm' }");
  const Bench bench(vouched);
  const RunResult result = bench.run();
  REQUIRE(result.verdicts.size() == 2);
  CHECK(result.verdicts[0].met);
  CHECK(result.verdicts[1].met);
  CHECK(text_of(bench.options.out / "charts/fall.svg").find("svg") != std::string::npos);
  const auto in_memory = run_in_memory(plan_of(vouched), {}).quantities;
  CHECK(in_memory[0] == result.verdicts[0].value);
  CHECK(in_memory[1] == result.verdicts[1].value);
}

TEST_CASE("a derived quantity has no value in stages without what it reads", "[run]") {
  const std::string text =
      two_stages +
      "[[probe]]\nplugin = 'energy'\nname = 'late'\nstages = ['second']\nevery = 1e-5\n"
      "[derived]\na = '2 * energy.kinetic_translation'\nb = '2 * late.kinetic_translation'\n";
  const Bench bench(text);
  bench.run();
  const auto rows = rows_of(bench, "derived");
  REQUIRE(rows.size() == 11);
  for (const std::vector<double>& row : rows) {
    CHECK(row[1] > 0);
    // The row between the stages is of the first.
    if (row[3] == 1)
      CHECK(std::isnan(row[2]));
    else
      CHECK(row[2] == row[1]);
  }
}

TEST_CASE("stages in which no derived quantity has a value have no rows", "[run]") {
  const Bench bench(two_stages +
                    "[[probe]]\nplugin = 'energy'\nname = 'late'\nstages = ['second']\nevery = 1e-5\n"
                    "[derived]\nb = '2 * late.kinetic_translation'\n");
  bench.run();
  const auto rows = rows_of(bench, "derived");
  // From the end of the first stage on.
  REQUIRE(rows.size() == 6);
  CHECK(rows[0][0] == Approx(5e-5));
  for (const std::vector<double>& row : rows) CHECK(row[1] > 0);
}

TEST_CASE("a quantity of probes with different clocks has those of the slower one, at its times", "[run]") {
  // Every third step against every second: neither clock holds the other's times.
  const Bench bench(from_rest +
                    "[[probe]]\nplugin = 'particles'\nname = 'slow'\nids = [2]\nevery = 3e-5\n"
                    "[derived]\nm = '2 * energy.kinetic_translation / slow.vy_2 ^ 2'\n");
  bench.run();
  const auto rows = rows_of(bench, "derived"), slow = rows_of(bench, "slow");
  REQUIRE(rows.size() == slow.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    CHECK(rows[k][0] == slow[k][0]);
    // Round-off of ten additions.
    if (k > 0) CHECK(rows[k][1] == Approx(9 * 1000 * M_PI * 0.01 * 0.01).epsilon(1e-13));
  }
}

TEST_CASE("derived quantities change no bit of a run, and have the same with more threads", "[run]") {
  const Bench plain(from_rest);
  Bench derived(from_rest + "[derived]\na = 'sin(energy.kinetic_translation) ^ 1.5'\n");
  Bench parallel(from_rest + "[derived]\na = 'sin(energy.kinetic_translation) ^ 1.5'\n");
  parallel.options.threads = 2;
  const std::uint64_t hash = plain.run().state_hash;
  CHECK(derived.run().state_hash == hash);
  CHECK(parallel.run().state_hash == hash);
  CHECK(series_of(derived, "derived") == series_of(parallel, "derived"));
}
