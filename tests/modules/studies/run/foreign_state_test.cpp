#include "foreign_state.hpp"

#include "run_support.hpp"

#include <catch2/catch.hpp>

#include <scree/error.hpp>

// States with a right seal that others have changed.

using namespace scree;
using namespace scree::run;
using namespace scree::test;

namespace {

const std::string probed = std::string(discs) +
                           "[[probe]]\nplugin = 'particles'\nids = [2, 5]\nevery = 1e-5\n"
                           "[[probe]]\nplugin = 'touching'\nids = [3]\nevery = 1e-5\n"
                           "[[probe]]\nplugin = 'mean_squared_displacement'\nids = [1, 9]\nevery = 1e-5\n";

struct Stopped : Bench {
  std::filesystem::path state = options.out / "checkpoint/step_000000000000005.h5";

  Stopped() : Bench(probed, {"checkpoint.every_time=5e-5", "checkpoint.final_state=false"}) {
    run();
    std::filesystem::remove(options.out / "checkpoint/step_000000000000010.h5");
  }
  std::string series(const std::string& name) const {
    return text_of(options.out / "series" / (name + ".csv"));
  }
};

}  // namespace

TEST_CASE("the bodies of a probe are found again if a state has other indices for them", "[run]") {
  const Stopped bench;
  const std::string particles = bench.series("particles"), touching = bench.series("touching"),
                    displacement = bench.series("mean_squared_displacement");
  const double wrong = GENERATE(1e16, -1.0, 9.0, 10.0, double(NAN), double(INFINITY));
  change_number(bench.state, "run/probes/1/state", 0, wrong);
  change_number(bench.state, "run/probes/2/state", 3, wrong);
  change_number(bench.state, "run/probes/3/state", 5 + 3 * 2 + 1, wrong);
  resume_run(bench.options, {}, host());
  CHECK(bench.series("particles") == particles);
  CHECK(bench.series("touching") == touching);
  CHECK(bench.series("mean_squared_displacement") == displacement);
}

TEST_CASE("a state of a run that does not tell its step is passed over by name", "[run]") {
  Stopped bench;
  std::vector<std::string> warnings;
  bench.options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  remove_array(bench.state, "clock/steps");
  CHECK_THAT(message([&] { resume_run(bench.options, {}, host()); }),
             Catch::EndsWith("none of its states can be read; run the scenario again"));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::StartsWith(bench.state.string() + ": the state has no 'clock/steps'; "));
}

TEST_CASE("a state of a run that does not fit is refused, and nothing is changed", "[run]") {
  const Stopped bench;
  const std::string record = text_of(bench.options.out / "run.json");
  const auto refused = [&](const auto& change) {
    const std::string before = text_of(bench.state);
    change();
    const std::string line = message([&] { resume_run(bench.options, {}, host()); });
    bench.folder.write("out/checkpoint/step_000000000000005.h5", before);
    CHECK(line.find("; ") != std::string::npos);
    return line;
  };
  for (const char* array : {"bodies/velocity", "walls/planes/point", "clock/time", "run/stages/began"})
    CHECK(refused([&] { change_number(bench.state, array, 0, double(INFINITY)); }).find(array) !=
          std::string::npos);
  for (const std::string path :
       {"run/probes/2/state", "run/scenario", "run/stages/stage", "bodies/radius", "bodies/velocity"})
    CHECK_THAT(refused([&] { remove_array(bench.state, path); }),
               Catch::StartsWith(bench.state.string() + ": the state has no '" + path + "'; "));
  CHECK(refused([&] {
          change_state(bench.state, "run/probes/2/state", shorten);
        }).find("has 3 numbers instead of 4") != std::string::npos);
  CHECK(refused([&] {
          change_number(bench.state, "run/stages/stage", 0, std::uint64_t(9));
        }).find("from 0 to 1") != std::string::npos);
  refused([&] { change_number(bench.state, "run/scenario", 0, with(probed, "duration = 1e-4\n", "")); });
  CHECK(text_of(bench.options.out / "run.json") == record);
}
