#include "plan_support.hpp"

#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include <scree/simulation.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Nine discs at (0.011 + 0.022 i, 0.011 + 0.022 j) m for i, j from 0 to 2, with the ids 3 j + i + 1; then
// line 27.
std::string with_group(const std::string& keys) { return std::string(discs) + "[[group]]\n" + keys; }

std::set<std::int64_t> fixed_by(const std::string& where) {
  std::set<std::int64_t> ids;
  for (const Body& body : plan_of(with_group("name = 'g'\nfixed = true\nwhere = " + where)).scene.bodies)
    if (body.fixed) ids.insert(body.id);
  return ids;
}

std::string refused_group(const std::string& keys) { return refusal(with_group(keys)); }
std::string refused_where(const std::string& where) {
  return refused_group("name = 'g'\nfixed = true\nwhere = " + where);
}

using Ids = std::set<std::int64_t>;

}  // namespace

TEST_CASE("a group has the bodies that meet all its conditions", "[scenario]") {
  const std::vector<Body> bodies = plan_of(discs).scene.bodies;
  REQUIRE(bodies[5].id == 6);
  REQUIRE(bodies[5].position[0] == Approx(0.055));
  REQUIRE(bodies[5].position[1] == Approx(0.033));
  CHECK(fixed_by("{ ids = [2, 9, 2] }") == Ids{2, 9});
  CHECK(fixed_by("{ y = [0, 0.02] }") == Ids{1, 2, 3});
  CHECK(fixed_by("{ x = [0.05, 1] }") == Ids{3, 6, 9});
  CHECK(fixed_by("{ x = [0.05, 1], y = [0, 0.04] }") == Ids{3, 6});
  CHECK(fixed_by("{ x = [0.05, 1], ids = [1, 2, 3] }") == Ids{3});
  CHECK(fixed_by("{ sphere = { centre = [0.033, 0.033], radius = 0.0221 } }") == Ids{2, 4, 5, 6, 8});
  CHECK(fixed_by("{ sphere = { centre = [0.033, 0.033], radius = 0.0219 } }") == Ids{5});
  // A rectangle along the diagonal: as wide as the neighbours of the diagonal, and to the middle.
  CHECK(fixed_by("{ cylinder = { from = [0.011, 0.011], to = [0.034, 0.034], radius = 0.001 } }") ==
        Ids{1, 5});
  CHECK(fixed_by("{ cylinder = { from = [0.034, 0.034], to = [0.010, 0.010], radius = 0.016 } }") ==
        Ids{1, 2, 4, 5});
  CHECK(fixed_by("{ material = 'grain' }").size() == 9);
}

TEST_CASE("a group has the bodies of a table of particles", "[scenario]") {
  const std::string two =
      with(discs, "[particles]\n", "[[particles]]\nname = 'bed'\n") +
      "[[particles]]\nname = 'seed'\nlattice = { kind = 'square', count = [2, 1], origin = [0.2, 0.2] }\n"
      "radius = 0.005\n";
  const auto fixed_in = [&](const std::string& where) {
    std::set<std::int64_t> ids;
    for (const Body& body :
         plan_of(two + "[[group]]\nname = 'g'\nfixed = true\nwhere = " + where).scene.bodies)
      if (body.fixed) ids.insert(body.id);
    return ids;
  };
  CHECK(fixed_in("{ particles = 'bed' }").size() == 9);
  CHECK(fixed_in("{ particles = 'seed' }") == Ids{10, 11});
  CHECK(fixed_in("{ particles = 'bed', y = [0, 0.02] }") == Ids{1, 2, 3});
  CHECK_THAT(refusal(two + "[[group]]\nname = 'g'\nfixed = true\nwhere = { particles = 'beds' }\n"),
             Catch::Contains("did you mean 'bed'?"));
}

