#include "program.hpp"

using namespace scree::test;

namespace {

// Two stages: the first ends by a column, or not in time.
std::string stages(const std::string& until) {
  return with(discs, "duration = 1e-4\n", "") + "[[stage]]\nname = 'settle'\nuntil = { " + until +
         " }\n[[stage]]\nname = 'hold'\nduration = 2e-4\n";
}

const std::string too_short = "'energy.kinetic_translation' = { below = 0 }, at_most = 1e-4";

std::string results_of(const Workspace& w, const std::string& directory) {
  return w.text(directory + "/series/energy.csv") + w.record(directory)["state_hash"].get<std::string>();
}

}  // namespace

TEST_CASE("a stage that is not reached keeps the run, and goes on with more time to the same bits",
          "[tools]") {
  const Workspace w(stages(too_short));
  const Outcome failed = w.run();
  INFO(failed.err);
  CHECK(failed.status == 4);
  CHECK_THAT(failed.err, Catch::Contains("stage 'settle': after 0.0001 s energy.kinetic_translation is ") &&
                             Catch::Contains("scree resume DIR --set stage.settle.until.at_most=<s>"));
  CHECK(w.record()["status"] == "failed");
  CHECK(w.record()["stages"][0]["ended"] == "failed");

  const Outcome again = w.scree("resume out");
  CHECK(again.status == 2);
  CHECK_THAT(again.err, Catch::Contains("stage 'settle' has taken 0.0001 s without meeting its conditions"));
  CHECK(w.record()["status"] == "failed");

  const Outcome longer = w.scree("resume out --set stage.settle.until.at_most=2e-4");
  CHECK(longer.status == 4);
  const Outcome whole = w.scree("run scene.toml --out whole --set stage.settle.until.at_most=2e-4");
  CHECK(whole.status == 4);
  CHECK(results_of(w, "out") == results_of(w, "whole"));
  // Or the next stage begins without it.
  CHECK(w.scree("resume out --set stage.settle.until.otherwise=go_on").status == 0);
}

TEST_CASE("a run that goes on keeps the functions of time of its stages", "[tools]") {
  const Workspace w(stages(too_short + ", otherwise = 'go_on'"));
  REQUIRE(w.run().status == 0);
  const std::string whole = results_of(w, "out");
  const Outcome refused = w.scree("resume out --set stage.hold.set.box.stress_x.duration=2");
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Catch::Contains("can change only how long its stages last"));
  CHECK(results_of(w, "out") == whole);
}

TEST_CASE("a stage that may go on leaves a state at its end, to which resume goes back", "[tools]") {
  const Workspace w(stages(too_short + ", otherwise = 'go_on'"));
  REQUIRE(w.run().status == 0);
  CHECK(w.record()["stages"][0]["ended"] == "at_most");
  CHECK(w.record()["stages"][1]["ended"] == "duration");
  CHECK(w.has("out/states/settle.h5"));
  CHECK_FALSE(w.has("out/states/hold.h5"));
  const std::string whole = results_of(w, "out");

  const auto refused = [&](const std::string& arguments, const std::string& message) {
    const Outcome outcome = w.scree("resume out " + arguments);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Contains(message));
    CHECK(results_of(w, "out") == whole);
  };
  refused("--from settle", "--from settle: results after this stage would be replaced; give --overwrite too");
  refused("--from setle --overwrite", "has no state of the end of this stage; did you mean 'settle'?");
  const Outcome back = w.scree("resume out --from settle --overwrite");
  INFO(back.err);
  CHECK(back.status == 0);
  CHECK(results_of(w, "out") == whole);
  CHECK(w.has("out/final_state.h5"));

  REQUIRE(w.scree("run scene.toml --out odd --quiet --set stage[0].name='a/b'").status == 0);
  CHECK(w.has("odd/states/a%2Fb.h5"));
  REQUIRE(w.scree("run scene.toml --out none --quiet --set checkpoint.stage_states=false").status == 0);
  CHECK_FALSE(w.has("none/states"));
}

TEST_CASE("a run without a state begins anew with --overwrite only", "[tools]") {
  const Workspace w(with(discs, "duration = 1e-4",
                         "duration = 1e-4\n[checkpoint]\nevery = 'never'\nfinal_state = false\n"));
  REQUIRE(w.run().status == 0);
  const Outcome refused = w.scree("resume out");
  CHECK(refused.status == 2);
  CHECK_THAT(
      refused.err,
      Catch::Contains("there is no state to go on from, and the run would begin anew; give --overwrite"));
  CHECK(w.record()["status"] == "finished");
  CHECK(w.scree("resume out --overwrite").status == 0);
}
