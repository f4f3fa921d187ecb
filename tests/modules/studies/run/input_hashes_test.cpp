#include "run_support.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/files/content_hash.hpp>

using namespace scree;
using test::Bench;

namespace {

namespace fs = std::filesystem;

nlohmann::json json_of(const Bench& bench) {
  return nlohmann::json::parse(test::text_of(bench.options.out / "run.json"));
}

// Goes on with a finished run for ten more steps.
run::RunResult prolong(const Bench& bench, PluginHost& host, double until) {
  run::ResumeChanges changes;
  changes.until = until;
  return run::resume_run(bench.options, changes, host);
}

}  // namespace

TEST_CASE("run.json has the hashes of what was read", "[run]") {
  const Bench bench;
  bench.run();
  const auto inputs = json_of(bench)["inputs"];
  CHECK_FALSE(inputs.contains("bodies"));
  CHECK(inputs["plugins"].size() == 3);
  for (const char* name : {"contact/linear_spring_dashpot", "boundary/box", "probe/energy"})
    CHECK(inputs["plugins"][name] ==
          files::file_hash(fs::path(SCREE_TEST_PLUGINS) / (name + std::string(".so"))));
  // One that begins from its state.
  std::string scene = test::discs;
  for (const char* key : {"radius = 0.01\n", "random_velocity = 0.1\n"}) scene = test::with(scene, key, "");
  scene = test::with(scene, "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }",
                     "state = 'out/final_state.h5'");
  run::RunOptions options;
  options.out = bench.folder / "branch";
  const auto result =
      run::run_plan(scenario::read_plan(bench.folder.write("branch.toml", scene), {}, test::host()), options);
  CHECK(result.inputs.bodies == files::file_hash(bench.options.out / "final_state.h5"));
  CHECK(result.inputs.plugins.size() == 3);
}

TEST_CASE("a run that goes on keeps the hashes of its start, and tells of plug-ins that were built again",
          "[run]") {
  Bench bench;
  std::vector<std::string> told;
  bench.options.on_warning = [&](const std::string& line) { told.push_back(line); };
  bench.run();
  const auto inputs = json_of(bench)["inputs"];
  prolong(bench, test::host(), 2e-4);
  CHECK(json_of(bench)["inputs"] == inputs);
  CHECK(told.empty());
  const test::TemporaryFolder plugins;
  fs::copy(SCREE_TEST_PLUGINS, plugins.path(), fs::copy_options::recursive);
  std::ofstream(plugins / "boundary/box.so", std::ios::binary | std::ios::app) << "built again";
  PluginHost other({plugins.path()});
  prolong(bench, other, 3e-4);
  CHECK(json_of(bench)["inputs"]["plugins"]["boundary/box"] == "several");
  CHECK(json_of(bench)["inputs"]["plugins"]["probe/energy"] == inputs["plugins"]["probe/energy"]);
  REQUIRE(told.size() == 1);
  CHECK(
      told[0] ==
      "the library of the plug-in boundary/box is not that with which the run began; run the scenario again if its "
      "results may differ");
  CHECK(json_of(bench)["warnings"].back() == told[0]);
  // It remains the run of neither library, and is told once.
  prolong(bench, test::host(), 4e-4);
  CHECK(json_of(bench)["inputs"]["plugins"]["boundary/box"] == "several");
  CHECK(told.size() == 1);
}