TEST_CASE("the conditions of a group in space have three axes, and a material is found by its name",
          "[scenario]") {
  std::string scene = with(with(discs, "dimension = 2", "dimension = 3"), "kind = 'square', count = [3, 3]",
                           "kind = 'simple_cubic', count = [1, 1, 3]");
  scene = with(scene, "[[contact]]", "[[material]]\nname = 'other'\ndensity = 1\n[[contact]]");
  scene = with(scene, "radius = 0.01\n", "radius = 0.01\nmaterial = 'grain'\n");
  scene = with(scene, "plugin = 'box'\n", "plugin = 'box'\nmaterial = 'grain'\nz = 'fixed'\n");
  scene +=
      "[[particle]]\nposition = [0.2, 0, 0]\nradius = 0.01\nmaterial = 'other'\n"
      "[[group]]\nname = 'top'\nfixed = true\nwhere.z = [0.05, 1]\n"
      "[[group]]\nname = 'others'\nfixed = true\nwhere.material = 'other'\n"
      "[[group]]\nname = 'axis'\nvelocity = [1, 2, 3]\n"
      "where = { cylinder = { from = [0.011, 0.011, 0], to = [0.011, 0.011, 0.04], radius = 0.001 } }\n";
  const std::vector<Body> bodies = plan_of(scene).scene.bodies;
  REQUIRE(bodies.size() == 4);
  CHECK_FALSE(bodies[0].fixed);
  CHECK_FALSE(bodies[1].fixed);
  CHECK(bodies[2].fixed);
  CHECK(bodies[3].fixed);
  CHECK(bodies[0].velocity == Vec3{{1, 2, 3}});
  CHECK(bodies[1].velocity == Vec3{{1, 2, 3}});
}

TEST_CASE("a group that is fixed has no velocity, and others keep or are given theirs", "[scenario]") {
  const std::vector<Body> before = plan_of(discs).scene.bodies,
                          after = plan_of(with_group(
                                              "name = 'a'\nfixed = true\nwhere.ids = [1, 2]\n"
                                              "[[group]]\nname = 'b'\nvelocity = [3, -4]\nwhere.ids = [3]\n"))
                                      .scene.bodies;
  CHECK(after[0].velocity == Vec3{});
  CHECK(after[1].velocity == Vec3{});
  CHECK(after[2].velocity == Vec3{{3, -4, 0}});
  CHECK_FALSE(after[2].fixed);
  REQUIRE_FALSE(before[3].velocity == Vec3{});
  CHECK(after[3].velocity == before[3].velocity);
  CHECK(refused_group("name = 'a'\nfixed = true\nwhere.ids = [1, 2]\nvelocity = [0, 0]") == "no error");
}

TEST_CASE("a group that a scene cannot have is refused with its place and a cure", "[scenario]") {
  CHECK(refused_group("name = 'g'\nfixed = true").starts_with("scene.toml:27:1: "));
  CHECK(refused_group("fixed = true\nwhere.ids = [1]").starts_with("scene.toml:27:1: "));
  CHECK_THAT(
      refused_group(
          "name = 'g'\nfixed = true\nwhere.ids = [1]\n[[group]]\nname = 'g'\nfixed = true\nwhere.ids = [2]"),
      Catch::Contains("the group name 'g' is already in use"));
  CHECK_THAT(refused_group("name = 'g'\nfixed = true\nwhere.ids = [1]\nfixd = true"),
             Catch::Contains("unknown key 'fixd'"));
  CHECK_THAT(refused_group("name = 'g'\nfixed = 1\nwhere.ids = [1]"), Catch::Contains("scene.toml:29:9: "));
  CHECK(
      refused_where("{}") ==
      "scene.toml:30:9: group 'g' has no condition; give particles, ids, material, x, y or z = [low, high], sphere or cylinder");
  CHECK(
      refused_where("{ y = [1, 2] }") ==
      "scene.toml:30:9: group 'g' has no bodies; correct its conditions: the centres of the 9 bodies have x from "
      "0.011 to 0.055, y from 0.011 to 0.055 m");
  CHECK(
      refused_where("{ ids = [1, 10] }") ==
      "scene.toml:30:21: no body has the id 10; give ids of bodies, as [[particle]], a file or a probe has them");
  CHECK(refused_where("{ material = 'gran' }") ==
        "scene.toml:30:22: no material 'gran'; did you mean 'grain'?");
  CHECK_THAT(refused_where("{ x = [2, 1] }"), Catch::Contains("2 is above 1 m; give the lower end first"));
  CHECK_THAT(refused_where("{ z = [0, 1] }"), Catch::Contains("a scene of two dimensions has no z"));
  CHECK_THAT(refused_where("{ x = [1] }"), Catch::Contains("scene.toml:30:15: "));
  CHECK_THAT(refused_where("{ mterial = 'grain' }"), Catch::Contains("unknown key 'mterial'"));
  CHECK_THAT(refused_where("{ sphere = { centre = [0, 0], radius = 0 } }"), Catch::Contains("radius"));
  CHECK_THAT(refused_where("{ sphere = { centre = [0, 0], radius = 1, height = 1 } }"),
             Catch::Contains("unknown key 'height'"));
  CHECK_THAT(refused_where("{ cylinder = { from = [0, 0], to = [0, 0], radius = 1 } }"),
             Catch::Contains("the axis has no length"));
  CHECK(
      refused_group(
          "name = 'g'\nfixed = true\nwhere.ids = [1, 2]\n[[group]]\nname = 'h'\nvelocity = [1, 0]\nwhere.ids = [4, 2]") ==
      "scene.toml:33:12: particle 2 of group 'h' is fixed and cannot move; remove velocity, leave the body out of the "
      "group that is fixed, or give velocity there");
}

