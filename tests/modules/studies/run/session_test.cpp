#include "plan_support.hpp"

#include <functional>
#include <memory>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/files/place_error.hpp>
#include <scree/run/session.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/state_file/state_file.hpp>

// What all studies have alike, by one that counts.

using namespace scree;
using namespace scree::run;
using namespace scree::test;

namespace {

class Counting : public Study {
 public:
  Counting(Session& session, const scenario::Plan& plan) : session_(session), simulation_(set_up(plan)) {}

  void prepare() override {}
  void restore(const State& state) override {
    session_.transfer(StateTransfer::restoring_from(state).below("quasi_static"));
  }
  void open() override { on_open(); }
  bool work() override {
    for (; count < 10; ++count) {
      if (!session_.proceeds()) return false;
      session_.keep(simulation_->state(), double(count));
      on_count(count);
    }
    return true;
  }
  bool has_results() const override { return results; }
  void transfer(const StateTransfer& state) override { state.value("count", "1", count); }
  nlohmann::ordered_json record() override { return {{"count", count}}; }

  std::uint64_t count = 0;
  bool results = true;
  std::function<void()> on_open = [] {};
  std::function<void(std::uint64_t count)> on_count = [](std::uint64_t) {};

 private:
  Session& session_;
  std::unique_ptr<Simulation> simulation_;
};

// A scene with a study, which is begun or goes on.
struct Counted {
  explicit Counted(const std::string& checkpoint = "") : plan(plan_of(discs + checkpoint)) {
    options.out = folder / "out";
    options.stop = &stop;
    options.on_warning = [this](const std::string& line) { warnings.push_back(line); };
  }

  void begin(const std::function<void(Counting&)>& change = [](Counting&) {}) {
    Session session(quasi_static_results, plan, options);
    Counting study(session, plan);
    change(study);
    session.begin(study);
  }
  void resume(const std::function<void(Counting&)>& change = [](Counting&) {}) {
    Unfinished from = unfinished_in(options.out, quasi_static_results, host(), options.on_warning);
    Session session(quasi_static_results, from.plan, options, std::move(from.directory));
    Counting study(session, from.plan);
    change(study);
    session.resume(study, from.state, from.file);
  }
  bool has(const std::string& file) const { return std::filesystem::exists(options.out / file); }
  nlohmann::json record() const { return nlohmann::json::parse(text_of(options.out / "quasi_static.json")); }
  // In the file of the state.
  std::uint64_t count() const {
    std::uint64_t count = 0;
    const State state = state_file::read_state(options.out / "state.h5");
    StateTransfer::restoring_from(state).below("quasi_static").value("count", "1", count);
    return count;
  }

  TemporaryFolder folder;
  scenario::Plan plan;
  SessionOptions options;
  std::atomic<bool> stop = false;
  std::vector<std::string> warnings;
};

ExitStatus status_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.status();
  }
  return ExitStatus::success;
}

}  // namespace

TEST_CASE("a study is recorded from its start to its end, and needs no state then", "[run]") {
  Counted c;
  c.begin([&](Counting& study) {
    study.on_count = [&](std::uint64_t) {
      CHECK(c.record()["status"] == "running");
      CHECK(c.has(SpareRoom::file_name));
      CHECK(c.has("scenario.toml"));
      CHECK(c.has("state.h5"));
    };
  });
  CHECK(c.record()["status"] == "finished");
  CHECK(c.record()["count"] == 10);
  CHECK_FALSE(c.has(SpareRoom::file_name));
  CHECK_FALSE(c.has("state.h5"));
}

