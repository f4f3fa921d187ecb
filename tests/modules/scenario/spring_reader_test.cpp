#include "discs_tables.hpp"
#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const std::string bodies_dump =
    "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n-1 1\n"
    "ITEM: ATOMS id x y z radius\n8 0.3 0.1 0 0.01\n2 0.1 0.1 0 0.01\n5 0.119 0.1 0 0.01\n";
const std::string pairs_dump =
    "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n-1 1\n"
    "ITEM: ENTRIES c_1[1] c_1[2] c_2[1] c_2[2]\n5 2 0.5 -1e-2\n";
const std::string spring_keys =
    "springs = { file = 'pairs.dump', columns = ['a', 'b', 'spring_x', 'spring_y'], factor = -1e-3 }\n";

struct Folder : TemporaryFolder {
  explicit Folder(const std::string& keys) {
    write("bodies.dump", bodies_dump);
    write("pairs.dump", pairs_dump);
    write("scene.toml", scene_with_lots("[particles]\nfile = 'bodies.dump'\n" + keys));
  }
  scenario::Plan plan() const { return scenario::read_plan(*this / "scene.toml", {}, host()); }
  std::string refusal() const {
    return message([&] { plan(); });
  }
};

}  // namespace

TEST_CASE("[particles] springs belong to the bodies with the ids of the file", "[scenario]") {
  const Folder folder(spring_keys);
  const scenario::Plan plan = folder.plan();
  REQUIRE(plan.scene.springs.size() == 1);
  const Scene::Spring& spring = plan.scene.springs[0];
  CHECK(plan.scene.bodies[spring.a].id == 5);
  CHECK(plan.scene.bodies[spring.b].id == 2);
  CHECK(spring.displacement == Vec3{{-5e-4, 1e-5, 0}});
  CHECK(plan.inputs.size() == 3);
  // The scenario can be run from any folder.
  CHECK_THAT(plan.text_for_any_folder, Catch::Contains((folder / "pairs.dump").string()));
}

TEST_CASE("springs without their bodies are refused, but where a region cuts the file", "[scenario]") {
  CHECK_THAT(Folder(spring_keys + "keep_ids = false\n").refusal(),
             Catch::Contains("which 'keep_ids' changes"));
  CHECK_THAT(Folder(spring_keys + "repeat = [2, 1]\nperiod = [1, 1]\n").refusal(),
             Catch::Contains("which 'repeat' changes"));
  CHECK_THAT(
      scree::test::refusal(scene_with_lots(particles_of_discs + "springs = { file = 'pairs.dump' }\n")),
      Catch::Contains("'springs' needs 'file', which is not given"));
  CHECK_THAT(Folder(spring_keys.substr(0, spring_keys.size() - 3) + ", factr = 1 }\n").refusal(),
             Catch::Contains("factr"));
  CHECK_THAT(Folder("springs = { file = 'none.dump' }\n").refusal(), Catch::Contains("none.dump"));
  const Folder other(spring_keys);
  other.write("pairs.dump", with(pairs_dump, "ENTRIES\n1", "ENTRIES\n2") + "4 2 0 0\n");
  CHECK_THAT(other.refusal(),
             Catch::Contains("line 11 of the springs names body 4, which is not one of the file; "));
  // Of several frames, the one of the step of the bodies, of several tables, the bodies of the table.
  const Folder frames(spring_keys);
  frames.write("pairs.dump",
               pairs_dump + with(with(pairs_dump, "TIMESTEP\n5", "TIMESTEP\n6"), "5 2 0.5", "5 2 7"));
  CHECK(frames.plan().scene.springs[0].displacement[0] == -5e-4);
  frames.write("pairs.dump", with(pairs_dump, "TIMESTEP\n5", "TIMESTEP\n6"));
  CHECK_THAT(frames.refusal(), Catch::Contains("there is no timestep 5"));
  const Folder tables(
      spring_keys +
      "[[particles]]\nlattice = { kind = 'square', count = [1, 1], origin = [0.5, 0.5] }\nradius = 0.01\n");
  tables.write("scene.toml", with(text_of(tables / "scene.toml"), "[particles]\n", "[[particles]]\n"));
  tables.write("pairs.dump", with(pairs_dump, "5 2 0.5", "5 9 0.5"));
  CHECK_THAT(tables.refusal(), Catch::Contains("names body 9, which is not one of the file"));
  const Folder cut(spring_keys + "region = { x = [0.2, 0.4], y = [0, 1] }\n");
  CHECK(cut.plan().scene.springs.empty());
}
