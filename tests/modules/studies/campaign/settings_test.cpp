#include "campaign_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::names_of;
using test::starts;
using test::Texts;

TEST_CASE("keys may be quoted, dotted or under headers, inline tables and inner lists are values",
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
