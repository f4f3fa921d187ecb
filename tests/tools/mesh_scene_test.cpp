#include "program.hpp"

#include <string>

// Scenes with meshes from files, as users run them.

using namespace scree::test;

namespace {

// An open pot of 1 cm, in mm, with a turned triangle that no one sees from both sides.
const std::string pot =
    "v -10 -10 0\nv 10 -10 0\nv 10 10 0\nv -10 10 0\nv -10 -10 20\nv 10 -10 20\nv 10 10 20\nv -10 10 20\n"
    "f 1 2 3 4\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

const std::string scene = R"(
[time]
step = 2e-5
duration = 0.04
[[material]]
name = "bead"
density = 2500
[[particles]]
lattice = { count = [4, 4, 3], spacing = 0.0045, origin = [-0.009, -0.009, 0.0005] }
radius = 0.002
random_velocity = 0.1
[[contact]]
plugin = "linear_spring_dashpot"
normal_stiffness = 2e3
restitution = 0.6
tangential_stiffness = 6e2
static_friction = 0.4
[[boundary]]
name = "pot"
plugin = "mesh"
file = "parts/pot.obj"
scale = 0.001
spin = 3
spin_axis = [0, 0, 1]
[[body_force]]
plugin = "gravity"
acceleration = [0, 0, -9.81]
[[probe]]
plugin = "energy"
every = 0.01
[snapshot]
every = 0.02
)";

struct PotWorkspace : Workspace {
  explicit PotWorkspace(const std::string& text = scene, const std::string& mesh = pot) : Workspace(text) {
    shell("mkdir parts");
    write("parts/pot.obj", mesh);
  }
};

}  // namespace

TEST_CASE("a run with a mesh goes on without its file, and from another folder", "[tools]") {
  const PotWorkspace w;
  const Outcome check = w.scree("check scene.toml");
  CHECK(check.status == 0);
  CHECK_THAT(check.out,
             Catch::Contains("pot: 10 triangles from (-0.01, -0.01, 0) to (0.01, 0.01, 0.02) m, open"));
  REQUIRE(w.run().status == 0);
  CHECK(w.has("out/snapshots/surfaces_0000002000.vtp"));
  const std::string hash = w.record()["state_hash"];
  REQUIRE(w.shell("scree run scene.toml --out half --set time.duration=0.02 --quiet").status == 0);
  w.shell("rm -r parts");
  REQUIRE(w.shell("scree resume half --until 0.04 --quiet").status == 0);
  CHECK(w.record("half")["state_hash"] == hash);
  CHECK_THAT(w.text("out/scenario.toml"), Catch::Contains((w / "parts/pot.obj").string()));
}

TEST_CASE("meshes that do not fit their use are refused in a line", "[tools]") {
  const auto refusal = [](const std::string& text, const std::string& mesh = pot) {
    const Outcome outcome = PotWorkspace(text, mesh).scree("check scene.toml");
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  CHECK_THAT(refusal(with(scene, "pot.obj", "pan.obj")),
             Catch::Contains("scene.toml:21:8: ") && Catch::Contains("pan.obj: there is no such file"));
  CHECK_THAT(refusal(with(scene, "scale = 0.001", "scale = 0.001\nside = \"inside\"")),
             Catch::Contains("the mesh is not closed: 4 edges of one triangle") &&
                 Catch::Contains("leave side out"));
  const std::string lid = pot + "f 5 6 7 8\n";
  CHECK_THAT(refusal(with(scene, "scale = 0.001", "scale = 0.001\nside = \"outside\""), lid),
             Catch::Contains("behind the surface pot"));
  CHECK_THAT(refusal(scene, "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n"),
             Catch::Contains("scene.toml:21:8: parts/pot.obj: line 3 is not a point"));
  const std::string twice =
      lid + "v -10 -10 5\nv 10 -10 5\nv 0 10 5\nv 0 0 8\nf 9 11 10\nf 9 10 12\nf 10 11 12\nf 11 9 12\n";
  CHECK_THAT(refusal(with(scene, "scale = 0.001", "scale = 0.001\nside = \"inside\""), twice),
             Catch::Contains("has shells within shells; give each shell as a boundary of its own"));
  const Outcome large = PotWorkspace(with(scene, "scale = 0.001", "scale = 1")).scree("check scene.toml");
  CHECK_THAT(large.err, Catch::Contains("give scale = 0.001 for mm"));
}
