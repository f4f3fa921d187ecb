#include "campaign_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/campaign/report.hpp>

using namespace scree::campaign;
using scree::test::CampaignFolder;
using scree::test::finished;

namespace {}  // namespace

TEST_CASE("the table has a row per run, with numbers of finished runs only", "[campaign]") {
  const Campaign c =
      CampaignFolder("seeds = [7, 9]\n[set]\nscene.title = ['plain', 'with, \"quotes\"']\n").read();
  std::vector<Outcome> outcomes = {finished({{"work", 0.1}, {"seed", 7}}),
                                   {Status::failed, "why", {}, {}},
                                   finished({{"seed", 7}, {"more", NAN}, {"work", 2}}, false),
                                   {}};
  outcomes[2].warnings = {"too long; use less", "and more"};
  CHECK(
      table_csv(c, outcomes) ==
      "run,scene.title,seed,status,expectations,expectations_met,warnings,work,more\n"
      "\"title=plain,seed=7\",plain,7,finished,1,1,,0.1,\n"
      "\"title=plain,seed=9\",plain,9,failed,,,,,\n"
      "\"title=with_quotes,seed=7\",\"with, \"\"quotes\"\"\",7,finished,1,0,too long; use less | and more,2,\n"
      "\"title=with_quotes,seed=9\",\"with, \"\"quotes\"\"\",9,missing,,,,,\n");
  const auto json = nlohmann::json::parse(campaign_json(c, Execution{outcomes}));
  CHECK(std::string(json["file"]).ends_with("/campaign.toml"));
  CHECK(json["parameters"]["scene.title"][1] == "with, \"quotes\"");
  CHECK(json["runs"][1]["error"] == "why");
  CHECK(json["runs"][3]["set"]["scene.seed"] == 9);
}

TEST_CASE("means and standard errors are taken over the seeds of each point", "[campaign]") {
  const Campaign c = CampaignFolder("seeds = [1, 2, 3]\n[set]\ntime.step = [1e-5, 2e-5, 3e-5]\n").read();
  std::vector<Outcome> outcomes(9);
  // Mean 4 and standard error √((9 + 1 + 4)/2/3).
  outcomes[0] = finished({{"x", 1}});
  outcomes[1] = finished({{"x", 5}});
  outcomes[2] = finished({{"x", 6}});
  outcomes[4] = finished({{"x", -2}});
  CHECK(means_csv(c, outcomes) ==
        fmt::format("time.step,runs,x_mean,x_standard_error\n1e-5,3,4,{}\n2e-5,1,-2,\n3e-5,0,,\n",
                    std::sqrt(14.0 / 2 / 3)));
}
