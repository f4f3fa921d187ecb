#include "checkpoints.hpp"

#include "run_support.hpp"

#include <algorithm>
#include <fstream>

#include <catch2/catch.hpp>

#include <scree/state_file/state_file.hpp>
#include <scree/state_transfer.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

TEST_CASE("a damaged checkpoint is passed over for the one before", "[run]") {
  const Bench bench(two_stages, {"checkpoint.every_time=2e-5", "checkpoint.final_state=false"});
  const RunResult whole = bench.run();
  const std::string energy = series_of(bench, "energy");
  std::vector<std::filesystem::path> states;
  for (const auto& entry : std::filesystem::directory_iterator(bench.options.out / "checkpoint"))
    states.push_back(entry.path());
  std::sort(states.begin(), states.end());
  REQUIRE(states.size() == 2);
  std::string bytes = text_of(states.back());
  bytes[bytes.size() / 2] ^= 1;
  std::ofstream(states.back(), std::ios::binary) << bytes;
  std::vector<std::string> warnings;
  RunOptions options = bench.options;
  options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  const RunResult resumed = resume_run(options, {}, host());
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find(states.back().filename().string()) != std::string::npos);
  CHECK(resumed.state_hash == whole.state_hash);
  CHECK(series_of(bench, "energy") == energy);
}

TEST_CASE("a state that the simulation refuses is passed over for the one before", "[run]") {
  Bench bench(two_stages);
  bench.plan.checkpoint.every_time = 3e-5;
  bench.run();
  const std::filesystem::path out = bench.options.out;
  const std::string energy = series_of(bench, "energy");
  std::filesystem::remove(out / "final_state.h5");
  const auto spoil = [&](const char* name) {
    State state = state_file::read_state(out / "checkpoint" / name);
    std::vector<double> positions = std::get<std::vector<double>>(state.at("bodies/position").values);
    positions[0] += 1e-3;
    StateArray other = state.at("bodies/position");
    other.values = positions;
    state.put("bodies/position", other);
    state_file::write_state(out / "checkpoint" / name, state);
  };
  spoil("step_000000000000009.h5");
  std::vector<std::string> warnings;
  bench.options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  SECTION("the run goes on from the one before") {
    resume(bench);
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0],
               Catch::Contains("step_000000000000009.h5: 'state_hash' is not that of the numbers"));
    CHECK(series_of(bench, "energy") == energy);
  }
  SECTION("without one it is refused") {
    spoil("step_000000000000006.h5");
    std::filesystem::remove_all(out / "states");
    CHECK_THAT(resume_refusal(bench, {}),
               Catch::Contains("step_000000000000009.h5: 'state_hash' is not that"));
    CHECK(warnings.empty());
  }
}

TEST_CASE("checkpoints after the state from which a run goes on are removed", "[run]") {
  const Bench bench(two_stages, {"checkpoint.every_time=2e-5", "checkpoint.final_state=false"});
  bench.run();
  const auto later = bench.options.out / "checkpoint/step_000000000000008.h5";
  REQUIRE(std::filesystem::exists(later));
  std::filesystem::resize_file(later, 100);
  std::vector<std::string> warnings;
  RunOptions options = bench.options;
  options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  options.on_start = [&](const Simulation&) { CHECK_FALSE(std::filesystem::exists(later)); };
  resume_run(options, {}, host());
  CHECK(warnings.size() == 1);
}

namespace {

// States of so many steps in the directory of a run.
struct SavedStates {
  TemporaryFolder folder;
  RunDirectory directory{folder / "out", RunDirectory::Existing::refuse};
  Checkpoints checkpoints{directory};
  std::vector<std::string> reports;

  SavedStates() { directory.create(); }
  void write(std::uint64_t steps) { write(checkpoints.add(steps), steps); }
  static void write(const std::filesystem::path& file, std::uint64_t steps) {
    State state;
    StateTransfer::saving_to(state).below("clock").value("steps", "1", steps);
    state_file::write_state(file, state);
  }
  bool has(const std::string& name) const { return std::filesystem::exists(directory.path() / name); }
  // The name of the file that is taken; those with a name in `refused` are not.
  std::string latest(const std::string& refused = "") {
    const auto refusal = [&](const Checkpoints::Latest& state) -> std::optional<std::string> {
      if (refused.find(state.path.filename().string()) == std::string::npos) return std::nullopt;
      return "is refused; take another";
    };
    const auto found = checkpoints.latest(refusal, [&](const std::string& line) { reports.push_back(line); });
    return found ? found->path.filename().string() : "";
  }
};

}  // namespace

TEST_CASE("of many states of a run the two of the most steps are kept", "[run]") {
  SavedStates saved;
  for (const std::uint64_t steps : {9, 10, 100}) saved.write(steps);  // not in the order of their texts
  saved.checkpoints.remove_old();
  CHECK_FALSE(saved.has("checkpoint/step_000000000000009.h5"));
  CHECK(saved.has("checkpoint/step_000000000000010.h5"));
  CHECK(saved.has("checkpoint/step_000000000000100.h5"));
  saved.checkpoints.remove_later(10);
  CHECK(saved.has("checkpoint/step_000000000000010.h5"));
  CHECK_FALSE(saved.has("checkpoint/step_000000000000100.h5"));
}

TEST_CASE("a run goes on from its state of the most steps, whichever file that is in", "[run]") {
  SavedStates saved;
  CHECK(saved.latest().empty());
  saved.write(10);
  saved.write(20);
  SavedStates::write(saved.checkpoints.add_final(), 15);
  CHECK(saved.latest() == "step_000000000000020.h5");
  SavedStates::write(saved.directory.path() / "final_state.h5", 25);
  CHECK(saved.latest() == "final_state.h5");
  CHECK(saved.reports.empty());
  CHECK(saved.latest("final_state.h5") == "step_000000000000020.h5");
  REQUIRE(saved.reports.size() == 1);
  CHECK(saved.reports[0].ends_with("final_state.h5: is refused; take another"));
  SavedStates::write(saved.directory.path() / "final_state.h5", 15);
  CHECK(saved.latest("step_000000000000020.h5") == "final_state.h5");
}

TEST_CASE("if no state can be used, the first refusal is the error, or that none can be read", "[run]") {
  SavedStates saved;
  saved.write(10);
  saved.write(20);
  CHECK(message([&] {
          saved.latest("step_000000000000010.h5 step_000000000000020.h5");
        }).ends_with("step_000000000000020.h5: is refused; take another"));
  for (const std::uint64_t steps : {10, 20}) std::filesystem::resize_file(saved.checkpoints.add(steps), 100);
  CHECK(message([&] {
          saved.latest();
        }).ends_with("out: none of its states can be read; run the scenario again"));
  CHECK(saved.reports.size() == 2);
}
