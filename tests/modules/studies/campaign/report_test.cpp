#include "campaign_support.hpp"

#include <catch2/catch.hpp>

#include <scree/campaign/report.hpp>

using namespace scree::campaign;
using scree::test::CampaignFolder;
using scree::test::finished;

namespace {}  // namespace

TEST_CASE("the summary lists varied keys, expectations and failed runs with their reasons", "[campaign]") {
  const Campaign c = CampaignFolder("seeds = [1, 2, 3]\n[set]\ntime.step = [1e-5]\n").read();
  Execution execution{{finished({}), finished({}, false), {Status::failed, "it broke", {}, {}}}, 1, false};
  execution.outcomes[1].warnings = {"too long; use less"};
  CHECK(
      text_report(c, execution) ==
      "campaign: 3 runs, 1 value of time.step x 3 seeds\n"
      "2 finished (1 of them in an earlier call), 1 failed\n"
      "NOT MET  in 1 of 2: It holds\n"
      "FAILED   step=1e-5,seed=3: it broke\n"
      "WARNINGS in 1 of 3 runs, see the column warnings of table.csv; step=1e-5,seed=2: too long; use less\n");
  CHECK(list_report(c, {}, execution.outcomes) ==
        "campaign: 3 runs, 1 value of time.step x 3 seeds\n"
        "finished     step=1e-5,seed=1\n"
        "finished     step=1e-5,seed=2\n"
        "failed       step=1e-5,seed=3: it broke\n");
}

TEST_CASE("the record says what is collected, for the charts of the report", "[campaign]") {
  const Campaign c = CampaignFolder("seeds = [1]\ncollect = ['energy.work.last']\n").read();
  CHECK_THAT(campaign_json(c, {{finished({})}}),
             Catch::Contains("\"collect\": [\n    \"energy.work.last\"\n  ]"));
}
