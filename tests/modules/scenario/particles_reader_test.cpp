#include "plan_support.hpp"

#include <set>

#include <catch2/catch.hpp>

using scree::test::plan_of;
using scree::test::refusal;
using scree::test::TemporaryFolder;

namespace {

std::string scene_with_keys(const std::string& keys) {
  return "[time]\nstep = 1e-6\nduration = 1e-5\n[[material]]\nname = 'a'\ndensity = 1\n"
         "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1\nnormal_damping = 0\n"
         "[particles]\nfile = 'two.csv'\n" +
         keys;
}

}  // namespace

TEST_CASE("a packing is repeated along each axis, one period apart, and the copies get new ids",
          "[scenario]") {
  const TemporaryFolder folder;
  folder.write("two.csv", "id,x,y,z,radius\n7,0.5,0,0,0.1\n8,0.5,1,0,0.2\n");
  const auto file = folder.write("scene.toml", scene_with_keys("repeat = [3, 1, 2]\nperiod = [1, 2, 4]\n"));
  const auto bodies = scree::scenario::read_plan(file, {}, scree::test::host()).scene.bodies;
  REQUIRE(bodies.size() == 12);
  double x = 0, z = 0;
  std::set<std::int64_t> ids;
  for (const scree::Body& b : bodies) x += b.position[0], z += b.position[2], ids.insert(b.id);
  CHECK(x == 12 * 1.5);
  CHECK(z == 12 * 2);
  CHECK(ids.size() == 12);
}

TEST_CASE("bodies without an id are refused if the largest id leaves none", "[scenario]") {
  const TemporaryFolder folder;
  folder.write("two.csv", "id,x,y,z,radius\n1000000000000000,0.5,0,0,0.1\n");
  const auto error = [&](const std::string& keys) {
    return scree::test::message([&] {
      scree::scenario::read_plan(folder.write("scene.toml", scene_with_keys(keys)), {}, scree::test::host());
    });
  };
  const std::string body = "[[particle]]\nposition = [5, 0, 0]\nradius = 0.1\n";
  CHECK_THAT(
      error(body),
      Catch::EndsWith("no id is left for a body without one, because ids end at 1e15; give that body an "
                      "id, or use smaller ones"));
  CHECK(error(body + "id = 3\n") == "no error");
}

TEST_CASE("a repetition needs whole counts and a period", "[scenario]") {
  const TemporaryFolder folder;
  folder.write("two.csv", "id,x,y,z,radius\n7,0.5,0,0,0.1\n");
  for (const std::string keys : {"repeat = [1.5, 1, 1]\nperiod = [1, 1, 1]\n", "repeat = [2, 1, 1]\n",
                                 "repeat = [0, 1, 1]\nperiod = [1, 1, 1]\n"})
    CHECK_THROWS(scree::scenario::read_plan(folder.write("scene.toml", scene_with_keys(keys)), {},
                                            scree::test::host()));
}

TEST_CASE("keys of files are refused without what they belong to", "[scenario]") {
  const auto with_keys = [](const std::string& keys) {
    return refusal(scree::test::with(scree::test::discs, "radius = 0.01\n", "radius = 0.01\n" + keys));
  };
  CHECK(with_keys("timestep = 5\n")
            .starts_with("scene.toml:16:12: 'timestep' needs 'file', which is not given; "));
  CHECK(with_keys("repeat = [2, 2]\n").starts_with("scene.toml:16:10: 'repeat' needs 'file', "));
  CHECK(with_keys("period = [1, 1]\n").starts_with("scene.toml:16:10: 'period' needs 'file', "));
  const TemporaryFolder folder;
  folder.write("two.csv", "id,x,y,z,radius\n7,0.5,0,0,0.1\n");
  const auto file = folder.write("scene.toml", scene_with_keys("period = [1, 1, 1]\n"));
  CHECK_THAT(
      scree::test::message([&] { scree::scenario::read_plan(file, {}, scree::test::host()); }),
      Catch::Contains("scene.toml:13:10: 'period' is the distance of copies, of which 'repeat' gives "));
}

TEST_CASE("a dump with periodic faces in a scene without is warned of", "[scenario]") {
  const TemporaryFolder folder;
  folder.write("two.csv",
               "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff pp\n0 2\n0 3\n-1 4\n"
               "ITEM: ATOMS id x y z radius\n1 1 1 1 0.1\n");
  const auto warnings = [&](const std::string& keys) {
    return scree::scenario::read_plan(folder.write("scene.toml", scene_with_keys(keys)), {},
                                      scree::test::host())
        .warnings;
  };
  const std::vector<std::string> told = warnings("");
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Catch::StartsWith(
                          "the file of bodies is periodic along x from 0 to 2 m, z from -1 to 4 m, and the "
                          "scene is not; "));
  CHECK(warnings("[[boundary]]\nplugin = 'periodic'\naxes = 'xz'\nlower = [0, 0, -1]\nupper = [2, 0, 4]\n")
            .empty());
  // Copies make it longer.
  CHECK_THAT(warnings("repeat = [3, 1, 1]\nperiod = [2, 3, 5]\n")[0], Catch::Contains("from 0 to 6 m"));
}

