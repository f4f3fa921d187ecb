#include "campaign_charts.hpp"

#include "campaign_support.hpp"

using namespace scree::report;
using namespace scree::test;

TEST_CASE("a quantity is drawn over each number, a curve for each combination of the rest", "[report]") {
  const TemporaryFolder folder;
  write_campaign(folder);
  const Results results = campaign_of(folder);
  Figures figures;
  add_campaign_charts(CampaignTable(results), figures);
  CHECK_THAT(figures.html(), Catch::Contains("<desc>e.work.last (mJ) over friction; soft; hard</desc>") &&
                                 Catch::Contains("<figcaption>e.work.last over friction</figcaption>"));
}

TEST_CASE("more charts and curves than a page can have are counted", "[report]") {
  const TemporaryFolder folder;
  std::string header = "run,a.x,b.y,seed,status", rows;
  Json collect = Json::array();
  for (int q = 0; q < 13; ++q)
    header += ",p.q" + std::to_string(q) + ".last", collect.push_back("p.q" + std::to_string(q) + ".last");
  for (int x = 0; x < 9; ++x)
    for (int y = 0; y < 2; ++y) {
      rows += "r," + std::to_string(x) + "," + std::to_string(y) + ",1,finished";
      for (int q = 0; q < 13; ++q) rows += "," + std::to_string(x + q);
      rows += "\n";
    }
  folder.write("table.csv", header + "\n" + rows);
  const Results results = {folder.path(), {{"collect", collect}}, "campaign", "campaign"};
  Figures figures;
  add_campaign_charts(CampaignTable(results), figures);
  CHECK_THAT(figures.html(), Catch::Contains("2 more are not drawn; collect fewer quantities.") &&
                                 Catch::Contains("p.q0.last over y; 2 of 9 combinations are not drawn"));
}
