#include "cycled_discs.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/quasi_static/follow.hpp>
#include <scree/run/set_up.hpp>
#include <scree/stage.hpp>
#include <scree/state_file/state_file.hpp>
#include <scree/state_transfer.hpp>

// What is written of a load that is followed through states of equilibrium.

namespace scree::test {

namespace {

// Rows of a series by columns, without the line of names.
std::vector<std::vector<double>> rows_of(const std::filesystem::path& file) {
  std::istringstream text(text_of(file));
  std::vector<std::vector<double>> rows;
  std::string line, cell;
  std::getline(text, line);
  while (std::getline(text, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

constexpr std::size_t time_column = 0, strain_xx = 5, strain_yy = 6;

}  // namespace

// Packing 5: a load that jumps, which sets it in motion. What is left of the motion is not dropped before it
// is at rest.
TEST_CASE("a packing that moves goes on by dynamics until it is at rest") {
  const std::vector<std::string> jump = {"scene.seed=5", "stage.cycles.cycles=2", "time.step=1e-3",
                                         "stage.cycles.set.box.stress_y_high.from=5",
                                         "stage.cycles.set.box.stress_y_high.to=5.01"};
  const TemporaryFolder folder;
  const scenario::Plan plan =
      scenario::read_plan(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml", jump, host());
  const quasi_static::FollowedLoad load = quasi_static::follow(plan, {.out = folder / "out"});
  CHECK(std::any_of(load.warnings.begin(), load.warnings.end(), [](const std::string& warning) {
    return warning.find("dynamics followed the load for ") != std::string::npos;
  }));
  const auto rows = rows_of(folder / "out/series/quasi_static.csv");
  const auto simulation = run::set_up(plan);
  StageRunner stages(*simulation, plan.stages);
  while (stages.current() + 1 < plan.stages.size()) stages.run(1000, [] { return true; });
  const double length_x = simulation->planes()[1].point[0] - simulation->planes()[0].point[0];
  while (!stages.finished()) stages.run(1000, [] { return true; });
  const double moved = simulation->planes()[1].point[0] - simulation->planes()[0].point[0];
  // E_kin < 1e-6 E_el: what is dropped moves bodies by the root of it, 1e-3, times the overlaps, some 1e-2 of
  // the strain of a body.
  CHECK(rows.back()[strain_xx] == Approx(1 - moved / length_x).margin(1e-5));
}

TEST_CASE("a quasi-static load that is interrupted says how far it came") {
  const TemporaryFolder folder;
  std::atomic<bool> stop = false;
  const quasi_static::FollowedLoad load = quasi_static::follow(
      cycled_discs("12"),
      {.out = folder / "out",
       .increments = 20,
       .on_progress = [&](double share, double, const std::string&) { stop = share > 0.3; },
       .stop = &stop});
  CHECK(load.interrupted);
  CHECK(load.reached > load.start);
  CHECK(load.reached < load.end);
  const auto rows = rows_of(folder / "out/series/quasi_static.csv");
  REQUIRE(rows.size() > 5);
  CHECK(rows.back()[time_column] == load.reached);
  const auto record = nlohmann::json::parse(text_of(folder / "out/quasi_static.json"));
  CHECK(record["status"] == "interrupted");
  CHECK(record["end"] == load.reached);
  CHECK(record["planned_end"] == load.end);
  CHECK_THAT(message([&] { quasi_static::follow(cycled_discs("12"), {.out = folder / "out"}); }),
             Catch::Contains("already contains a quasi-static load; go on with it: scree resume " +
                             (folder / "out").string() + ", or give another --out"));
  // With those to the balance at the start, from the stages before and from the state of the first cycle, and
  // those that ended at events.
  CHECK(record["increments"] >= rows.size() + 1);
}

TEST_CASE("a quasi-static load keeps states as [checkpoint] says") {
  // Of intervals 1 to 16 those after 8 and 16 end a part; at 16 all is done.
  const auto [every, kept] =
      GENERATE(table<std::string, std::int64_t>({{"'1e-9 s'", 8}, {"'10 min'", 0}, {"'never'", -1}}));
  CAPTURE(every);
  const TemporaryFolder folder;
  const scenario::Plan plan =
      scenario::read_plan(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml",
                          {"scene.seed=12", "stage.cycles.cycles=2", "time.step=1e-3",
                           "checkpoint.every=" + every, "checkpoint.final_state=false"},
                          host());
  std::int64_t found = -1;
  quasi_static::follow(
      plan,
      {.out = folder / "out", .increments = 8, .on_progress = [&](double, double, const std::string&) {
         if (!std::filesystem::exists(folder / "out/state.h5")) return;
         const State state = state_file::read_state(folder / "out/state.h5");
         std::uint64_t intervals = 0;
         StateTransfer::restoring_from(state).below("quasi_static").value("intervals_done", "1", intervals);
         found = std::int64_t(intervals);
       }});
  CHECK(found == kept);
  CHECK_FALSE(std::filesystem::exists(folder / "out/final_state.h5"));
}

TEST_CASE("quasi-static strains count from the balance at the start") {
  const TemporaryFolder folder;
  quasi_static::follow(cycled_discs("12"), {.out = folder / "out", .increments = 8});
  const auto rows = rows_of(folder / "out/series/quasi_static.csv");
  CHECK(rows.front()[strain_xx] == 0);
  CHECK(rows.front()[strain_yy] == 0);
  CHECK(nlohmann::json::parse(text_of(folder / "out/quasi_static.json")).contains("planned_end") == false);
}

TEST_CASE("a quasi-static load that is interrupted before the load writes nothing and says so") {
  const TemporaryFolder folder;
  const std::atomic<bool> stop = true;
  try {
    quasi_static::follow(cycled_discs("12"), {.out = folder / "out", .stop = &stop});
    FAIL("not interrupted");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::interrupted);
    CHECK_THAT(error.what(),
               Catch::Contains("biaxial.toml: interrupted before the stages had ended, and nothing "
                               "was written; run the same command again"));
  }
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace scree::test
