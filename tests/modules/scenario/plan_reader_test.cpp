#include "discs_tables.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

constexpr const char* two_laws =
    "[scene]\ndimension = 2\n[time]\nstep = 1e-5\nduration = 1e-4\n"                         // 1 to 5
    "[[material]]\nname = 'a'\ndensity = 1000\n[[material]]\nname = 'b'\ndensity = 500\n"    // 6 to 11
    "[[particle]]\nradius = 0.01\nposition = [0, 0]\nmaterial = 'a'\n"                       // 12 to 15
    "[[particle]]\nradius = 0.02\nposition = [0.1, 0]\nmaterial = 'b'\nvelocity = [1, 2]\n"  // 16 to 20
    "[[contact]]\nname = 'soft'\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e3\nnormal_damping = "
    "0\n"
    "[[contact]]\nname = 'hard'\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e5\nnormal_damping = "
    "0\n"
    "between = ['a', 'b']\n";

}  // namespace

TEST_CASE("a plan has the values of the file", "[scenario]") {
  const Plan plan = plan_of(with(discs, "dimension = 2", "dimension = 2\ntitle = 'discs'\nseed = 7"));
  CHECK(plan.title == "discs");
  CHECK(plan.seed == 7);
  CHECK(plan.scene.dimension == 2);
  CHECK(plan.scene.step == 1e-5);
  REQUIRE(plan.scene.bodies.size() == 9);
  const Body& body = plan.scene.bodies[4];
  CHECK(body.id == 5);
  CHECK(body.mass == Approx(1000 * std::numbers::pi * 1e-4));
  CHECK(body.inertia == Approx(0.5 * body.mass * 1e-4));
  CHECK(norm(body.velocity) > 0);
  CHECK(plan.scene.laws.size() == 1);
  REQUIRE(plan.scene.boundaries.size() == 1);
  CHECK(plan.scene.boundaries[0].name == "box");
  REQUIRE(plan.stages.size() == 1);
  CHECK(plan.stages[0].duration == 1e-4);
  REQUIRE(plan.probes.size() == 1);
  CHECK(plan.probes[0].every == 2e-5);
  CHECK_FALSE(plan.snapshot.any());
}

TEST_CASE("the same seed gives the same bodies, another seed different ones", "[scenario]") {
  const auto speed = [](const char* seed) {
    return plan_of(discs, {std::string("scene.seed=") + seed}).scene.bodies[0].velocity[0];
  };
  CHECK(speed("3") == speed("3"));
  CHECK(speed("3") != speed("4"));
}

TEST_CASE("each pair of materials has the law with these materials", "[scenario]") {
  const Scene scene = plan_of(two_laws).scene;
  CHECK(scene.law_of == std::vector<std::uint32_t>{0, 1, 1, 0});
  CHECK(scene.bodies[1].mass == Approx(500 * std::numbers::pi * 4e-4));
  CHECK(scene.bodies[1].velocity == Vec3{{1, 2, 0}});
  CHECK(scene.bodies[1].material == 1);
}

TEST_CASE("a step given as a fraction is one of the shortest contact", "[scenario]") {
  const Plan plan = plan_of(with(two_laws, "step = 1e-5", "step = { fraction = 0.01 }"));
  const double m = 1000 * std::numbers::pi * 1e-4, other = 500 * std::numbers::pi * 4e-4;
  const double shortest = std::numbers::pi * std::sqrt(m * other / (m + other) / 1e5);
  CHECK(plan.scene.step == Approx(0.01 * shortest));
}

