#include "campaign_support.hpp"

#include <chrono>

#include <catch2/catch.hpp>

#include <scree/campaign/outcome.hpp>

using namespace scree;
using namespace scree::campaign;
using test::CampaignFolder;
using test::make_run;
using test::outcome_of;
using test::starts;

namespace {

namespace fs = std::filesystem;

// Discs that begin from bodies.csv.
std::string scene_from_file() {
  return test::with(test::with(test::discs, "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n",
                               "file = 'bodies.csv'\n"),
                    "radius = 0.01\n", "");
}

void append(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::app) << text;
}

}  // namespace

TEST_CASE("a run counts only for the same content of its file of bodies, whatever its date", "[campaign]") {
  const CampaignFolder source(""), folder("", scene_from_file());
  make_run(source.read(), 0, source.folder() / "out");
  const std::string packing = test::text_of(source.folder() / "out/final_packing.csv");
  const fs::path bodies = folder.folder().write("bodies.csv", packing);
  const Campaign c = folder.read();
  const fs::path out = folder.folder() / "out";
  make_run(c, 0, out);
  CHECK(outcome_of(c, 0, out).status == Status::finished);
  fs::last_write_time(bodies, fs::last_write_time(out / "run.json") + std::chrono::hours(1));
  CHECK(outcome_of(c, 0, out).status == Status::finished);
  // Of the same size, and older than the run.
  std::string other = packing;
  other[other.rfind('1')] = '2';
  folder.folder().write("bodies.csv", other);
  fs::last_write_time(bodies, fs::last_write_time(out / "run.json") - std::chrono::hours(1));
  CHECK(outcome_of(c, 0, out).status == Status::changed);
  folder.folder().write("bodies.csv", packing);
  CHECK(outcome_of(c, 0, out).status == Status::finished);
  fs::remove(bodies);
  CHECK(outcome_of(c, 0, out).status == Status::changed);
}

TEST_CASE("a run counts only for the same content of its plug-ins, wherever they are", "[campaign]") {
  const CampaignFolder folder("");
  const Campaign c = folder.read();
  const fs::path out = folder.folder() / "out", plugins = folder.folder() / "plugins";
  make_run(c, 0, out);
  for (const char* library : {"contact/linear_spring_dashpot.so", "boundary/box.so", "probe/energy.so"}) {
    fs::create_directories((plugins / library).parent_path());
    fs::copy_file(fs::path(SCREE_TEST_PLUGINS) / library, plugins / library);
  }
  const PluginHost copies({plugins});
  CHECK(outcome_of(c, 0, out, copies).status == Status::finished);
  append(plugins / "probe/energy.so", "built again");
  CHECK(outcome_of(c, 0, out, copies).status == Status::changed);
  CHECK(outcome_of(c, 0, out).status == Status::finished);
  // One that the scene does not use.
  append(plugins / "contact/hertz_mindlin.so", "no library");
  fs::copy_file(fs::path(SCREE_TEST_PLUGINS) / "probe/energy.so", plugins / "probe/energy.so",
                fs::copy_options::overwrite_existing);
  CHECK(outcome_of(c, 0, out, copies).status == Status::finished);
}

TEST_CASE("a run of a former version, which did not record its inputs, counts as changed", "[campaign]") {
  const CampaignFolder folder("");
  const Campaign c = folder.read();
  const fs::path out = folder.folder() / "out";
  make_run(c, 0, out);
  folder.folder().write("out/run.json",
                        test::with(test::text_of(out / "run.json"), "\"inputs\"", "\"outputs\""));
  CHECK(outcome_of(c, 0, out).status == Status::changed);
}

TEST_CASE("a run that would be refused is reported at the value that causes it", "[campaign]") {
  starts(CampaignFolder("[set]\n\"contact.normal_stiffness\" = [1e4, -1]\n").refusal(),
         "campaign.toml:4:36: in run 'normal_stiffness=-1' --set contact.normal_stiffness=-1: ");
  starts(CampaignFolder("[set]\n\"contact.normal_stiffness\" = 1e14\n").refusal(),
         "campaign.toml:2:12: in run 'run' scene.toml:4:8: the time step of 1e-05 s is too long: ");
  starts(CampaignFolder(
             "[set]\n\"contact[0].normal_stiffness\" = 2e4\n\"contact.normal_stiffness\" = [1e4, 3e4]\n")
             .refusal(),
         "campaign.toml:4:33: in run 'normal_stiffness=10000' --set contact[0].normal_stiffness=20000.0 is "
         "undone by --set contact.normal_stiffness=10000.0; ");
  CHECK(
      CampaignFolder("[set]\nparticles.lattice.count = [3, 4]\ncontact = [1]\n").refusal().find("[[...]]") ==
      std::string::npos);
  CHECK(CampaignFolder("[set]\nparticles.lattice.origin = [0, 1]\n").refusal().find("write [[...]]") !=
        std::string::npos);
  starts(CampaignFolder("collect = ['energy.wrk.last']\n").refusal(),
         "campaign.toml:3:11: no quantity 'energy.wrk.last'; did you mean 'energy.work.last'?");
  starts(CampaignFolder("collect = ['energy.work.last', 'steps', 'energy.work.last']\n").refusal(),
         "campaign.toml:3:41: 'energy.work.last' appears twice in the list; remove one");
}
