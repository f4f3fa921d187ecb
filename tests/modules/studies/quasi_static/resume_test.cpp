#include "cycled_discs.hpp"
#include "foreign_state.hpp"

#include <atomic>
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/error.hpp>
#include <scree/quasi_static/follow.hpp>

// Loads that go on, also from states with a right seal that others have changed.

using namespace scree;
using namespace scree::test;

TEST_CASE("a state of a quasi-static load that does not fit is refused, and nothing is changed") {
  const TemporaryFolder folder;
  const scenario::Plan plan = cycled_discs("12");
  std::atomic<bool> stop = false;
  quasi_static::FollowOptions options = {
      .out = folder / "out",
      .increments = 20,
      .on_progress = [&](double share, double, const std::string&) { stop = share > 0.6; },
      .stop = &stop};
  REQUIRE(quasi_static::follow(plan, options).interrupted);
  options.on_progress = {};
  const std::filesystem::path file = folder / "out/state.h5";
  const std::string sound = text_of(file), record = text_of(folder / "out/quasi_static.json");
  const auto refused = [&](const auto& change) {
    folder.write("out/state.h5", sound);
    change();
    const std::string line = message([&] { quasi_static::resume_following(options, host()); });
    CHECK(line.find("; ") != std::string::npos);
    CHECK(text_of(folder / "out/quasi_static.json") == record);
    return line;
  };
  for (const std::string path :
       {"quasi_static/charted", "quasi_static/warnings", "walls/planes/point", "start/position"})
    CHECK_THAT(refused([&] { remove_array(file, path); }),
               Catch::StartsWith(file.string() + ": the state has no '" + path + "'; "));
  CHECK(refused([&] {
          change_state(file, "quasi_static/hand_overs/from", [](StateArray& array) {
            std::get<std::vector<double>>(array.values).push_back(1);
            array.shape = {array.size()};
          });
        }).find("hand_overs/to") != std::string::npos);
  CHECK(refused([&] { change_state(file, "quasi_static/charted", shorten); }).find("instead of") !=
        std::string::npos);
  CHECK(refused([&] {
          change_number(file, "quasi_static/intervals_between_states", 0, std::uint64_t(0));
        }).find("is 0") != std::string::npos);
  CHECK(refused([&] { change_number(file, "quasi_static/intervals_done", 0, ~std::uint64_t(0)); }) !=
        "no error");
  for (const double wrong : {0.0, -1.0, 1e-300, double(NAN)})
    refused([&] { change_number(file, "quasi_static/increment", 0, wrong); });
  CHECK(refused([&] {
          change_number(file, "bodies/position", 0, double(INFINITY));
        }).find("bodies/position") != std::string::npos);
  CHECK(refused([&] {
          State state = state_file::read_state(file);
          state.put("quasi_static/moves", {std::vector<std::uint8_t>{1}, {}, "1"});
          for (const char* path : {"quasi_static/hand_overs/from", "quasi_static/hand_overs/to"})
            state.put(path, {std::vector<double>{}, {0}, "s"});
          state_file::write_state(file, state);
        }).find("has none") != std::string::npos);
}

TEST_CASE("a quasi-static load that is interrupted goes on to the same bits") {
  // Packing 13 has no equilibrium nearby in a part of its cycles.
  const std::string seed = GENERATE("12", "13");
  const TemporaryFolder folder;
  const scenario::Plan plan = cycled_discs(seed);
  const quasi_static::FollowedLoad whole =
      quasi_static::follow(plan, {.out = folder / "whole", .increments = 20});
  const double stop_at = GENERATE(0.1, 0.4, 0.7, 0.97);
  CAPTURE(seed, stop_at);
  std::atomic<bool> stop = false;
  quasi_static::FollowOptions options = {
      .out = folder / "parted",
      .increments = 20,
      .on_progress = [&](double share, double, const std::string&) { stop = share > stop_at; },
      .stop = &stop};
  REQUIRE(quasi_static::follow(plan, options).interrupted);
  stop = false;
  options.on_progress = {};
  const quasi_static::FollowedLoad second = quasi_static::resume_following(options, host());
  CHECK_FALSE(second.interrupted);
  CHECK(second.hand_overs.size() == whole.hand_overs.size());
  CHECK(second.dynamic_steps == whole.dynamic_steps);
  CHECK(second.increments == whole.increments);
  CHECK(second.events == whole.events);
  for (const char* part : {"whole", "parted"})
    CHECK_FALSE(std::filesystem::exists(folder / part / "state.h5"));
  const auto end = [&](const char* part) { return state_file::read_state(folder / part / "final_state.h5"); };
  CHECK(end("parted") == end("whole"));
  CHECK(text_of(folder / "parted/series/quasi_static.csv") ==
        text_of(folder / "whole/series/quasi_static.csv"));
  CHECK_THAT(message([&] { quasi_static::resume_following(options, host()); }),
             Catch::Contains("parted: the quasi-static load is finished; give --overwrite"));
}

