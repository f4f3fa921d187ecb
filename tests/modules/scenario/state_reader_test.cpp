#include "plan_support.hpp"

#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>

#include <scree/simulation.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

const std::string from_state = with(
    discs, "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\nrandom_velocity = 0.1\n",
    "state = 'packings/a.h5'\n");  // 14

// A folder with scenes/scene.toml, and the state of `discs` in any other.
struct States {
  TemporaryFolder folder;
  fs::path scene;

  explicit States(const std::string& text = from_state) {
    fs::create_directory(folder / "scenes");
    scene = folder.write("scenes/scene.toml", text);
  }
  void write(const std::string& name) const {
    fs::create_directories((folder / name).parent_path());
    state_file::write_state(folder / name, Simulation(plan_of(discs).scene).state());
  }
  Plan plan(const std::vector<std::string>& overrides = {}) const {
    return read_plan(scene, overrides, host());
  }
  // The refusal, without the path of the scene.
  std::string refused(const std::vector<std::string>& overrides = {}) const {
    return message([&] { plan(overrides); }).substr(scene.string().size());
  }
};

// SCREE_STATE_PATH, until the end of a scope.
struct StatePath {
  explicit StatePath(const std::string& folders) { ::setenv("SCREE_STATE_PATH", folders.c_str(), 1); }
  ~StatePath() { ::unsetenv("SCREE_STATE_PATH"); }
};

}  // namespace

TEST_CASE("the bodies of a state are those that were saved, with the materials of the scene by name",
          "[scenario]") {
  const States states(
      with(with(from_state, "[[material]]\n", "[[material]]\nname = 'other'\ndensity = 1\n[[material]]\n"),
           "plugin = 'box'\n", "plugin = 'box'\nmaterial = 'grain'\n"));
  states.write("scenes/packings/a.h5");
  const std::vector<Body> saved = plan_of(discs).scene.bodies, read = states.plan().scene.bodies;
  REQUIRE(read.size() == saved.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    CHECK(read[k].id == saved[k].id);
    CHECK(read[k].position == saved[k].position);
    CHECK(read[k].velocity == saved[k].velocity);
    CHECK(read[k].mass == saved[k].mass);
    CHECK(read[k].material == 1);
  }
  CHECK(states.refused({"material[1].name='sand'", "boundary.material='sand'"})
            .ends_with(": the state has bodies of the material 'grain'; add a [[material]] of this name"));
}

TEST_CASE("a state is looked for beside the scenario, and then in the folders of SCREE_STATE_PATH",
          "[scenario]") {
  const States states;
  CHECK(states.refused().starts_with(":14:9: there is no file 'packings/a.h5'; "));
  states.write("first/packings/a.h5");
  states.write("second/packings/a.h5");
  CHECK(states.refused().starts_with(":14:9: there is no file 'packings/a.h5'; "));
  const StatePath path((states.folder / "none").string() + "::" + (states.folder / "second").string() + ":" +
                       (states.folder / "first").string());
  CHECK(states.plan().files.bodies == std::vector{fs::canonical(states.folder / "second/packings/a.h5")});
  states.write("scenes/packings/a.h5");
  CHECK(states.plan().files.bodies == std::vector{fs::canonical(states.folder / "scenes/packings/a.h5")});
}

TEST_CASE("a state outside the folders that a scenario may read is refused, also through a link",
          "[scenario]") {
  const States states;
  states.write("elsewhere/a.h5");
  const std::string outside =
      "is outside the folder of the scenario and the working folder; name its folder in the environment variable "
      "SCREE_STATE_PATH";
  CHECK_THAT(states.refused({"particles.state='../elsewhere/a.h5'"}), Catch::EndsWith(outside));
  fs::create_directory(states.folder / "scenes/packings");
  fs::create_symlink(states.folder / "elsewhere/a.h5", states.folder / "scenes/packings/a.h5");
  CHECK_THAT(states.refused(), Catch::EndsWith(outside));
  const StatePath path((states.folder / "elsewhere").string());
  CHECK(states.plan().scene.bodies.size() == 9);
}

TEST_CASE("what is left out of a state is named", "[scenario]") {
  const States states;
  states.write("scenes/packings/a.h5");
  const Branching all = states.plan().branching,
                  less = states.plan({"particles.leave_out=['walls', 'histories']"}).branching;
  CHECK((all.histories && all.walls && all.orientations));
  CHECK((!less.histories && !less.walls && less.orientations));
  CHECK_THAT(states.refused({"particles.leave_out=['walls', 'histores']"}),
             Catch::EndsWith("no part 'histores'; did you mean 'histories'?"));
}

TEST_CASE("a state whose ids are not above 0 or are used twice is refused", "[scenario]") {
  const std::int64_t id = GENERATE(0, 2);
  const States states;
  states.write("scenes/packings/a.h5");
  const fs::path file = states.folder / "scenes/packings/a.h5";
  State state = state_file::read_state(file);
  StateArray ids = state.at("bodies/id");
  std::get<std::vector<std::int64_t>>(ids.values).at(0) = id;
  state.put("bodies/id", std::move(ids));
  state_file::write_state(file, state);
  CHECK_THAT(states.refused(), Catch::Contains("has an id that is not above 0 or is used twice"));
}

TEST_CASE("bodies of other tables are added to those of a state, which keep their order and come first",
          "[scenario]") {
  const std::string lattice =
      "[[particles]]\nlattice = { kind = 'square', count = 1, origin = [0.022, 0.022], centred = true }\nradius = 0.003\n";
  const States states(with(from_state, "[particles]\n", lattice + "[[particles]]\n"));
  states.write("scenes/packings/a.h5");
  const Plan plan = states.plan();
  const std::vector<Body>& bodies = plan.scene.bodies;
  const std::vector<Body> saved = plan_of(discs).scene.bodies;
  REQUIRE(bodies.size() == 10);
  for (std::size_t k = 0; k < saved.size(); ++k) CHECK(bodies[k].id == saved[k].id);
  CHECK(bodies[9].id == 10);
  CHECK(plan.body_sources[0].text() == "particles_2: 9 bodies of the state 'packings/a.h5'; ids 1 to 9");
  CHECK(Simulation(plan.scene, *plan.from_state, plan.branching).particles().size() == 10);
  const States two(
      with(from_state, "[particles]\n", "[[particles]]\nstate = 'packings/a.h5'\n[[particles]]\n"));
  two.write("scenes/packings/a.h5");
  CHECK(two.refused() ==
        ":16:9: two tables [[particles]] begin from a state; "
        "keep one, and take the bodies of the other from its final_packing.csv");
}