TEST_CASE("a study ends with its page, which is missing while it goes on", "[run]") {
  Counted c;
  const auto page = [&] { return text_of(c.options.out / "report.html"); };
  c.begin([&](Counting& study) { study.on_count = [&](std::uint64_t count) { c.stop = count == 4; }; });
  CHECK_THAT(page(), Catch::Contains("The quasi-static load was interrupted before its end."));
  c.stop = false;
  c.resume(
      [&](Counting& study) { study.on_count = [&](std::uint64_t) { CHECK_FALSE(c.has("report.html")); }; });
  CHECK_THAT(page(), Catch::Contains("The quasi-static load finished."));
  CHECK_THAT(text_of(c.options.out / "written.txt"), Catch::Contains("\nreport.html\n"));
  CHECK(c.warnings.empty());
}

TEST_CASE("a study that fails ends with its page too", "[run]") {
  Counted c;
  CHECK_THROWS(c.begin([](Counting& study) {
    study.on_count = [](std::uint64_t) { throw Error("it: broke; mend it", ExitStatus::failure); };
  }));
  CHECK_THAT(text_of(c.options.out / "report.html"),
             Catch::Contains("The quasi-static load failed: it: broke; mend it"));
}

TEST_CASE("a study without its page is complete", "[run]") {
  Counted c;
  c.begin([&](Counting& study) {
    study.on_count = [&](std::uint64_t) { std::filesystem::create_directory(c.options.out / "report.html"); };
  });
  CHECK(c.record()["status"] == "finished");
  REQUIRE(c.warnings.size() == 1);
  CHECK_THAT(c.warnings[0], Catch::StartsWith("report.html is missing: ") &&
                                Catch::Contains("report.html: is there and was not written by a run; "));
}

TEST_CASE("a study whose first files cannot be written takes its directory back", "[run]") {
  Counted c;
  CHECK(status_of([&] {
          c.begin([](Counting& study) {
            study.on_open = [] {
              throw Error("series: cannot be written; free disk space", ExitStatus::failure);
            };
          });
        }) == ExitStatus::failure);
  CHECK_FALSE(std::filesystem::exists(c.options.out));
}

TEST_CASE("bad input that is found without results leaves nothing, and with results is a failure", "[run]") {
  Counted c;
  const bool results = GENERATE(false, true);
  const ExitStatus status = status_of([&] {
    c.begin([&](Counting& study) {
      study.results = results;
      study.on_count = [](std::uint64_t) { throw Error("wall: is loose; hold it"); };
    });
  });
  CHECK(status == (results ? ExitStatus::failure : ExitStatus::bad_input));
  CHECK(std::filesystem::exists(c.options.out) == results);
  if (results) CHECK(c.record()["error"] == "wall: is loose; hold it");
}

TEST_CASE("a failure is recorded with the cure of its place", "[run]") {
  Counted c;
  const auto fail = [](std::uint64_t at) {
    return [at](Counting& study) {
      study.on_count = [at](std::uint64_t count) {
        if (count == at) throw files::PlaceError("out/a.csv", "is a directory", "move it elsewhere");
      };
    };
  };
  CHECK(status_of([&] { c.begin(fail(3)); }) == ExitStatus::failure);
  CHECK(c.record()["status"] == "failed");
  CHECK(c.record()["error"] == "out/a.csv: is a directory; move it elsewhere, or give another --out");
  CHECK(c.count() == 3);
  // One that goes on cannot take another directory.
  CHECK(status_of([&] { c.resume(fail(5)); }) == ExitStatus::failure);
  CHECK(c.record()["error"] == "out/a.csv: is a directory; move it elsewhere");
  CHECK(c.count() == 5);
  c.resume();
  CHECK(c.record()["status"] == "finished");
  CHECK_FALSE(c.record().contains("error"));
}