TEST_CASE(
    "a quasi-static load that goes on restores its scenario, and changes nothing if its state does not fit") {
  const TemporaryFolder folder;
  std::atomic<bool> stop = false;
  std::vector<std::string> warnings;
  quasi_static::FollowOptions options = {
      .out = folder / "out",
      .increments = 20,
      .on_progress = [&](double share, double, const std::string&) { stop = share > 0.3; },
      .on_warning = [&](const std::string& line) { warnings.push_back(line); },
      .stop = &stop};
  REQUIRE(quasi_static::follow(cycled_discs("12"), options).interrupted);
  stop = false;
  options.on_progress = {};
  const std::string began = text_of(folder / "out/scenario.toml"),
                    record = text_of(folder / "out/quasi_static.json");
  const State good = state_file::read_state(folder / "out/state.h5");
  State bad = good;
  StateArray integrator = good.at("scene/integrator");
  std::get<std::vector<std::string>>(integrator.values).at(0) = "another";
  bad.put("scene/integrator", integrator);
  state_file::write_state(folder / "out/state.h5", bad);
  try {
    quasi_static::resume_following(options, host());
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::bad_input);
  }
  CHECK(text_of(folder / "out/quasi_static.json") == record);
  state_file::write_state(folder / "out/state.h5", good);
  CHECK(warnings.empty());
  folder.write("out/scenario.toml", with(began, "seed = 12", "seed = 13"));
  CHECK_FALSE(quasi_static::resume_following(options, host()).interrupted);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Catch::Contains("out/scenario.toml: is not the scenario with which these results began"));
  CHECK(text_of(folder / "out/scenario.toml") == began);
}

TEST_CASE("a quasi-static load without period is kept in parts too") {
  const TemporaryFolder folder;
  const std::string biaxial = text_of(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml");
  const auto file =
      folder.write("ramp.toml", with(biaxial, "cycles = 100\nperiod = 10  #", "duration = 10  #"));
  const scenario::Plan plan = scenario::read_plan(file, {"scene.seed=12", "time.step=1e-3"}, host());
  std::atomic<bool> stop = false;
  quasi_static::FollowOptions options = {
      .out = folder / "parted",
      .increments = 100,
      .on_progress = [&](double share, double, const std::string&) { stop = share >= 0.6; },
      .stop = &stop};
  CHECK(quasi_static::follow(plan, options).interrupted);
  stop = false;
  double first = 0;
  options.on_progress = [&](double share, double, const std::string&) { first = first > 0 ? first : share; };
  quasi_static::resume_following(options, host());
  CHECK(first == Approx(0.41));  // after the last part of 40 increments
  quasi_static::follow(plan, {.out = folder / "whole", .increments = 100});
  CHECK(text_of(folder / "parted/series/quasi_static.csv") ==
        text_of(folder / "whole/series/quasi_static.csv"));
}

TEST_CASE("a quasi-static load that goes on and fails records the cure for its place") {
  const TemporaryFolder folder;
  std::atomic<bool> stop = false;
  quasi_static::FollowOptions options = {
      .out = folder / "out",
      .increments = 8,
      .on_progress = [&](double share, double, const std::string&) { stop = share > 0.3; },
      .stop = &stop};
  REQUIRE(quasi_static::follow(cycled_discs("12"), options).interrupted);
  stop = false;
  options.on_progress = {};
  folder.write("out/final_state.h5", "of another");
  const std::string line = "final_state.h5: is there and was not written by a run; move it elsewhere";
  CHECK_THROWS_WITH(quasi_static::resume_following(options, host()), Catch::EndsWith(line));
  const auto record = nlohmann::json::parse(text_of(folder / "out/quasi_static.json"));
  CHECK(record["status"] == "failed");
  CHECK_THAT(std::string(record["error"]), Catch::EndsWith(line));
  std::filesystem::remove(folder / "out/final_state.h5");
  CHECK_FALSE(quasi_static::resume_following(options, host()).interrupted);
}
