#include "campaign_workspace.hpp"

using namespace scree::test;

namespace {

// Discs that collide for some seconds of wall time.
std::string lengthy(const char* duration = "30") {
  std::string scenario = with(discs, "duration = 1e-4", std::string("duration = ") + duration);
  return with(scenario, "every = 2e-5", "every = 1e-2");
}

// Interrupts a campaign when the run has begun to write.
Outcome interrupt(const CampaignWorkspace& w, const std::string& run = "out/run") {
  return w.shell("'" SCREE_TEST_PROGRAM
                 "' campaign campaign.toml --out out --jobs 1 &\nrun=$!\n"
                 "until test -s " +
                 run +
                 "/series/energy.csv; do sleep 0.05; done\n"
                 "kill -TERM $run; wait $run");
}

void check_same_run(const CampaignWorkspace& w, const std::string& a, const std::string& b) {
  CHECK(w.record(a)["state_hash"] == w.record(b)["state_hash"]);
  CHECK(w.text(a + "/series/energy.csv") == w.text(b + "/series/energy.csv"));
}

void set_status(const CampaignWorkspace& w, const std::string& from, const std::string& to) {
  w.write("out/run/run.json", with(w.text("out/run/run.json"), from, to));
}

}  // namespace

TEST_CASE("a campaign that was interrupted goes on where its run stopped, to the same bits", "[tools]") {
  const CampaignWorkspace w("", lengthy());
  const Outcome first = interrupt(w);
  REQUIRE(first.status == 130);
  CHECK(contains(w.scree(campaign_call + "--list").out, "interrupted  run\n"));
  const auto before = w.text("out/run/log.txt");
  // As a run that was killed.
  set_status(w, "\"interrupted\"", "\"running\"");
  CHECK(contains(w.scree(campaign_call + "--list").out, "interrupted  run\n"));
  const Outcome second = w.scree(campaign_call);
  INFO(second.out);
  CHECK(second.status == 0);
  CHECK(contains(second.out, "\n1 finished\n1 run went on from the state at which it stopped\n"));
  const std::string log = w.text("out/run/log.txt");
  CHECK(log.starts_with(before));
  CHECK(contains(log.substr(before.size()), "state hash "));
  REQUIRE(w.run().status == 2);  // out is the directory of the campaign
  REQUIRE(w.scree("run scene.toml --out whole").status == 0);
  check_same_run(w, "out/run", "whole");
  CHECK_FALSE(contains(w.scree(campaign_call).out, "went on"));
}

TEST_CASE("a run whose state cannot be read begins anew in the same call", "[tools]") {
  const CampaignWorkspace w("", lengthy("10"));
  REQUIRE(interrupt(w).status == 130);
  const Outcome again =
      w.shell("for f in out/run/checkpoint/*.h5; do echo cut > $f; done\nscree " + campaign_call);
  INFO(again.out);
  CHECK(again.status == 0);
  CHECK(contains(again.out, "\n1 finished\nbegun anew run: out/run: none of its states can be read; "));
  CHECK(w.text("out/run/log.txt").find("none of its states") == std::string::npos);
  REQUIRE(w.scree("run scene.toml --out whole").status == 0);
  check_same_run(w, "out/run", "whole");
}

TEST_CASE("an interrupted run begins anew with --overwrite, with other values, and without a state",
          "[tools]") {
  const CampaignWorkspace w("", lengthy("10"));
  REQUIRE(interrupt(w).status == 130);
  const Outcome all = w.scree(campaign_call + "--overwrite");
  CHECK(all.status == 0);
  CHECK_FALSE(contains(all.out, "went on"));
  REQUIRE(w.scree("run scene.toml --out whole").status == 0);
  set_status(w, "\"finished\"", "\"interrupted\"");
  REQUIRE_FALSE(w.has("out/run/checkpoint"));
  CHECK_FALSE(contains(w.scree(campaign_call).out, "went on"));
  REQUIRE(w.shell("rm -r out").status == 0);
  REQUIRE(interrupt(w).status == 130);
  w.write("scene.toml", with(lengthy("10"), "normal_damping = 0", "normal_damping = 0.01"));
  CHECK_FALSE(contains(w.scree(campaign_call).out, "went on"));
  CHECK(w.record("out/run")["state_hash"] != w.record("whole")["state_hash"]);
}

TEST_CASE("a preparation that was interrupted goes on, and its runs begin from the same state", "[tools]") {
  const std::string scene =
      with(with(with(discs, "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n", ""),
                "radius = 0.01\n", ""),
           "random_velocity = 0.1\n", "");
  const CampaignWorkspace w("[prepare]\nscenario = 'prepare.toml'\n", scene);
  w.write("prepare.toml", lengthy("20"));
  REQUIRE(interrupt(w, "out/prepare/*").status == 130);
  CHECK(contains(w.scree(campaign_call + "--list").out, "\ninterrupted  prepare/"));
  const Outcome second = w.scree(campaign_call);
  INFO(second.err + second.out);
  CHECK(second.status == 0);
  CHECK(contains(second.out, "1 finished\n1 run went on from the state at which it stopped\n"));
  const Outcome hand = w.shell(
      "scree run prepare.toml --out whole && cp -r whole/final_state.h5 . &&\n"
      "scree run scene.toml --out whole-run --set particles.state=final_state.h5");
  CHECK(hand.status == 0);
  CHECK(w.record("out/run")["state_hash"] == w.record("whole-run")["state_hash"]);
}