TEST_CASE("invalid values are refused at their position", "[scenario]") {
  CHECK(refusal(with(discs, "radius = 0.01", "radius = -0.01")) ==
        "scene.toml:15:10: particles.radius = -0.01 m is negative; give a radius above 0");
  CHECK(refusal(with(discs, "density = 1000", "density = 0")) ==
        "scene.toml:8:11: material.density = 0 kg/m^3 is zero; give a density above 0");
  CHECK(refusal(with(discs, "step = 1e-5", "step = 0")) ==
        "scene.toml:4:8: time.step = 0 s is zero; give a step above 0");
  CHECK(refusal(with(discs, "1e4", "nan")) ==
        "scene.toml:11:20: contact.normal_stiffness = nan is not finite; give a number");
  CHECK(refusal(with(discs, "1e4", "-1")) ==
        "scene.toml:11:20: normal_stiffness = -1 is out of range; give a number above 0 (N/m)");
  CHECK(refusal(with(two_laws, "radius = 0.01", "radius = 0.01\nmass = 0")) ==
        "scene.toml:14:8: particle[0].mass = 0 kg is zero; give a mass above 0");
  CHECK(refusal_of_override("particles.radius=1e-200")
            .find("outside the range of numbers; check the units of radius") != std::string::npos);
}

TEST_CASE("unknown names are refused with the nearest known name", "[scenario]") {
  CHECK(
      refusal(with(discs, "normal_damping", "normal_dampin")) ==
      "scene.toml:10:10: linear_spring_dashpot: neither 'normal_damping' nor 'restitution' is given; add one "
      "of them, or correct 'normal_dampin' (scene.toml:12:1) if that is meant");
  CHECK(refusal(with(discs, "normal_stiffness", "stiffness"))
            .ends_with("add normal_stiffness = <number above 0 (N/m)>, or correct 'stiffness' "
                       "(scene.toml:11:1) if that is meant"));
  CHECK(refusal_of_override("contact.tangental_stiffness=1").find("did you mean 'tangential_stiffness'?") !=
        std::string::npos);
  CHECK(refusal_of_override("contact.friction=0.3").find("did you mean 'static_friction'? known keys: ") !=
        std::string::npos);
  CHECK(refusal(with(discs, "linear_spring_dashpot", "linear_spring_dashpt"))
            .starts_with("scene.toml:10:10: no contact law plug-in 'linear_spring_dashpt' in "));
  CHECK(refusal(with(two_laws, "'a', 'b'", "'a', 'c'")) ==
        "scene.toml:31:17: no material 'c'; there are: a, b");
  CHECK(refusal(with(two_laws, "material = 'b'", "material = 'c'")) ==
        "scene.toml:19:12: no material 'c'; there are: a, b");
  CHECK(refusal_of_override("contact.plugin=" + std::string(300, 'x'))
            .ends_with("; see scree describe for the names"));
}

TEST_CASE("missing and duplicate entries are refused", "[scenario]") {
  CHECK(refusal("[scene]\ndimension = 2\n") ==
        "scene.toml:1:1: the scene has no [[material]]; add [[material]] with name and density (kg/m^3)");
  CHECK(
      refusal("[[material]]\nname = 'a'\ndensity = 1\n") ==
      "scene.toml:1:1: the scene has no bodies; add [particles] with lattice and radius, random, file or state, or [[particle]]");
  CHECK(refusal(with(discs, "step = 1e-5\n", "")).starts_with("scene.toml:3:1: [time] has no 'step'"));
  CHECK(refusal(with(two_laws, "between = ['a', 'b']\n", ""))
            .ends_with(": a second [[contact]] has no materials; add between = [\"a\", "
                       "\"b\"]"));
  CHECK(refusal(with(two_laws, "name = 'hard'", "name = 'soft'")) ==
        "scene.toml:27:8: the law, boundary or force name 'soft' is already in use; give each a different "
        "name");
  CHECK(refusal(with(two_laws, "name = 'b'", "name = 'a'")) ==
        "scene.toml:10:8: the material name 'a' is already in use; give each a different name");
  CHECK(refusal(with(with(two_laws, "radius = 0.01", "radius = 0.01\nid = 3"), "radius = 0.02",
                     "radius = 0.02\nid = 3")) ==
        "scene.toml:19:6: two bodies have the id 3; give every body a different id, or no id");
}
