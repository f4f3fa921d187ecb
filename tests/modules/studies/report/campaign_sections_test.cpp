#include "campaign_support.hpp"

using namespace scree::test;

TEST_CASE("the page of a campaign has its charts, means, runs and settings", "[report]") {
  const TemporaryFolder folder;
  write_campaign(folder);
  const std::string page = checked_page(folder);
  for (const char* part :
       {"7 of 8 runs finished, 1 failed.", "All expectations are met in all runs that finished.", "<svg",
        "Means over the seeds, with standard errors", "e.<wbr>work.<wbr>last (mJ)", "3.5 ± 1.5",
        "<a href=\"soft,friction=0.1,seed=1/report.html\">soft,friction=0.1,seed=1</a>", "it &lt;blew&gt; up",
        "1 of 1", "scree campaign /a/friction.toml", "1, 2"})
    CHECK_THAT(page, Catch::Contains(part));
  CHECK_THAT(page, !Catch::Contains("href=\"soft,friction=0.1,seed=2"));
}
