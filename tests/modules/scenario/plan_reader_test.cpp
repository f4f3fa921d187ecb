#include "plan_support.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

constexpr const char* two_materials =
    "[scene]\ndimension = 2\n[time]\nstep = 1e-5\nduration = 1e-4\n"                         // 1 to 5
    "[[material]]\nname = 'a'\ndensity = 1000\n[[material]]\nname = 'b'\ndensity = 500\n"    // 6 to 11
    "[[particle]]\nradius = 0.01\nposition = [0, 0]\nmaterial = 'a'\n"                       // 12 to 15
    "[[particle]]\nradius = 0.02\nposition = [0.1, 0]\nmaterial = 'b'\nvelocity = [1, 2]\n"  // 16 to 20
    "[[contact]]\nname = 'soft'\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e3\nnormal_damping = "
    "0\n"
    "[[contact]]\nname = 'hard'\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e5\nnormal_damping = "
    "0\n"
    "between = ['a', 'b']\n";

std::string set(const std::string& override_text) { return refusal(discs, {override_text}); }

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
  const Scene scene = plan_of(two_materials).scene;
  CHECK(scene.law_of == std::vector<std::uint32_t>{0, 1, 1, 0});
  CHECK(scene.bodies[1].mass == Approx(500 * std::numbers::pi * 4e-4));
  CHECK(scene.bodies[1].velocity == Vec3{{1, 2, 0}});
  CHECK(scene.bodies[1].material == 1);
}

TEST_CASE("a step given as a fraction is one of the shortest contact", "[scenario]") {
  const Plan plan = plan_of(with(two_materials, "step = 1e-5", "step = { fraction = 0.01 }"));
  const double m = 1000 * std::numbers::pi * 1e-4, other = 500 * std::numbers::pi * 4e-4;
  const double shortest = std::numbers::pi * std::sqrt(m * other / (m + other) / 1e5);
  CHECK(plan.scene.step == Approx(0.01 * shortest));
}

TEST_CASE("a list of radii is drawn by its weights", "[scenario]") {
  const std::string list = "radius = { distribution = 'list', radii = [0.01, 0.004], weights = [0, 1] }";
  for (const Body& body : plan_of(with(discs, "radius = 0.01", list)).scene.bodies)
    CHECK(body.radius == 0.004);
  CHECK(refusal(with(discs, "radius = 0.01", with(list, "[0, 1]", "[1]"))) ==
        "scene.toml:15:68: particles.radius.weights has 1 element; give an array of 2 numbers");
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
  CHECK(refusal(with(two_materials, "radius = 0.01", "radius = 0.01\nmass = 0")) ==
        "scene.toml:14:8: particle[0].mass = 0 kg is zero; give a mass above 0");
  CHECK(set("particles.radius=1e-200").find("outside the range of numbers; check the units of radius") !=
        std::string::npos);
}

TEST_CASE("keys of two functions of time are refused together", "[scenario]") {
  const auto motion = [](const std::string& keys) {
    return refusal(with(discs, "gap = 0.005", "gap = 0.005\nstress = " + keys));
  };
  const std::string line = motion("{ from = 0, to = 1, duration = 1, period = 2 }");
  INFO(line);
  CHECK(line.find("'period' and 'duration' belong to different functions of time; keep one: period (") !=
        std::string::npos);
}

