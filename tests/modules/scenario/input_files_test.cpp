#include "plan_support.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include <scree/scenario/input_files.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;
namespace fs = std::filesystem;
using paths = std::vector<fs::path>;

namespace {

InputFiles files_of(const std::string& text, const fs::path& scenario) {
  return input_files(document_of(text), scenario, host());
}

}  // namespace

TEST_CASE("a scenario depends on its plug-ins, each named by its kind and once", "[scenario]") {
  const InputFiles files = files_of(
      std::string(discs) +
          "[[probe]]\nplugin = 'energy'\n[[body_force]]\nplugin = 'gravty'\n[[probe]]\nname = 'none'\n",
      "scene.toml");
  CHECK(files.bodies.empty());
  REQUIRE(files.plugins.size() == 4);
  for (const char* name : {"contact/linear_spring_dashpot", "boundary/box", "probe/energy"}) {
    INFO(name);
    CHECK(fs::is_regular_file(files.plugins.at(name)));
    CHECK(files.plugins.at(name).stem() == fs::path(name).filename());
  }
  CHECK(files.plugins.at("body_force/gravty").empty());  // there is none
}

TEST_CASE("a file of bodies is found from the folder of its scenario, whether it is there or not",
          "[scenario]") {
  const std::string lattice =
      "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\nrandom_velocity = 0.1\n";
  const std::string text = with(discs, lattice, "file = '../packings/a.csv'\n");
  CHECK(files_of(text, "/scenes/david/scene.toml").bodies == paths{"/scenes/packings/a.csv"});
  CHECK(files_of(text, "david/scene.toml").bodies == paths{fs::current_path() / "packings/a.csv"});
  const TemporaryFolder folder;
  folder.write("state.h5", "");
  const std::string from_state = with(discs, lattice, "state = 'state.h5'\n");
  CHECK(files_of(from_state, folder / "scene.toml").bodies == paths{fs::canonical(folder / "state.h5")});
}