TEST_CASE("bodies are held along the axes that a group names, and have its velocity there, or none",
          "[scenario]") {
  const Scene scene =
      plan_of(with_group("name = 'a'\nfixed = ['x']\nwhere.ids = [1]\n"
                         "[[group]]\nname = 'b'\nfixed = ['y', 'rotation']\nwhere.ids = [2]\n"
                         "velocity = [3, -4]\n"
                         "[[group]]\nname = 'c'\nfixed = ['x', 'y', 'rotation']\nspin = 5\n"
                         "where.ids = [3]\n"
                         "[[group]]\nname = 'd'\nfixed = true\nvelocity = [0, 0.5]\nwhere.ids = [4]\n"))
          .scene;
  const std::vector<Body> before = plan_of(discs).scene.bodies;
  const std::vector<Body>& after = scene.bodies;
  CHECK(after[0].held == 1);
  CHECK_FALSE(after[0].fixed);
  REQUIRE(before[0].velocity[1] != 0);
  CHECK(after[0].velocity == Vec3{{0, before[0].velocity[1], 0}});
  CHECK(after[1].held == (2 | 32));
  CHECK(after[1].velocity == Vec3{{3, -4, 0}});
  // All that a disc has.
  CHECK(after[2].fixed);
  CHECK(after[2].held == 0);
  CHECK(after[2].spin == Vec3{{0, 0, 5}});
  CHECK(after[3].fixed);
  CHECK(after[3].velocity == Vec3{{0, 0.5, 0}});
  CHECK(scene.groups.empty());
}

TEST_CASE("a group follows functions of time, and a later one may hold other bodies", "[scenario]") {
  const Scene scene =
      plan_of(with_group("name = 'shaker'\nfixed = true\nwhere.ids = [1, 2]\n"
                         "velocity = [0.25, { amplitude = 2, frequency_hz = 3, phase_deg = 90 }]\n"
                         "[[group]]\nname = 'lift'\nfixed = ['y']\nwhere.ids = [3]\n"
                         "displacement = [0, { from = 0, to = 4, duration = 2 }]\n"
                         "[[group]]\nname = 'load'\nwhere.ids = [4]\nforce = [0, -7]\n"
                         "torque = { amplitude = 1, frequency_hz = 1 }\n"))
          .scene;
  REQUIRE(scene.groups.size() == 3);
  CHECK(scene.groups[0].bodies == std::vector<std::uint32_t>{0, 1});
  CHECK(scene.groups[0].velocity[0].empty());  // a number: the velocity of the body
  CHECK(scene.groups[0].velocity[1] == std::vector<double>{1, 0, 2, 3, std::acos(-1.0) / 2});
  CHECK(scene.bodies[0].velocity == Vec3{{0.25, 2, 0}});
  CHECK(scene.groups[1].displacement[1] == std::vector<double>{3, 0, 4, 2});
  CHECK(scene.bodies[2].velocity[1] == 2);
  CHECK(scene.groups[2].load[0].empty());
  CHECK(scene.groups[2].load[1] == std::vector<double>{0, -7});
  CHECK(scene.groups[2].load[5] == std::vector<double>{1, 0, 1, 1, 0});
  CHECK_FALSE(scene.bodies[3].fixed);
}

