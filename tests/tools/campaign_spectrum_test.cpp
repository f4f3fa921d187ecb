#include "campaign_workspace.hpp"

using namespace scree::test;

namespace {

// Frequencies are proportional to the root of the stiffness.
const std::string soft_and_stiff =
    "spectrum = 'linear'\n[set]\n\"contact.normal_stiffness\" = [1000, 4000]\n\"spectrum.to_hz\" = 70\n";

double first_peak(const CampaignWorkspace& w, const std::string& name) {
  return w.record("out/" + name, "spectrum.json")["peaks"]["linear"]["particles.z_8"]["peak_1"]["frequency"];
}

}  // namespace

TEST_CASE("a campaign measures spectra and puts their peaks in its table", "[tools]") {
  const CampaignWorkspace w(soft_and_stiff, chain);
  const Outcome outcome = w.scree(campaign_call);
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);
  CHECK(contains(w.text("out/table.csv"), ",peaks.linear.particles.z_8.peak_1.frequency,"));
  // The fit of a peak leaves 1e-5 of the other modes; damping that stays changes none by more.
  CHECK(first_peak(w, "normal_stiffness=4000") / first_peak(w, "normal_stiffness=1000") ==
        Approx(2).epsilon(1e-4));
  CHECK(contains(w.scree(campaign_call).out, "2 finished (2 of them in an earlier call)"));
}

TEST_CASE("spectra of a campaign are measured again where a plug-in or value is another", "[tools]") {
  const CampaignWorkspace w(soft_and_stiff, chain);
  REQUIRE(w.scree(campaign_call).status == 0);
  w.write("campaign.toml",
          "[campaign]\nscenario = 'scene.toml'\n" + soft_and_stiff + "\"spectrum.from_hz\" = 21\n");
  const Outcome list = w.scree(campaign_call + "--list");
  CHECK(contains(list.out, "changed "));
  CHECK(!contains(list.out, "finished "));
  const Outcome again = w.scree(campaign_call);
  INFO(again.err);
  CHECK(again.status == 0);
  CHECK(contains(again.out, "2 finished\n"));
}
