#include "campaign_support.hpp"

#include <ctime>
#include <set>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::names_of;

namespace {

using Texts = std::vector<std::string>;

std::string refusal(const std::string& rest) { return CampaignFolder(rest).refusal(); }

bool starts(const std::string& line, const std::string& with) {
  INFO(line);
  CHECK(line.starts_with(with));
  return line.starts_with(with);
}

}  // namespace

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

TEST_CASE("keys may be quoted, dotted or under headers; inline tables and inner lists are values",
          "[campaign]") {
  const Campaign c = CampaignFolder(
                         "[set]\n"
                         "particles.lattice.count = [[3, 3], [2, 3]]\n"
                         "[set.time]\nstep = [{ fraction = 0.01 }, 1e-6]\n"
                         "[set.\"boundary[0]\"]\ngap = 0.004\n")
                         .read();
  CHECK(names_of(c) == Texts{"count=3_3,step=fraction_0.01", "count=3_3,step=1e-6",
                             "count=2_3,step=fraction_0.01", "count=2_3,step=1e-6"});
  CHECK(c.points[0].overrides() ==
        Texts{"boundary[0].gap=0.004", "particles.lattice.count=[3, 3]", "time.step={ fraction = 0.01 }"});
}

TEST_CASE("in a case a list is a value", "[campaign]") {
  const Campaign c =
      CampaignFolder("[[case]]\nname = 'small'\nset.particles.lattice.count = [2, 2]\n").read();
  CHECK(c.points[0].overrides() == Texts{"particles.lattice.count=[2, 2]"});
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

TEST_CASE("an error in a campaign file is reported with position and cure", "[campaign]") {
  starts(refusal("sead = 3\n"), "campaign.toml:3:1: unknown key 'sead' in [campaign]");
  starts(refusal("seeds = 3\n"),
         "campaign.toml:3:9: seeds is neither a list nor a table; give whole numbers");
  starts(refusal("seeds = []\n"), "campaign.toml:3:9: the list of seeds is empty; ");
  starts(refusal("seeds = [1, 2, 1]\n"), "campaign.toml:3:16: seed 1 appears twice in the list; ");
  starts(refusal("seeds = [1.5]\n"), "campaign.toml:3:10: ");
  starts(refusal("seeds = { count = 0 }\n"), "campaign.toml:3:19: campaign.seeds.count = 0 is below 1; ");
  starts(refusal("[set]\na.b = []\n"), "campaign.toml:4:7: the list of 'a.b' is empty; ");
  starts(refusal("[set]\na.b = [1, 1]\n"), "campaign.toml:4:11: 1 appears twice in the list of 'a.b'; ");
  starts(refusal("[set]\na.b = 1\n\"a.b\" = 2\n"), "campaign.toml:5:9: 'a.b' is set twice; ");
  starts(refusal("[set]\nscene.seed = [1, 2]\n"), "campaign.toml:4:15: scene.seed cannot be in [set]; ");
  starts(refusal("seeds = [1]\n[set]\nscene.seed = 1\n"),
         "campaign.toml:5:14: 'scene.seed' is also set by seeds; ");
  starts(refusal("[set]\na.b = 1\n[[case]]\nname = 'x'\nset.a.b = 2\n"),
         "campaign.toml:7:11: 'a.b' is also set by [set] or --set; ");
  starts(refusal("[[case]]\nname = 'x'\n[[case]]\nname = 'x'\n"),
         "campaign.toml:6:8: the case name 'x' is already in use; ");
  starts(refusal("seeds = { count = 100000 }\n[set]\na.b = [1, 2]\n"),
         "campaign.toml:1:1: the campaign has more than 100000 runs; ");
}

TEST_CASE("values of the command line replace those of a campaign file", "[campaign]") {
  const CampaignFolder folder(
      "seeds = [1, 2, 3]\n"
      "[set]\n"
      "\"contact.normal_stiffness\" = [1e4, 2e4]\n"
      "time.step = 1e-6\n"
      "particles.random_velocity = [0.1, 0.2]\n");
  const Campaign one = folder.read({"campaign.seeds=[2]", "contact.normal_stiffness=2e4", "time.step=2e-6"});
  CHECK(names_of(one) == Texts{"random_velocity=0.1,seed=2", "random_velocity=0.2,seed=2"});
  CHECK(one.points[0].overrides() == Texts{"time.step=2e-6", "contact.normal_stiffness=20000.0",
                                           "particles.random_velocity=0.1", "scene.seed=2"});
  // A shorter list has the same names of runs; a new key is another parameter.
  const Campaign two =
      folder.read({"campaign.seeds=[3]", "contact.normal_stiffness=[1e4]", "time.step=[1e-6, 2e-6]"});
  CHECK(names_of(two) == Texts{"normal_stiffness=10000,random_velocity=0.1,step=1e-6,seed=3",
                               "normal_stiffness=10000,random_velocity=0.1,step=2e-6,seed=3",
                               "normal_stiffness=10000,random_velocity=0.2,step=1e-6,seed=3",
                               "normal_stiffness=10000,random_velocity=0.2,step=2e-6,seed=3"});
}

TEST_CASE("values of the command line that do not fit a campaign are refused", "[campaign]") {
  const CampaignFolder folder("seeds = [1]\n[[case]]\nname = 'x'\nset.contact.normal_stiffness = 2e4\n");
  const auto refusal = [&](const std::string& text) { return folder.refusal({text}); };
  starts(refusal("time.step"), "--set time.step: is not KEY=VALUE; ");
  starts(refusal("=3"), "--set =3: is not KEY=VALUE; ");
  starts(refusal("time.step="), "--set 'time.step'=: has no value; ");
  starts(refusal("time.step=[]"), "--set 'time.step'=[]: the list of 'time.step' is empty; ");
  starts(refusal("time.step=[1e-6, 1e-6]"),
         "--set 'time.step'=[1e-6, 1e-6]: 1e-6 appears twice in the list of 'time.step'; ");
  starts(refusal("time.stap=1"), "--set 'time.stap'=1: in run 'case=x,seed=1' ");
  starts(refusal("campaign.sead=1"), "--set campaign.sead=1: unknown key 'sead' in [campaign]");
  starts(refusal("prepare.time.step=1"), "--set prepare.time.step=1: the campaign has no [prepare]; ");
  starts(refusal("scene.seed=1"), "--set 'scene.seed'=1: 'scene.seed' is also set by seeds; ");
  starts(refusal("contact.normal_stiffness=3"),
         "campaign.toml:6:32: 'contact.normal_stiffness' is also set by [set] or --set; ");
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
  starts(refusal("[set]\nscene.seed = [" + values + "]\n"),
         "campaign.toml:4:15: scene.seed cannot be in [set]; ");
  // It takes 0.4 s; comparing each value with all before it took 22 s.
  CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 10);
}

