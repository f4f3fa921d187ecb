#include "foreign_state.hpp"

#include "plan_support.hpp"

#include <atomic>

#include <catch2/catch.hpp>

#include <scree/quasi_static/follow.hpp>

// States of quasi-static loads with a right seal that others have changed.

using namespace scree;
using namespace scree::test;

TEST_CASE("a state of a quasi-static load that does not fit is refused, and nothing is changed") {
  const TemporaryFolder folder;
  const scenario::Plan plan =
      scenario::read_plan(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml",
                          {"scene.seed=12", "stage.cycles.cycles=2", "time.step=1e-3"}, host());
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
       {"quasi_static/strains", "quasi_static/warnings", "walls/planes/point", "start/position"})
    CHECK_THAT(refused([&] { remove_array(file, path); }),
               Catch::StartsWith(file.string() + ": the state has no '" + path + "'; "));
  CHECK(refused([&] {
          change_state(file, "quasi_static/hand_overs/from", [](StateArray& array) {
            std::get<std::vector<double>>(array.values).push_back(1);
            array.shape = {array.size()};
          });
        }).find("hand_overs/to") != std::string::npos);
  CHECK(refused([&] { change_state(file, "quasi_static/strains", shorten); }).find("instead of") !=
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
