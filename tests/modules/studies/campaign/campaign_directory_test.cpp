#include "campaign_support.hpp"

#include <cstdlib>

#include <catch2/catch.hpp>

#include <scree/campaign/campaign_directory.hpp>
#include <scree/campaign/report.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::make_run;

TEST_CASE("a campaign that writes nothing leaves no directory", "[campaign]") {
  const CampaignFolder folder("");
  const auto path = folder.folder() / "out";
  {
    const CampaignDirectory directory(path, folder.read(), true);
    CHECK(std::filesystem::exists(path));
  }
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("a directory is used by one campaign at a time, and only by its own", "[campaign]") {
  const CampaignFolder folder("");
  const Campaign c = folder.read();
  const auto path = folder.folder() / "out";
  {
    CampaignDirectory first(path, c, true);
    CHECK_THROWS_WITH(CampaignDirectory(path, c, true), Catch::Contains("another campaign is running there"));
    CHECK_NOTHROW(CampaignDirectory(path, c, false));
    first.files().write_file("campaign.json", "{ \"file\": \"other.toml\" }");
  }
  CHECK_THROWS_WITH(CampaignDirectory(path, c, true),
                    Catch::Contains("contains the campaign of other.toml; give"));
  // Campaign files of the same name: one that exists, and one that does not because both were moved.
  const test::TemporaryFolder elsewhere;
  const std::string other = elsewhere.write("campaign.toml", "").string();
  folder.folder().write("out/campaign.json", "{ \"file\": \"" + other + "\" }");
  CHECK_THROWS_WITH(CampaignDirectory(path, c, true), Catch::Contains("contains the campaign of " + other));
  std::filesystem::remove(other);
  CHECK_NOTHROW(CampaignDirectory(path, c, true));
  std::filesystem::remove(path / "campaign.json");
  folder.folder().write("out/letter.txt", "Dear");
  CHECK_THROWS_WITH(CampaignDirectory(path, c, true),
                    Catch::Contains("contains files that are not part of a scree campaign"));
}

TEST_CASE("runs with values that a campaign no longer has are reported", "[campaign]") {
  const CampaignFolder folder("[set]\ntime.duration = [1e-4, 2e-4]\n");
  const Campaign c = folder.read();
  CampaignDirectory directory(folder.folder() / "campaign", c, true);
  CHECK(directory.leftovers(c).empty());
  make_run(c, 0, directory.run(c.points[0]));
  make_run(c, 1, directory.run(c.points[1]));
  std::filesystem::create_directory(directory.files().path() / "no run");
  CHECK(directory.leftovers(c).empty());
  Campaign fewer = c;
  fewer.points.erase(fewer.points.begin());
  CHECK(directory.leftovers(fewer) == std::vector<std::string>{c.points[0].name});
  CHECK(leftover_report(directory.leftovers(fewer)) ==
        "1 run with values no longer in the campaign, not in the tables: duration=0.0001\n");
  CHECK(leftover_report({}) == "");
}

TEST_CASE("the folder of preparations is looked up before others, until the end of a campaign",
          "[campaign]") {
  const auto variable = [] {
    const char* text = std::getenv("SCREE_STATE_PATH");
    return std::string(text ? text : "unset");
  };
  {
    const StatePath first("one/prepare");
    CHECK(variable() == "one/prepare");
    {
      const StatePath second("two/prepare");
      CHECK(variable() == "two/prepare:one/prepare");
    }
    CHECK(variable() == "one/prepare");
  }
  CHECK(variable() == "unset");
  CHECK_THROWS_WITH(StatePath("a:b/prepare"), Catch::Contains("a:b: the path of a campaign with [prepare] "
                                                              "cannot contain ':'; give another --out"));
}

TEST_CASE("while its preparation is not there, a run is missing or changed", "[campaign]") {
  const CampaignFolder folder("[set]\n\"contact.normal_stiffness\" = [1e4, 2e4]\n" +
                              std::string("[prepare]\nscenario = 'prepare.toml'\n"));
  folder.folder().write("prepare.toml", test::discs);
  const Campaign c = branched(folder.read(), test::host());
  CampaignDirectory directory(folder.folder() / "campaign", c, true);
  test::make_run(*c.preparation, 0, directory.run(c.points[1]));
  const std::vector<Outcome> outcomes = directory.outcomes(c, test::host());
  CHECK(outcomes[0].status == Status::missing);
  CHECK(outcomes[1].status == Status::changed);
  CHECK(directory.preparations(c, test::host())[0].status == Status::missing);
  test::make_run(*c.preparation, 0, directory.run(c.preparation->points[0]));
  CHECK(directory.preparations(c, test::host())[0].status == Status::finished);
  CHECK(directory.leftovers(c).empty());
  std::filesystem::remove(directory.run(c.preparation->points[0]) / "final_state.h5");
  CHECK(directory.preparations(c, test::host())[0].status == Status::changed);
}

TEST_CASE("a run does not count while its preparation goes on, which removes its final state", "[campaign]") {
  std::string bare = test::discs;
  for (const char* line : {"lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n", "radius = 0.01\n",
                           "random_velocity = 0.1\n"})
    bare = test::with(bare, line, "");
  const CampaignFolder folder("[prepare]\nscenario = 'prepare.toml'\n", bare);
  folder.folder().write("prepare.toml", test::discs);
  const Campaign c = branched(folder.read(), test::host());
  CampaignDirectory directory(folder.folder() / "campaign", c, true);
  make_run(*c.preparation, 0, directory.run(c.preparation->points[0]));
  make_run(c, 0, directory.run(c.points[0]));
  CHECK(directory.outcomes(c, test::host())[0].status == Status::finished);
  // Stopped between the two.
  const std::string record = "campaign/" + c.preparation->points[0].name + "/run.json";
  const std::string text = test::text_of(folder.folder() / record);
  folder.folder().write(record, test::with(text, "\"finished\"", "\"interrupted\""));
  CHECK(directory.outcomes(c, test::host())[0].status == Status::changed);
}
