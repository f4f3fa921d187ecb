#include "campaign_workspace.hpp"

using namespace scree::test;

namespace {

// Discs without bodies of their own.
const std::string scene_without_bodies =
    with(with(with(discs, "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n", ""),
              "radius = 0.01\n", ""),
         "random_velocity = 0.1\n", "");
const std::string stiffnesses = "seeds = [1, 2]\n[set]\ncontact.normal_stiffness = [1e4, 2e4]\n";
const std::string prepare = "[prepare]\nscenario = 'prepare.toml'\nset.time.duration = 0.05\n";

struct PreparedWorkspace : CampaignWorkspace {
  explicit PreparedWorkspace(const std::string& rest, const std::string& text = scene_without_bodies)
      : CampaignWorkspace(rest, text) {
    write("prepare.toml", discs);
  }
  // Directories of the preparations, in the order of their seeds.
  std::vector<std::string> preparations() const {
    std::vector<std::string> names;
    const auto json = nlohmann::json::parse(text("out/campaign.json"));
    for (const auto& run : json["preparation"]["runs"])
      names.push_back("out/" + run["run"].get<std::string>());
    return names;
  }
};

}  // namespace

TEST_CASE("the runs of a campaign begin from one preparation per seed", "[tools]") {
  const PreparedWorkspace w(stiffnesses + prepare);
  const Outcome outcome = w.scree(campaign_call + "--jobs 2");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const std::vector<std::string> made = w.preparations();
  REQUIRE(made.size() == 2);
  for (std::size_t k : {0, 1})
    CHECK(
        contains(outcome.out, "prepared " + made[k].substr(4) + " (seed " + std::to_string(k + 1) + ") in "));
  CHECK(contains(outcome.out, " s\n4 finished\n"));
  CHECK(w.record(made[1])["seed"] == 2);
  CHECK(w.record(made[1])["steps"] == 5000);
  // The same by hand.
  REQUIRE(w.scree("run scene.toml --out hand --set contact.normal_stiffness=2e4 --set scene.seed=2 "
                  "--set particles.state=" +
                  made[1] + "/final_state.h5")
              .status == 0);
  CHECK(w.record("hand")["state_hash"] == w.record("out/normal_stiffness=20000,seed=2")["state_hash"]);
  CHECK(w.record("out/normal_stiffness=20000,seed=1")["state_hash"] !=
        w.record("out/normal_stiffness=20000,seed=2")["state_hash"]);
}

TEST_CASE("runs of a campaign put held bodies and a probe of a group beside the bodies of their preparation",
          "[tools]") {
  const std::string held =
      "[[particles]]\nname = 'rough'\nradius = 0.002\n"
      "lattice = { kind = 'square', count = [1, 1], origin = [-0.004, -0.004] }\n"
      "[[particles]]\nname = 'bed'\n";
  const std::string groups =
      "[[group]]\nname = 'wall'\nwhere = { particles = 'rough' }\nfixed = true\n"
      "[[probe]]\nplugin = 'momentum'\nname = 'bed_only'\nleave_out = ['wall']\nevery = 2e-5\n";
  const PreparedWorkspace w(stiffnesses + prepare,
                            with(scene_without_bodies, "[particles]\n", held) + groups);
  const Outcome outcome = w.scree(campaign_call);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const std::string run = "out/normal_stiffness=20000,seed=2";
  CHECK(w.record(run)["status"] == "finished");
  CHECK(contains(w.text(run + "/scenario.toml"), w.preparations()[1].substr(12) + "/final_state.h5"));
  CHECK(w.has(run + "/series/bed_only.csv"));
}

TEST_CASE("prepared runs are kept, also where the directory of the campaign was moved to", "[tools]") {
  const PreparedWorkspace w(stiffnesses + prepare);
  REQUIRE(w.scree(campaign_call).status == 0);
  const std::string list = w.scree(campaign_call + "--list").out;
  CHECK(contains(list, "finished     " + w.preparations()[0].substr(4) + " (seed 1)\n"));
  CHECK_FALSE(contains(list, "no longer in the campaign"));
  const Outcome moved =
      w.shell("mv out moved; touch moved/prepare/*/*.h5; scree campaign campaign.toml --out moved");
  CHECK(contains(moved.out, "4 finished (4 of them in an earlier call)\n"));
  CHECK(contains(moved.out, "kept     2 preparations of an earlier call\n"));
  CHECK_FALSE(contains(moved.out, "prepared prepare/"));
  // Another preparation has another directory, and runs from the former one are changed.
  REQUIRE(w.shell("mv moved out").status == 0);
  w.write("prepare.toml", with(discs, "normal_damping = 0", "normal_damping = 0.01"));
  const std::string after = w.scree(campaign_call + "--list").out;
  CHECK(contains(after, "missing      prepare/"));
  CHECK(contains(after, "changed      normal_stiffness=10000,seed=1\n"));
  CHECK(contains(w.scree(campaign_call).out, "\n4 finished\n"));
}

