#include "campaign_support.hpp"

#include <set>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::names_of;
using test::Texts;

TEST_CASE("a campaign is the product of cases, lists and seeds, seeds fastest", "[campaign]") {
  const Campaign c = CampaignFolder(
                         "seeds = { first = 4, count = 2 }\n"
                         "[set]\n"
                         "\"contact.normal_stiffness\" = [1e4, 2e4]\n"
                         "time.step = 1e-6\n"
                         "[[case]]\nname = 'slow'\nset.particles.random_velocity = 0.1\n"
                         "[[case]]\nname = 'fast'\nset.particles.random_velocity = 0.2\n")
                         .read();
  REQUIRE(c.points.size() == 8);
  CHECK(names_of(c)[0] == "case=slow,normal_stiffness=10000,seed=4");
  CHECK(names_of(c)[1] == "case=slow,normal_stiffness=10000,seed=5");
  CHECK(names_of(c)[2] == "case=slow,normal_stiffness=20000,seed=4");
  CHECK(names_of(c)[7] == "case=fast,normal_stiffness=20000,seed=5");
  CHECK(c.points[7].overrides() == Texts{"time.step=1e-6", "particles.random_velocity=0.2",
                                         "contact.normal_stiffness=20000.0", "scene.seed=5"});
  CHECK(c.varying_keys() == Texts{"particles.random_velocity", "contact.normal_stiffness"});
  CHECK(c.title == "campaign");
}

TEST_CASE("a campaign without lists is one run", "[campaign]") {
  const Campaign c = CampaignFolder("title = 'One'\n").read();
  CHECK(names_of(c) == Texts{"run"});
  CHECK(c.points[0].overrides().empty());
  CHECK_FALSE(c.points[0].seed.has_value());
  CHECK(c.title == "One");
}

TEST_CASE("a long value without alternatives is not in the names of runs", "[campaign]") {
  const std::string probe = "{ plugin = 'energy', every = 1e-3, stages = ['one', 'two', 'three'] }";
  CHECK(names_of(
            CampaignFolder("seeds = [1]\n[set]\nprobe = [[" + probe + "]]\ntime.step = [1e-6]\n").read()) ==
        Texts{"step=1e-6,seed=1"});
  CHECK(names_of(CampaignFolder("[set]\nprobe = [[" + probe + "]]\n").read()) == Texts{"run"});
  const Campaign two = CampaignFolder("[set]\nprobe = [[" + probe + "], []]\n").read();
  CHECK(names_of(two)[0].starts_with("probe=plugin_energy_"));
  CHECK(names_of(two)[1] == "probe=");
}

TEST_CASE("names of runs are unique and do not change when values are added", "[campaign]") {
  const auto names = [](const std::string& set) { return names_of(CampaignFolder("[set]\n" + set).read()); };
  CHECK(names("a.gap = [1]\nb.gap = [2]\nb.seed = ['x/y']") == Texts{"a.gap=1,b.gap=2,b.seed=x_y"});
  const Texts alike = names("scene.title = ['a b', 'ab', 'a/b', '../../etc']");
  CHECK(std::set<std::string>(alike.begin(), alike.end()).size() == 4);
  CHECK(alike[2] == "title=a_b");
  CHECK(alike[3] == "title=.._.._etc");
  const std::string lengthy =
      "scene.title = ['" + std::string(300, 'x') + "1', '" + std::string(300, 'x') + "2']";
  const Texts cut = names(lengthy);
  CHECK(cut[0] != cut[1]);
  CHECK(cut[0].size() < 140);
  const Texts before = names("time.step = [1e-5]"), after = names("time.step = [2e-5, 1e-5]");
  CHECK(before[0] == after[1]);
}
