#include "campaign_support.hpp"

#include <catch2/catch.hpp>

#include <scree/campaign/campaign.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;

namespace {

const std::string prepare = "[prepare]\nscenario = 'prepare.toml'\n";

std::string refusal(const std::string& rest) {
  const CampaignFolder folder(rest);
  folder.folder().write("prepare.toml", test::discs);
  return folder.refusal();
}

}  // namespace

TEST_CASE("a campaign has one preparation per seed, with its own settings", "[campaign]") {
  const CampaignFolder folder("seeds = [7, 8]\n[set]\n\"contact.normal_stiffness\" = [1e4, 2e4]\n" + prepare +
                              "set.particles.lattice.count = [2, 2]\n");
  folder.folder().write("prepare.toml", test::discs);
  const Campaign c = branched(folder.read(), test::host());
  REQUIRE(c.preparation);
  REQUIRE(c.preparation->points.size() == 2);
  CHECK(c.preparation->points[1].overrides() ==
        std::vector<std::string>{"particles.lattice.count=[2, 2]", "scene.seed=8"});
  // Seeds vary fastest.
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(c.points[k].seed == c.preparation->points[c.preparation_of[k]].seed);
    const std::string name = c.preparation->points[k % 2].name;
    REQUIRE(name.size() == std::string("prepare/0123456789abcdef").size());
    CHECK(c.points[k].find("particles.state")->value == '"' + name.substr(8) + "/final_state.h5\"");
  }
  CHECK(c.points[0].name == "normal_stiffness=10000,seed=7");
}

TEST_CASE("of several [[particles]], the table without other bodies takes the state of the preparation",
          "[campaign]") {
  const auto scene_with = [](const std::string& particles) {
    std::string scene = test::discs;
    const std::size_t begin = scene.find("[particles]"), end = scene.find("\n[", begin + 1);
    REQUIRE(end != scene.npos);
    return scene.replace(begin, end + 1 - begin, particles);
  };
  const std::string wall = "[[particles]]\nname = 'rough'\nradius = 0.01\nlattice = { count = [1, 1] }\n";
  const auto refusal = [&](const std::string& particles) {
    const CampaignFolder folder(prepare, scene_with(particles));
    folder.folder().write("prepare.toml", test::discs);
    return folder.refusal();
  };
  const CampaignFolder folder(prepare, scene_with(wall + "[[particles]]\nname = 'bed'\n"));
  folder.folder().write("prepare.toml", test::discs);
  const Campaign c = branched(folder.read(), test::host());
  REQUIRE(c.points.size() == 1);
  CHECK(c.points[0].find("particles[1].state"));
  CHECK_FALSE(c.points[0].find("particles.state"));
  CHECK_THAT(refusal(wall + wall), Catch::Contains("none of its 2 tables [[particles]] can take the state"));
  CHECK_THAT(refusal("[[particles]]\n[[particles]]\n"), Catch::Contains("more than one of its 2 tables"));
}

TEST_CASE("cases may have preparations of their own, and share those that are the same", "[campaign]") {
  const CampaignFolder folder(
      "seeds = [7, 8]\n[[case]]\nname = 'soft'\nprepare.contact.normal_stiffness = 1e3\n"
      "[[case]]\nname = 'hard'\nprepare.contact.normal_stiffness = 1e5\n"
      "[[case]]\nname = 'hard and long'\nset.time.duration = 2e-4\nprepare.contact.normal_stiffness = 1e5\n"
      "[set]\n\"contact.normal_damping\" = [0, 1]\n" +
      prepare);
  folder.folder().write("prepare.toml", test::discs);
  const Campaign c = branched(folder.read(), test::host());
  REQUIRE(c.points.size() == 12);
  REQUIRE(c.preparation->points.size() == 4);
  for (std::size_t k = 0; k < 12; ++k) {
    const Point& from = c.preparation->points[c.preparation_of[k]];
    CHECK(c.points[k].seed == from.seed);
    CHECK(from.find("contact.normal_stiffness")->value ==
          (c.points[k].case_name == "soft" ? "1000.0" : "100000.0"));
    CHECK(c.points[k].find("particles.state")->value == '"' + from.name.substr(8) + "/final_state.h5\"");
  }
}

TEST_CASE("without seeds a campaign has one preparation, with the seed of its scenario", "[campaign]") {
  const CampaignFolder folder("[set]\n\"contact.normal_stiffness\" = [1e4, 2e4]\n" + prepare);
  folder.folder().write("prepare.toml", test::discs);
  const Campaign c = branched(folder.read(), test::host());
  REQUIRE(c.preparation->points.size() == 1);
  CHECK(c.preparation->points[0].overrides().empty());
}

TEST_CASE("the name of a preparation follows from what it reads", "[campaign]") {
  const CampaignFolder folder(prepare);
  const auto name = [&](const std::string& scene) {
    folder.folder().write("prepare.toml", scene);
    return branched(folder.read(), test::host()).preparation->points[0].name;
  };
  const std::string first = name(test::discs);
  CHECK(name("# a comment\n" + std::string(test::discs)) == first);
  CHECK(name(test::with(test::discs, "normal_damping = 0", "normal_damping = 1")) != first);
}

TEST_CASE("an error in [prepare] is reported with position and cure", "[campaign]") {
  CHECK_THAT(refusal("[prepare]\nsceario = 'prepare.toml'\n"), Catch::StartsWith("campaign.toml:3:1: "));
  CHECK_THAT(refusal("[prepare]\nscenario = 'none.toml'\n"),
             Catch::StartsWith("campaign.toml:4:12: none.toml: cannot be read ("));
  CHECK_THAT(refusal("[set]\nparticles.state = ['a.h5']\n" + prepare),
             Catch::StartsWith("campaign.toml:4:20: 'particles.state' is also set by [prepare]; "));
  CHECK_THAT(refusal("seeds = [1]\n" + prepare + "set.scene.seed = 2\n"),
             Catch::StartsWith("campaign.toml:6:18: 'scene.seed' is also set by seeds; "));
  CHECK_THAT(
      refusal("[[case]]\nname = 'a'\nprepare.scene.title = 'b'\n"),
      Catch::StartsWith(
          "campaign.toml:5:23: a case sets 'scene.title' of its preparation, but there is no [prepare]; "));
  CHECK_THAT(refusal(prepare + "more = 1\n"), Catch::StartsWith("campaign.toml:5:1: unknown key 'more'"));
}

TEST_CASE("a preparation that would be refused is reported at its value", "[campaign]") {
  const auto problem = [](const std::string& set) {
    const CampaignFolder folder(prepare + set);
    folder.folder().write("prepare.toml", test::discs);
    return test::message([&] {
      const Campaign c = branched(folder.read(), test::host());
      check_preparation(*c.preparation, c.preparation->points[0], test::host());
    });
  };
  CHECK_THAT(problem("set.contact.normal_stiffness = -1\n"),
             Catch::Contains("campaign.toml:5:32: in run 'prepare/") && Catch::Contains("a number above 0"));
  CHECK_THAT(problem("set.checkpoint.final_state = false\n"),
             Catch::Contains("campaign.toml:4:12: ") &&
                 Catch::Contains("writes no final state, from which runs could begin; remove "));
}
