#include "foreign_state.hpp"

#include "bench.hpp"

#include <catch2/catch.hpp>

// States of measurements with a right seal that others have changed.

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

TEST_CASE("a state of a measurement that does not fit is refused, and nothing is changed", "[spectrum]") {
  Bench bench(Chain().text(
      "from_hz = 100\nto_hz = 110\nstep_hz = 2\nsweep.periods = 400\nsweep.analysed_periods = 6\nlinear.fewest_contacts = 1\n"));
  bench.options.methods = {Method::linear, Method::sweep};
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](double share, double, const std::string& what) {
    stop = share > 0.2 && what.starts_with("sweep");
  };
  REQUIRE(measure(bench.plan, bench.options).interrupted);
  bench.options.on_progress = {};
  const std::filesystem::path file = bench.options.out / "state.h5";
  const std::string sound = text_of(file), record = bench.text("spectrum.json");
  const auto refused = [&](const auto& change) {
    bench.folder.write("out/state.h5", sound);
    change();
    const std::string line = message([&] { resume_measurement(bench.options, host()); });
    CHECK(line.find("; ") != std::string::npos);
    CHECK(bench.text("spectrum.json") == record);
    return line;
  };
  const auto shortened = [&](const char* path) {
    return refused([&] { change_state(file, path, shorten); });
  };
  for (const std::string path :
       {"spectrum/asked", "spectrum/sweep/walls/motion", "clock/time", "bodies/radius"})
    CHECK_THAT(refused([&] { remove_array(file, path); }),
               Catch::StartsWith(file.string() + ": the state has no '" + path + "'; "));
  for (const char* path : {"motion", "at_rest"})
    CHECK(shortened((std::string("spectrum/sweep/walls/") + path).c_str()).find("does not have") !=
          std::string::npos);
  CHECK(refused([&] {
          change_state(file, "spectrum/sweep/walls/at_rest", [](StateArray& array) {
            array.values = std::vector<double>{};
            array.shape = {0};
          });
        }).find("does not have a vector for each wall") != std::string::npos);
  for (const char* path :
       {"spectrum/sweep/0/columns", "spectrum/road_0/0/response", "spectrum/road_0/0/error",
        "spectrum/road_0/frequencies", "spectrum/sweep/observer/0/state"})
    shortened(path);
  CHECK(refused([&] {
          change_number(file, "spectrum/sweep/frequencies", 1, 101.5);
        }).find("are not those of the scenario") != std::string::npos);
  CHECK(refused([&] {
          change_number(file, "spectrum/sweep/0/frequency", 0, 102.0);
        }).find("is not that of the sweep there") != std::string::npos);
  for (const char* path : {"spectrum/count", "spectrum/sweep/points", "spectrum/road_0/columns"})
    refused([&] { change_number(file, path, 0, std::uint64_t(1) << 60); });
  CHECK(refused([&] {
          const std::string plain = with(Chain().text(""), "[spectrum]\n", "[spectrum_of_none]\n");
          change_number(file, "spectrum/scenario", 0, plain.substr(0, plain.find("[spectrum_of_none]")));
        }) != "no error");
}
