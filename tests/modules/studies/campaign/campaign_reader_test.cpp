#include "campaign_support.hpp"

#include <ctime>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::names_of;
using test::refusal_of;
using test::starts;
using test::Texts;

TEST_CASE("an error in a campaign file is reported with position and cure", "[campaign]") {
  starts(refusal_of("sead = 3\n"), "campaign.toml:3:1: unknown key 'sead' in [campaign]");
  starts(refusal_of("seeds = 3\n"),
         "campaign.toml:3:9: seeds is neither a list nor a table; give whole numbers");
  starts(refusal_of("seeds = []\n"), "campaign.toml:3:9: the list of seeds is empty; ");
  starts(refusal_of("seeds = [1, 2, 1]\n"), "campaign.toml:3:16: seed 1 appears twice in the list; ");
  starts(refusal_of("seeds = [1.5]\n"), "campaign.toml:3:10: ");
  starts(refusal_of("seeds = { count = 0 }\n"), "campaign.toml:3:19: campaign.seeds.count = 0 is below 1; ");
  starts(refusal_of("[set]\na.b = []\n"), "campaign.toml:4:7: the list of 'a.b' is empty; ");
  starts(refusal_of("[set]\na.b = [1, 1]\n"), "campaign.toml:4:11: 1 appears twice in the list of 'a.b'; ");
  starts(refusal_of("[set]\na.b = 1\n\"a.b\" = 2\n"), "campaign.toml:5:9: 'a.b' is set twice; ");
  starts(refusal_of("[set]\nscene.seed = [1, 2]\n"), "campaign.toml:4:15: scene.seed cannot be in [set]; ");
  starts(refusal_of("seeds = [1]\n[set]\nscene.seed = 1\n"),
         "campaign.toml:5:14: 'scene.seed' is also set by seeds; ");
  starts(refusal_of("[set]\na.b = 1\n[[case]]\nname = 'x'\nset.a.b = 2\n"),
         "campaign.toml:7:11: 'a.b' is also set by [set] or --set; ");
  starts(refusal_of("[[case]]\nname = 'x'\n[[case]]\nname = 'x'\n"),
         "campaign.toml:6:8: the case name 'x' is already in use; ");
  starts(refusal_of("seeds = { count = 100000 }\n[set]\na.b = [1, 2]\n"),
         "campaign.toml:1:1: the campaign has more than 100000 runs; ");
}

TEST_CASE("a missing scenario is refused at the key that names it", "[campaign]") {
  const test::TemporaryFolder folder;
  const auto file = folder.write("campaign.toml", "[campaign]\nscenario = 'scene.toml'\n");
  CHECK(test::message([&] { read_campaign(file); }).find(":2:12: ") != std::string::npos);
}

TEST_CASE("a long list of values is refused in little time", "[campaign]") {
  std::string values;
  for (int k = 0; k < 150000; ++k) values += std::to_string(k) + ",";
  const std::clock_t start = std::clock();
  starts(refusal_of("[set]\nscene.seed = [" + values + "]\n"),
         "campaign.toml:4:15: scene.seed cannot be in [set]; ");
  // It takes 0.4 s; comparing each value with all before it took 22 s.
  CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 10);
}

TEST_CASE("a campaign of spectra names a method, needs a scene with a spectrum and collects no series",
          "[campaign]") {
  CHECK_THAT(CampaignFolder("spectrum = 'sweeep'\n").refusal(),
             Catch::StartsWith("campaign.toml:3:12: there is no method 'sweeep'; give \"sweep\", "));
  CHECK_THAT(CampaignFolder("spectrum = 'pulse'\ncollect = ['energy.work.last']\n").refusal(),
             Catch::StartsWith("campaign.toml:4:11: spectra have no series to collect from; "));
  CHECK_THAT(CampaignFolder("spectrum = 'pulse'\n").refusal(),
             Catch::Contains("campaign.toml:2:12: ") &&
                 Catch::Contains("scene.toml has no [spectrum] to measure; "));
}