TEST_CASE("a preparation that fails fails its runs, and those of the other seeds go on", "[tools]") {
  const PreparedWorkspace w(stiffnesses + prepare);
  REQUIRE(w.scree(campaign_call).status == 0);
  const auto overlap = [&](std::size_t k) {
    return w.record(w.preparations()[k])["max_overlap_ratio"].get<double>();
  };
  // Between the largest overlaps of the two.
  const double first = overlap(0), second = overlap(1);
  REQUIRE(first != second);
  w.write("campaign.toml", "[campaign]\nscenario = 'scene.toml'\n" + stiffnesses + prepare +
                               "set.limits.overlap_ratio = " + std::to_string((first + second) / 2) + "\n");
  const Outcome outcome = w.scree(campaign_call);
  INFO(outcome.out);
  CHECK(outcome.status == 3);
  CHECK(contains(outcome.out, "\n2 finished, 2 failed\n"));
  const std::string seed = first > second ? "1" : "2";
  CHECK(contains(outcome.out, " (seed " + seed + "): contact of particle "));
  CHECK(contains(outcome.out, "FAILED   normal_stiffness=10000,seed=" + seed + ": prepare/"));
  CHECK(contains(outcome.out, " failed: contact of particle "));
}

TEST_CASE("runs that do not fit the prepared state are refused before any is run", "[tools]") {
  const PreparedWorkspace w(stiffnesses + prepare, discs);
  const Outcome outcome = w.scree(campaign_call);
  CHECK(outcome.status == 2);
  CHECK(contains(outcome.err, "scree: campaign.toml:2:12: in run 'normal_stiffness=10000,seed="));
  CHECK(contains(outcome.err, "both state and lattice are given; keep one of them\n"));
  CHECK_FALSE(w.has("out/normal_stiffness=10000,seed=1"));
  const PreparedWorkspace wrong("[prepare]\nscenario = 'prepare.toml'\nset.time.step = -1\n");
  check_refused(wrong, wrong.scree(campaign_call), "campaign.toml:5:17: in run 'prepare/",
                "give a step above 0");
}

TEST_CASE("a misspelt key is refused before anything is prepared", "[tools]") {
  const auto refused = [](const std::string& rest, const std::string& place, const std::string& known_keys,
                          const std::string& text = scene_without_bodies) {
    const PreparedWorkspace w(rest, text);
    check_refused(w, w.scree(campaign_call), place, known_keys);
  };
  refused("[set]\ncontact.normal_stifness = [1e4, 2e4]\n" + prepare,
          "campaign.toml:4:28: in run 'normal_stifness=10000' --set contact.normal_stifness=10000",
          "rolling_friction, rolling_time, control, name, between");
  refused("[prepare]\nscenario = 'prepare.toml'\nset.contact.normal_stifness = 1e4\n",
          "campaign.toml:5:31: in run 'prepare/", "rolling_friction, rolling_time, control, name, between");
  refused(prepare, "campaign.toml:2:12: in run 'run' scene.toml:", "overlap_ratio, speed",
          scene_without_bodies + "[limits]\noverlap_rato = 0.5\n");
}

TEST_CASE("preparations are not written through a link", "[tools]") {
  const PreparedWorkspace w(stiffnesses + prepare);
  REQUIRE(w.scree(campaign_call).status == 0);
  const Outcome outcome = w.shell("mv out/prepare elsewhere; ln -s ../elsewhere out/prepare\nscree " +
                                  campaign_call + "--overwrite");
  CHECK(outcome.status == 2);
  CHECK(contains(outcome.err, "out/prepare: is a symbolic link, which is not followed; "));
}