TEST_CASE("a two-dimensional packing in a three-dimensional scene is refused", "[scenario]") {
  const TemporaryFolder folder;
  folder.write("flat.csv", "x [m],y [m],radius [m]\n0,0,0.01\n");
  std::string text = scree::test::with(std::string(scree::test::discs), "dimension = 2\n", "dimension = 3\n");
  text = scree::test::with(text, "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n",
                           "file = 'flat.csv'\n");
  const auto file = folder.write("scene.toml", text);
  CHECK_THAT(scree::test::message([&] { scree::scenario::read_plan(file, {}, scree::test::host()); }),
             Catch::Contains("two dimensions") && Catch::Contains("scene.toml:14:"));
}

TEST_CASE("a repetition that memory cannot hold is refused before it is made", "[scenario]") {
  const TemporaryFolder folder;
  folder.write("two.csv", "id,x,y,z,radius\n7,0.5,0,0,0.1\n");
  const auto file =
      folder.write("scene.toml", scene_with_keys("repeat = [1e4, 1e4, 1e4]\nperiod = [1, 1, 1]\n"));
  CHECK_THAT(scree::test::message([&] { scree::scenario::read_plan(file, {}, scree::test::host()); }),
             Catch::Contains(
                 "scene.toml:13:10: 1e+12 bodies need about 2e+06 GB of memory, but this computer has ") &&
                 Catch::Contains("; give at most "));
}

TEST_CASE("bodies whose distance has no finite square are refused", "[scenario]") {
  CHECK_THAT(refusal(scree::test::discs, {"particles.lattice.gap=1e300"}),
             Catch::StartsWith("scene.toml:13:1: a body at (") &&
                 Catch::EndsWith(
                     "outside the range of numbers (1e154); check position, spacing, period and velocity"));
}

TEST_CASE("velocities of a packing are those of the file plus a velocity and a gradient times the position",
          "[scenario]") {
  const TemporaryFolder folder;
  folder.write("two.csv", "id,x,y,z,radius,vx,vy,vz\n7,0.5,1,0,0.1,0,8,0\n8,0.5,2,4,0.1,0,0,0\n");
  const auto file =
      folder.write("scene.toml", scene_with_keys("velocity = [1, 0, 0]\nvelocity_gradient = [2, -4, 0.5]\n"));
  const auto bodies = scree::scenario::read_plan(file, {}, scree::test::host()).scene.bodies;
  REQUIRE(bodies.size() == 2);
  for (const scree::Body& b : bodies)
    CHECK(b.velocity == (b.id == 7 ? scree::Vec3{{2, 4, 0}} : scree::Vec3{{2, -8, 2}}));
}

TEST_CASE("an empty list of columns is refused", "[scenario]") {
  const TemporaryFolder folder;
  folder.write("two.csv", "0 0 0.01\n");
  const auto file = folder.write("scene.toml", scene_with_keys("columns = []\n"));
  CHECK_THROWS_WITH(scree::scenario::read_plan(file, {}, scree::test::host()),
                    Catch::Contains("no column is named; name each"));
}

TEST_CASE("of a lattice and of a file only bodies that lie wholly in the region are there", "[scenario]") {
  // Nine discs of 0.01 m at 0.011, 0.033 and 0.055 m.
  const auto ids = [](const std::string& text) {
    std::vector<double> at;
    for (const scree::Body& body : plan_of(text).scene.bodies)
      at.push_back(body.position[0] + 10 * body.position[1]);
    return at;
  };
  const std::string lattice = "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n";
  const auto cut = [&](const std::string& region) {
    return scree::test::with(scree::test::discs, lattice, lattice + "region = " + region + "\n");
  };
  CHECK(ids(cut("{ x = [0, 0.044], y = [0, 0.07] }")).size() == 6);
  CHECK(ids(cut("{ x = [0, 0.042], y = [0, 0.07] }")).size() == 3);  // the second column sticks out
  CHECK(ids(cut("{ kind = 'sphere', centre = [0.033, 0.033], radius = 0.0321 }")).size() == 5);
  CHECK_THAT(refusal(cut("{ x = [0, 0.001], y = [0, 0.07] }")),
             Catch::Contains("no body lies wholly in the region"));

  const TemporaryFolder folder;
  folder.write("two.csv", "id,x,y,z,radius\n7,0.5,0,0,0.1\n8,0.5,1,0,0.2\n");
  const auto file =
      folder.write("scene.toml", scene_with_keys("region = { x = [0, 1], y = [0.7, 1.3], z = [-1, 1] }\n"));
  const auto bodies = scree::scenario::read_plan(file, {}, scree::test::host()).scene.bodies;
  REQUIRE(bodies.size() == 1);
  CHECK(bodies[0].radius == 0.2);
}