TEST_CASE("states are written as [checkpoint] says, and when a study is stopped", "[run]") {
  const auto [checkpoint, written] = GENERATE(table<std::string, std::vector<int>>(
      {{"", {0, 0, 0, 0, 0}},
       {"[checkpoint]\nevery = '1e-9 s'\n", {0, 1, 2, 3, 4}},
       {"[checkpoint]\nevery = 'never'\n", {-1, -1, -1, -1, -1}},
       {"[checkpoint]\nevery = 'never'\nevery_time = 2\n", {0, 0, 2, 2, 4}}}));
  Counted c(checkpoint);
  std::vector<int> found;
  c.begin([&](Counting& study) {
    study.on_count = [&](std::uint64_t count) {
      found.push_back(c.has("state.h5") ? int(c.count()) : -1);
      c.stop = count == 4;
    };
  });
  CHECK(found == written);
  CHECK(c.record()["status"] == "interrupted");
  CHECK(c.count() == 4);
  c.stop = false;
  std::uint64_t first = 0;
  c.resume(
      [&](Counting& study) { study.on_count = [&](std::uint64_t count) { first = first ? first : count; }; });
  CHECK(first == 4);
}

TEST_CASE("a state that cannot be written is warned of once, and the study goes on", "[run]") {
  Counted c("[checkpoint]\nevery = '1e-9 s'\n");
  c.begin([&](Counting& study) {
    std::filesystem::create_directories(c.options.out / "state.h5");
    study.on_open = [&] { c.folder.write("out/state.h5/a", ""); };
  });
  REQUIRE(c.warnings.size() == 1);
  CHECK_THAT(c.warnings[0], Catch::StartsWith("no state at t = 0 s: "));
  CHECK(c.record()["warnings"].size() == 1);
}

TEST_CASE("a study that goes on keeps its warnings, and its wall time", "[run]") {
  Counted c;
  c.begin([&](Counting& study) { study.on_count = [&](std::uint64_t count) { c.stop = count == 1; }; });
  State state = state_file::read_state(c.options.out / "state.h5");
  const StateTransfer to = StateTransfer::saving_to(state).below("quasi_static");
  std::vector<std::string> warnings = {"a wall is loose; hold it"};
  double wall_time = 1000;
  to.rows("warnings", "", warnings);
  to.value("wall", "s", wall_time);
  state_file::write_state(c.options.out / "state.h5", state);
  c.stop = false;
  Unfinished from = unfinished_in(c.options.out, quasi_static_results, host(), {});
  Session session(quasi_static_results, from.plan, c.options, std::move(from.directory));
  Counting study(session, from.plan);
  session.resume(study, from.state, from.file);
  CHECK(session.warnings() == warnings);
  CHECK(session.wall_time() >= 1000);
}

TEST_CASE("room for the last record is on the disk until it is given back, and no file of another is removed",
          "[run]") {
  const TemporaryFolder folder;
  RunDirectory directory(folder / "out", RunDirectory::Existing::refuse);
  directory.create();
  const std::filesystem::path room = directory.path() / SpareRoom::file_name;
  directory.write_file("run.json", std::string(1000, ' '));
  SpareRoom spare;
  spare.reserve(directory, "run.json");
  CHECK(std::filesystem::file_size(room) == SpareRoom::size + 1000);
  spare.release();
  CHECK_FALSE(std::filesystem::exists(room));
  spare.reserve(directory, "none.json");
  CHECK(std::filesystem::file_size(room) == SpareRoom::size);
  std::filesystem::remove(room);
  folder.write("out/.room", "another's");
  spare.release();
  CHECK(text_of(room) == "another's");
}

TEST_CASE("states are due by simulated time at the first after each multiple, whatever its round-off",
          "[run]") {
  scenario::CheckpointPlan plan;
  plan.every = {}, plan.every_time = 0.1;
  Cadence cadence(plan);
  std::vector<int> due;
  double time = 0;
  for (int k = 1; k <= 10; ++k)
    if (time += 0.05; cadence.is_due(0, time)) due.push_back(k), cadence.restart(0, time);
  CHECK(due == std::vector<int>{2, 4, 6, 8, 10});
  plan.every = 60, plan.every_time = {};
  Cadence by_wall(plan);
  by_wall.restart(100, 0);
  CHECK_FALSE(by_wall.is_due(159));
  CHECK(by_wall.is_due(160));
}