TEST_CASE("unknown names are refused with the nearest known name", "[scenario]") {
  CHECK(
      refusal(with(discs, "normal_damping", "normal_dampin")) ==
      "scene.toml:10:10: linear_spring_dashpot: neither 'normal_damping' nor 'restitution' is given; add one "
      "of them, or correct 'normal_dampin' (scene.toml:12:1) if that is meant");
  CHECK(refusal(with(discs, "normal_stiffness", "stiffness"))
            .ends_with("add normal_stiffness = <number above 0 (N/m)>, or correct 'stiffness' "
                       "(scene.toml:11:1) if that is meant"));
  CHECK(set("contact.tangental_stiffness=1").find("did you mean 'tangential_stiffness'?") !=
        std::string::npos);
  CHECK(set("contact.friction=0.3").find("did you mean 'static_friction'? known keys: ") !=
        std::string::npos);
  CHECK(refusal(with(discs, "linear_spring_dashpot", "linear_spring_dashpt"))
            .starts_with("scene.toml:10:10: no contact law plug-in 'linear_spring_dashpt' in "));
  CHECK(refusal(with(two_materials, "'a', 'b'", "'a', 'c'")) ==
        "scene.toml:31:17: no material 'c'; there are: a, b");
  CHECK(refusal(with(two_materials, "material = 'b'", "material = 'c'")) ==
        "scene.toml:19:12: no material 'c'; there are: a, b");
  CHECK(set("contact.plugin=" + std::string(300, 'x')).ends_with("; see scree describe for the names"));
}

TEST_CASE("missing and duplicate entries are refused", "[scenario]") {
  CHECK(refusal("[scene]\ndimension = 2\n") ==
        "scene.toml:1:1: the scene has no [[material]]; add [[material]] with name and density (kg/m^3)");
  CHECK(
      refusal("[[material]]\nname = 'a'\ndensity = 1\n") ==
      "scene.toml:1:1: the scene has no bodies; add [particles] with lattice and radius, file or state, or [[particle]]");
  CHECK(refusal(with(discs, "step = 1e-5\n", "")).starts_with("scene.toml:3:1: [time] has no 'step'"));
  CHECK(refusal(with(two_materials, "between = ['a', 'b']\n", ""))
            .ends_with(": a second [[contact]] has no materials; add between = [\"a\", "
                       "\"b\"]"));
  CHECK(refusal(with(two_materials, "name = 'hard'", "name = 'soft'")) ==
        "scene.toml:27:8: the law, boundary or force name 'soft' is already in use; give each a different "
        "name");
  CHECK(refusal(with(two_materials, "name = 'b'", "name = 'a'")) ==
        "scene.toml:10:8: the material name 'a' is already in use; give each a different name");
  CHECK(refusal(with(with(two_materials, "radius = 0.01", "radius = 0.01\nid = 3"), "radius = 0.02",
                     "radius = 0.02\nid = 3")) ==
        "scene.toml:19:6: two bodies have the id 3; give every body a different id, or no id");
}

TEST_CASE("an impossible lattice is refused", "[scenario]") {
  const std::string close = refusal(with(discs, "gap = 0.1", "spacing = 0.01"));
  CHECK(close.starts_with("scene.toml:14:11: lattice: bodies "));
  CHECK(close.ends_with(" overlap by 0.01 m; give a spacing of at least 0.02 m"));
  CHECK(set("particles.lattice.count=[100000000,100000000]").find("GB of memory") != std::string::npos);
  CHECK(refusal(with(discs, "dimension = 2", "dimension = 3"))
            .starts_with("scene.toml:14:20: particles.lattice.kind = \"square\" is none of the choices"));
}

TEST_CASE("an interval of wall time without a unit is refused", "[scenario]") {
  const std::string cure =
      "give a number above 0 with s, min, h or d, such as \"30 s\", \"10 min\", \"2 h\" or \"never\"";
  CHECK(set("checkpoint.every=30") ==
        "--set checkpoint.every=30: checkpoint.every is not a text with a unit; " + cure +
            ", or every_time in s of simulated time");
  CHECK(set("checkpoint.every='30'") == "--set checkpoint.every='30': '30' is not a wall time; " + cure);
  CHECK(set("checkpoint.interval=30").ends_with("known keys: every, every_time, final_state"));
}

