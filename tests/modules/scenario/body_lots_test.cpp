#include "discs_tables.hpp"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

// Six discs beside the nine of `discs`.
const std::string beside =
    "[[particles]]\nname = 'beside'\nlattice = { kind = 'square', count = [2, 3], origin = [1, 0] }\n"
    "radius = 0.02\nrandom_velocity = 0.1\n";

const std::string first_lot = with(particles_of_discs, "[particles]", "[[particles]]");

// The plan of such a scene beside a file packing.csv.
Plan plan_with_file(const std::string& csv, const std::string& tables) {
  const TemporaryFolder folder;
  folder.write("packing.csv", csv);
  return read_plan(folder.write("scene.toml", scene_with_lots(tables)), {}, host());
}

std::vector<std::string> texts_of(const Plan& plan) {
  std::vector<std::string> texts;
  for (const BodySource& source : plan.body_sources) texts.push_back(source.text());
  return texts;
}

}  // namespace

TEST_CASE("several tables of bodies stand side by side, and each body belongs to its table by its id",
          "[scenario]") {
  const Plan plan = plan_of(scene_with_lots(first_lot + beside +
                                            "[[particle]]\nposition = [3, 0]\nradius = 0.03\n"
                                            "[[particle]]\nname = 'stone'\nposition = [4, 0]\nradius = 0.04\n"
                                            "[[particle]]\nposition = [5, 0]\nradius = 0.03\n"));
  REQUIRE(plan.scene.bodies.size() == 18);
  CHECK(texts_of(plan) == std::vector<std::string>{"particles: 9 bodies of a lattice, square; ids 1 to 9",
                                                   "beside: 6 bodies of a lattice, square; ids 10 to 15",
                                                   "particle: 2 bodies; ids 16 ... 18",
                                                   "stone: 1 body; id 17"});
  for (const Body& body : plan.scene.bodies) {
    CAPTURE(body.id);
    CHECK(body.radius == (body.id <= 9 ? 0.01 : body.id <= 15 ? 0.02 : body.id == 17 ? 0.04 : 0.03));
  }
}

TEST_CASE("one table of bodies has the same bits in either notation, and as the first of several",
          "[scenario]") {
  const std::vector<Body> alone = plan_of(discs).scene.bodies;
  for (const std::string& tables : {first_lot, first_lot + beside}) {
    const std::vector<Body> bodies = plan_of(scene_with_lots(tables)).scene.bodies;
    REQUIRE(bodies.size() >= alone.size());
    for (std::size_t k = 0; k < alone.size(); ++k) {
      CHECK(bodies[k].id == alone[k].id);
      CHECK(bodies[k].position == alone[k].position);
      CHECK(bodies[k].velocity == alone[k].velocity);
    }
  }
}

TEST_CASE("the random numbers of a table do not depend on those that another draws", "[scenario]") {
  const auto velocity = [](const std::string& tables) {
    return plan_of(scene_with_lots(tables)).scene.bodies.back().velocity;
  };
  const Vec3 drawn = velocity(first_lot + beside);
  CHECK(norm(drawn) > 0);
  CHECK(velocity(with(first_lot, "count = [3, 3]", "count = [5, 3]") + beside) == drawn);
  // Nor are they those of the first table.
  const std::string same = with(first_lot, "[[particles]]", "[[particles]]\nname = 'same'");
  const std::vector<Body> bodies = plan_of(scene_with_lots(first_lot + same)).scene.bodies;
  CHECK_FALSE(bodies[0].velocity == bodies[9].velocity);
}

TEST_CASE("given ids are kept, and all other bodies are numbered after the largest", "[scenario]") {
  const std::string file = "[[particles]]\nname = 'file'\nfile = 'packing.csv'\n";
  const Plan plan = plan_with_file("id,x,y,radius\n7,1,0,0.1\n3,2,0,0.1\n", first_lot + file);
  CHECK(texts_of(plan) == std::vector<std::string>{"particles: 9 bodies of a lattice, square; ids 8 to 16",
                                                   "file: 2 bodies of 'packing.csv', CSV; ids 3 ... 7"});
  const Plan without = plan_with_file("x,y,radius\n1,0,0.1\n2,0,0.1\n", first_lot + file);
  CHECK(texts_of(without)[1] == "file: 2 bodies of 'packing.csv', CSV; ids 10 to 11");
}

TEST_CASE("a packing that is read twice is numbered anew where that is asked for", "[scenario]") {
  const std::string csv = "id,x,y,radius\n7,1,0,0.1\n3,2,0,0.1\n";
  const std::string once = "[[particles]]\nfile = 'packing.csv'\n",
                    twice = once + once + "velocity = [1, 0]\n";
  CHECK_THAT(message([&] { plan_with_file(csv, twice); }),
             Catch::Contains("scene.toml:16:8: two bodies have the id 7, one of them in this file; set "
                             "keep_ids = false to number the bodies of the file anew"));
  CHECK(texts_of(plan_with_file(csv, twice + "keep_ids = false\n"))[1] ==
        "particles_2: 2 bodies of 'packing.csv', CSV; ids 8 to 9");
}

TEST_CASE("names of tables of bodies differ", "[scenario]") {
  CHECK_THAT(refusal(scene_with_lots(first_lot + beside + beside)),
             Catch::Contains("the particles name 'beside' is already in use; give each a different name"));
  CHECK_THAT(refusal(scene_with_lots(first_lot + beside +
                                     "[[particle]]\nname = 'beside'\nposition = [5, 0]\nradius = 0.1\n")),
             Catch::Contains("the particles name 'beside' is already in use"));
  // Names that are made up make way for given ones.
  const Plan plan = plan_of(scene_with_lots(first_lot + with(beside, "'beside'", "'particles'")));
  CHECK(plan.body_sources[0].name == "particles_2");
  CHECK(plan.body_sources[1].name == "particles");
  CHECK(plan_of(scene_with_lots(first_lot + beside), {"particles.beside.radius=0.03"})
            .scene.bodies.back()
            .radius == 0.03);
}

TEST_CASE("a scenario depends on the files of all its tables, which get absolute paths for other folders",
          "[scenario]") {
  const TemporaryFolder folder;
  folder.write("a.csv", "x,y,radius\n0,0,0.1\n");
  folder.write("b.csv", "x,y,radius\n1,0,0.1\n");
  const auto file = folder.write(
      "scene.toml", scene_with_lots("[[particles]]\nfile = 'a.csv'\n[[particles]]\nfile = './b.csv'\n"));
  const Plan plan = read_plan(file, {}, host());
  CHECK(plan.inputs == std::vector<std::filesystem::path>{file, folder / "a.csv", folder / "b.csv"});
  const TemporaryFolder other;
  const Plan moved = read_plan(other.write("scene.toml", plan.text_for_any_folder), {}, host());
  CHECK(moved.inputs[1] == folder / "a.csv");
  CHECK(moved.inputs[2] == folder / "b.csv");
}