TEST_CASE("motions and loads of groups that a scene cannot have are refused with a cure", "[scenario]") {
  const std::string sine = "{ amplitude = 1, frequency_hz = 1 }";
  CHECK(
      refused_group("name = 'g'\nwhere.ids = [1]\nvelocity = [0, " + sine + "]") ==
      "scene.toml:30:12: velocity is a function of time along an axis that is not fixed; add fixed = true, or fixed = "
      "[\"y\"]");
  CHECK_THAT(refused_group("name = 'g'\nwhere.ids = [1]\nfixed = ['y']\nspin = " + sine),
             Catch::Contains("add fixed = true, or fixed = [\"rotation_z\"]"));
  CHECK_THAT(refused_group("name = 'g'\nwhere.ids = [1]\nfixed = ['y', 'z']"),
             Catch::Contains("scene.toml:30:15: a scene of two dimensions has no z"));
  CHECK_THAT(refused_group("name = 'g'\nwhere.ids = [1]\nfixed = ['w']"),
             Catch::Contains("'w' is no axis; give x, y, z"));
  CHECK_THAT(refused_group("name = 'g'\nwhere.ids = [1]\nfixed = []"), Catch::Contains("no axis is fixed"));
  CHECK_THAT(refused_group("name = 'g'\nwhere.ids = [1]\nfixed = true\ndisplacement = [0, 1]"),
             Catch::Contains("scene.toml:31:20: a displacement that does not change moves nothing"));
  CHECK_THAT(refused_group("name = 'g'\nwhere.ids = [1]\nfixed = true\nvelocity = [0, 0]\ndisplacement = [" +
                           sine + ", 0]"),
             Catch::Contains("velocity and displacement are both given"));
  CHECK_THAT(
      refused_group("name = 'g'\nwhere.ids = [1]\nfixed = true\nvelocity = [0, { amplitud = 1 }]"),
      Catch::Contains("'velocity' is not a function of time") || Catch::Contains("unknown key 'amplitud'"));
  CHECK_THAT(refused_group("name = 'g'\nwhere.ids = [1]\nfixed = true\nforce = [0, 0, 1]"),
             Catch::Contains("give an array of 2 numbers or tables"));
  CHECK_THAT(
      refused_group("name = 'g'\nwhere.ids = [1, 2]\nfixed = true\nvelocity = [0, " + sine +
                    "]\n[[group]]\nname = 'h'\nwhere.ids = [2]\nfixed = true"),
      Catch::Contains("particle 2 of group 'h' already follows a function of time; leave it out of one"));
}

TEST_CASE("bodies that a state has fixed stay fixed until a group lets them go", "[scenario]") {
  const TemporaryFolder folder;
  state_file::write_state(
      folder / "a.h5",
      Simulation(plan_of(with_group("name = 'g'\nfixed = true\nwhere.ids = [1, 2]")).scene).state());
  const std::string from_state = with(discs,
                                      "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = "
                                      "0.01\nrandom_velocity = 0.1\n",
                                      "state = 'a.h5'\n");
  const auto fixed_of = [&](const std::string& more) {
    Ids ids;
    for (const Body& body :
         scenario::read_plan(folder.write("scene.toml", from_state + more), {}, host()).scene.bodies)
      if (body.fixed) ids.insert(body.id);
    return ids;
  };
  CHECK(fixed_of("") == Ids{1, 2});
  CHECK(fixed_of("[[group]]\nname = 'g'\nfixed = false\nwhere.ids = [1]\n") == Ids{2});
  CHECK(fixed_of("[[group]]\nname = 'g'\nfixed = true\nwhere.ids = [3]\n") == Ids{1, 2, 3});
}

TEST_CASE("a group may be given nothing, and a misspelt key of one is named", "[scenario]") {
  CHECK(refused_group("name = 'g'\nwhere.ids = [1]") == "no error");
  CHECK_THAT(refused_group("name = 'g'\nfixd = true\nwhere.ids = [1]"), Catch::Contains("'fixd'"));
}

TEST_CASE("a run that goes on has the fixed bodies of its start, whatever lies in the region of a group now",
          "[scenario]") {
  const std::string text = with_group("name = 'g'\nfixed = true\nwhere.y = [0, 0.02]");
  std::vector<Body> bodies = plan_of(text).scene.bodies;
  for (Body& body : bodies) body.position[1] += 1;
  const std::vector<Body> again =
      scenario::read_plan_again(text, "scene.toml", {}, {bodies, {}, {}, {}}, host()).scene.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) CHECK(again[i].fixed == bodies[i].fixed);
}