TEST_CASE("impossible output is refused", "[scenario]") {
  CHECK(refusal(with(discs, "every = 2e-5", "every = 1e-9")) ==
        "scene.toml:26:9: every = 1e-09 s is shorter than the time step of 1e-05 s; increase it, or decrease "
        "time.step");
  CHECK(set("probe.name=a/b") ==
        "--set probe.name=a/b: 'a/b' cannot be used as a file name; use at most 100 letters, digits, '_' and "
        "'-'");
  CHECK(set("chart={name='..',probe='energy',y='work'}").find("cannot be used as a file name") !=
        std::string::npos);
  CHECK(
      set("chart={name='c',probe='energi',y='work'}").ends_with("no probe 'energi'; did you mean 'energy'?"));
  CHECK(set("chart={name='c',probe='energy',y='wrk'}").ends_with("no column 'wrk'; did you mean 'work'?"));
  CHECK(set("expect={requirement='r',quantity='energy_residul',at_most=1}")
            .ends_with("no quantity 'energy_residul'; did you mean 'energy_residual'?"));
  CHECK(set("expect={requirement='r',quantity='energy.work.last',reference=1}")
            .ends_with("reference and tolerance must both be given; give both, or at_most / at_least"));
  CHECK(set("expect={requirement='r',quantity='steps'}").find("has no required value") != std::string::npos);
}

TEST_CASE("an interval of observation is refused for a probe that does not observe", "[scenario]") {
  CHECK(
      set("probe.observe_every=2e-5") ==
      "--set probe.observe_every=2e-5: the probe energy does not observe the run with these parameters; remove "
      "observe_every");
  const std::string msd = with(discs, "'energy'", "'mean_squared_displacement'\nobserve_every = 2e-5");
  CHECK(refusal(msd).starts_with("scene.toml:26:17: the probe mean_squared_displacement does not observe"));
  CHECK(plan_of(msd, {"probe.window=4e-5"}).probes[0].observe_every == 2e-5);
  CHECK(
      refusal(msd, {"probe.window=4e-5", "probe.observe_every=1e-9"}).find("is shorter than the time step") !=
      std::string::npos);
}

TEST_CASE("a probe of energies is refused without the balance of energy", "[scenario]") {
  CHECK(
      set("time.energy_audit=false") ==
      "--set time.energy_audit=false: the probe 'energy' needs the energy audit; set energy_audit = true, or "
      "remove it");
}

TEST_CASE("a material name that a packing cannot hold is refused", "[scenario]") {
  for (const std::string name : {"a,b", "a\\\"b", "a\\nb", " a", "a "})
    CHECK_THAT(set("material.name=\"" + name + "\""),
               Catch::Contains(": the material name '") &&
                   Catch::Contains("' cannot be written to a packing; rename it"));
  CHECK(set("material.name='glass bead'") == "no error");
}

TEST_CASE("more than 1000 materials are refused", "[scenario]") {
  std::string text = discs;
  for (int k = 0; k < 999; ++k) text += "[[material]]\nname = 'm" + std::to_string(k) + "'\ndensity = 1\n";
  CHECK_FALSE(refusal(text).ends_with("merge those of the same density and contacts"));
  CHECK(
      refusal(text + "[[material]]\nname = 'one more'\ndensity = 1\n") ==
      "scene.toml:3024:1: the scene has more than 1000 materials; merge those of the same density and contacts");
}

TEST_CASE("control characters in the name of a plug-in are refused in one line", "[scenario]") {
  CHECK(set("contact.plugin=\"en\\u0001ergy\"") ==
        "--set contact.plugin=\"en\\u0001ergy\": the name 'en\\x01ergy' has control characters; "
        "see scree describe for the names");
}

TEST_CASE("mixed precision is refused where magnitudes leave its range", "[scenario]") {
  const std::vector<std::string> mixed = {"time.precision='mixed'"};
  CHECK(refusal(discs, mixed) == "no error");
  // Discs of 1e-31 m.
  CHECK_THAT(
      refusal(discs, {"time.precision='mixed'", "particles.radius=1e-31", "particles.lattice.gap=1e-31"}),
      Catch::StartsWith("--set time.precision='mixed': at 1 m/s, a mass of some ") &&
          Catch::Contains("the range of single precision; use precision = \"double\", or check "));
}
