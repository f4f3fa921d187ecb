#include "campaign_table.hpp"

#include "campaign_support.hpp"

#include <cmath>

using namespace scree::report;
using namespace scree::test;

TEST_CASE("runs that differ in their seed are a combination with a mean", "[report]") {
  const TemporaryFolder folder;
  write_campaign(folder);
  const Results results = campaign_of(folder);
  const CampaignTable table(results);
  CHECK(table.keys() == std::vector<std::string>{"case", "contact.friction"});
  CHECK(table.quantities() == std::vector<std::string>{"e.work.last"});
  REQUIRE(table.combinations().size() == 4);
  CHECK(table.combinations()[1].values == std::vector<std::string>{"soft", "0.4"});
  // Of 0.002 and 0.005; their standard error is half their distance.
  const Mean mean = table.mean(table.combinations()[0], "e.work.last");
  CHECK(mean.mean == Approx(0.0035));
  CHECK(mean.standard_error == Approx(0.0015));
  // The other one has failed.
  CHECK(table.combinations()[3].rows.size() == 1);
  CHECK(std::isnan(table.mean(table.combinations()[3], "e.work.last").standard_error));
  CHECK(std::isnan(table.mean(table.combinations()[0], "none").mean));
  CHECK_FALSE(table.is_numeric(0));
  CHECK(table.is_numeric(1));
  CHECK(table.short_name(1) == "friction");
  CHECK(table.unit("e.work.last") == "J");
  CHECK(table.unit("peaks").empty());
}

TEST_CASE("without a list of what is collected quantities are those with the names of one", "[report]") {
  const TemporaryFolder folder;
  folder.write(
      "table.csv",
      "run,a.x,b.x,seed,status,steps,peaks.linear.z.peak_1.frequency,peaks.linear.z.peak_1.frequency_error\n"
      "r,1,2,1,finished,3,4,5\n");
  const Results results = {folder.path(), Json::object(), "campaign", "campaign"};
  const CampaignTable table(results);
  CHECK(table.quantities() == std::vector<std::string>{"peaks.linear.z.peak_1.frequency"});
  CHECK(table.short_name(0) == "a.x");
  CHECK_FALSE(table.is_numeric(0));
}