TEST_CASE("a run that would be refused is reported at the value that causes it", "[campaign]") {
  starts(refusal("[set]\n\"contact.normal_stiffness\" = [1e4, -1]\n"),
         "campaign.toml:4:36: in run 'normal_stiffness=-1' --set contact.normal_stiffness=-1: ");
  starts(refusal("[set]\n\"contact.normal_stiffness\" = 1e14\n"),
         "campaign.toml:2:12: in run 'run' scene.toml:4:8: the time step of 1e-05 s is too long: ");
  starts(refusal("[set]\n\"contact[0].normal_stiffness\" = 2e4\n\"contact.normal_stiffness\" = [1e4, 3e4]\n"),
         "campaign.toml:4:33: in run 'normal_stiffness=10000' --set contact[0].normal_stiffness=20000.0 is "
         "undone by --set contact.normal_stiffness=10000.0; ");
  CHECK(refusal("[set]\nparticles.lattice.count = [3, 4]\ncontact = [1]\n").find("[[...]]") ==
        std::string::npos);
  CHECK(refusal("[set]\nparticles.lattice.origin = [0, 1]\n").find("write [[...]]") != std::string::npos);
  starts(refusal("collect = ['energy.wrk.last']\n"),
         "campaign.toml:3:11: no quantity 'energy.wrk.last'; did you mean 'energy.work.last'?");
  starts(refusal("collect = ['energy.work.last', 'steps', 'energy.work.last']\n"),
         "campaign.toml:3:41: 'energy.work.last' appears twice in the list; remove one");
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
