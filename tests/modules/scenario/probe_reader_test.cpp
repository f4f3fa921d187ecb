#include "plan_support.hpp"

#include <catch2/catch.hpp>

#include <scree/scene_record.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Ten steps of 1e-5 s: ten samples in a period.
const std::string lock_in =
    "[[probe]]\n"                          // 27
    "plugin = 'lock_in'\n"                 // 28
    "of = 'energy.kinetic_translation'\n"  // 29
    "frequency_hz = 1e4\n"                 // 30
    "periods = 0.9\n"                      // 31
    "every = 1e-4\n";                      // 32

const std::string measured = std::string(discs) + lock_in;

std::string refused_of(const std::string& of) {
  return refusal(with(measured, "energy.kinetic_translation", of));
}

}  // namespace

TEST_CASE("a probe may read a column of another, with the unit of that", "[scenario]") {
  const scenario::Plan plan =
      plan_of(measured + "[[chart]]\nname = 'a'\nprobe = 'lock_in'\ny = ['amplitude', 'mean']\n");
  REQUIRE(plan.probes.size() == 2);
  REQUIRE(plan.probes[1].inputs.size() == 1);
  CHECK(plan.probes[1].inputs[0].probe == 0);
  CHECK(plan.probes[1].inputs[0].column == 0);
  CHECK(plan.charts[0].y_unit == "J");
  // 50 samples in a period would be shorter than a step.
  CHECK_FALSE(plan.probes[1].observe_every.has_value());
  CHECK(plan_of(measured, {"probe.lock_in.harmonics=1", "probe.lock_in.samples_per_period=4"})
            .probes[1]
            .observe_every == Approx(2.5e-5));
}

TEST_CASE("a probe may stand before the one that it reads", "[scenario]") {
  const scenario::Plan plan = plan_of(with(discs, "[[probe]]", lock_in + "[[probe]]"));
  CHECK(plan.probes[0].name == "lock_in");
  CHECK(plan.probes[0].inputs[0].probe == 1);
  CHECK(plan.probes[0].depth > plan.probes[1].depth);
}

TEST_CASE("a column that does not exist is refused where it stands, with the nearest", "[scenario]") {
  CHECK(refused_of("energie.kinetic_translation") ==
        "scene.toml:29:6: no probe 'energie'; did you mean 'energy'?");
  CHECK(refused_of("energy.kinetic_transl") ==
        "scene.toml:29:6: no column 'kinetic_transl'; did you mean 'kinetic_translation'?");
  CHECK(refused_of("energy") ==
        "scene.toml:29:6: 'energy' is not <probe>.<column>; give the name of a [[probe]], a "
        "dot and one of its columns");
  CHECK(refused_of("lock_in.amplitude") ==
        "scene.toml:29:6: the probe 'lock_in' reads a column of itself; give a column of another probe");
  CHECK(refusal(with(measured, "'energy.kinetic_translation'", "3")).starts_with("scene.toml:29:6: "));
  CHECK(
      refusal(with(measured, "of = 'energy.kinetic_translation'\n", "")).find("'of' is missing; add of = ") !=
      std::string::npos);
}

TEST_CASE("probes that read each other in a circle are refused", "[scenario]") {
  const auto reads = [](const std::string& name, const std::string& of) {
    return with(lock_in, "of = 'energy.kinetic_translation'",
                "name = '" + name + "'\nof = '" + of + ".mean'");
  };
  // 'outside' waits for the circle and is not in it.
  CHECK(
      refusal(discs + reads("outside", "a") + reads("a", "b") + reads("b", "c") + reads("c", "a")) ==
      "scene.toml:37:6: the probes a, b, c read columns of each other in a circle; let one of them read a column "
      "of another probe");
}

TEST_CASE("a probe records only while those do that it reads", "[scenario]") {
  const std::string staged =
      with(measured, "duration = 1e-4\n", "") +
      "[[stage]]\nname = 'a'\nduration = 1e-4\n[[stage]]\nname = 'b'\nduration = 1e-4\n";
  CHECK(
      refusal(staged, {"probe.energy.stages=['b']"}) ==
      "scene.toml:28:6: the probe 'energy' does not record in stage 'a', in which 'lock_in' does; give both the "
      "same stages");
  CHECK(refusal(staged, {"probe.energy.stages=['b']", "probe.lock_in.stages=['b']"}) == "no error");
  CHECK(refusal(staged, {"probe.lock_in.stages=['a']"}) == "no error");
  CHECK_THAT(refusal(staged, {"probe.energy.stages=[]"}),
             Catch::Contains("stages=[]: is empty; name a stage, or leave it out for all stages"));
}

TEST_CASE("a probe with times of its own takes no others", "[scenario]") {
  CHECK(refusal(measured + "observe_every = 1e-5\n") ==
        "scene.toml:33:17: the probe lock_in has times of its own; remove observe_every");
}

TEST_CASE("an interval of observation is refused for a probe that does not observe", "[scenario]") {
  CHECK(
      refusal(discs, {"probe.observe_every=2e-5"}) ==
      "--set probe.observe_every=2e-5: the probe energy does not observe the run with these parameters; remove "
      "observe_every");
  const std::string msd = with(discs, "'energy'", "'mean_squared_displacement'\nobserve_every = 2e-5");
  CHECK(refusal(msd).starts_with("scene.toml:26:17: the probe mean_squared_displacement does not observe"));
  CHECK(plan_of(msd, {"probe.window=4e-5"}).probes[0].observe_every == 2e-5);
  CHECK(
      refusal(msd, {"probe.window=4e-5", "probe.observe_every=1e-9"}).find("is shorter than the time step") !=
      std::string::npos);
}

TEST_CASE("a probe counts the bodies of groups, or leaves them out", "[scenario]") {
  const std::string groups =
      "[[group]]\nname = 'low'\nwhere.y = [0, 0.04]\n[[group]]\nname = 'left'\nfixed = true\nwhere.x = [0, 0.02]\n"
      "[[group]]\nname = 'idle'\nvelocity = [0, 0]\nwhere.ids = [1]\n";
  const std::string momentum = with(discs, "'energy'", "'momentum'\ngroups = ['low']") + groups;
  const auto left_out = [](const std::string& text, const std::vector<std::string>& overrides = {}) {
    std::vector<int> ids;
    const scenario::Plan plan = plan_of(text, overrides);
    for (std::size_t i = 0; i < plan.probes[0].left_out.size(); ++i)
      if (plan.probes[0].left_out[i]) ids.push_back(int(plan.scene.bodies[i].id));
    return ids;
  };
  CHECK(left_out(momentum) == std::vector{7, 8, 9});
  CHECK(left_out(momentum, {"probe.leave_out=['left']"}) == std::vector{1, 4, 7, 8, 9});
  CHECK(left_out(momentum, {"probe.groups=['low', 'left']"}) == std::vector{8, 9});
  CHECK(left_out(discs).empty());

  CHECK(refusal(momentum, {"probe.groups=['lows']"}).find("no group 'lows'; did you mean 'low'?") !=
        std::string::npos);
  CHECK(refusal(momentum, {"probe.groups=[]"}).find("no group is named") != std::string::npos);
  CHECK(refusal(momentum, {"probe.leave_out=['low']"}).find("no body is left to count") != std::string::npos);
  CHECK(refusal(momentum, {"probe.plugin='energy'"})
            .find("the probe energy does not choose between bodies; remove") != std::string::npos);
  CHECK(refusal(with(momentum, "groups = ['low']", "")) == "no error");
}

TEST_CASE("probes take walls by name or by number", "[scenario]") {
  const std::string walled =
      std::string(discs) +
      "[[boundary]]\nplugin = 'box'\nlower = [-9, -9]\nupper = [9, 9]\nx = 'fixed'\ny = 'fixed'\n"
      "[[boundary]]\nname = 'ring'\nplugin = 'sphere'\npoint = [0, 0]\nradius = 9\n"
      "[[boundary]]\nname = 'rod'\nplugin = 'rectangle'\npoint = [0, 8]\nnormal = [0, -1]\nlength = 1\n";
  const auto line_of = [&](const std::string& probe) {
    const scenario::Plan plan = plan_of(walled + "[[probe]]\nevery = 1e-4\n" + probe + "\n");
    return parameter_lines(plan.probes.back().parameters).front();
  };
  CHECK(line_of("plugin = 'surfaces'\nsurfaces = ['rod', 1]") == "surfaces = 2, 1");
  CHECK(line_of("plugin = 'surfaces'\nsurfaces = [2]") == "surfaces = 2");
  CHECK(line_of("plugin = 'walls'\nwalls = ['box.x_high']") == "walls = 2");
  CHECK(line_of("plugin = 'contact'\nat_surfaces = [1, 'ring', 2, \"rod\"]") == "at_surfaces = 1, 1, 2, 2");
  CHECK_THAT(message([&] { line_of("plugin = 'contact'\nat_surfaces = ['ring', 1]"); }),
             Catch::Contains("is a name in the place of an id; give the id of the body"));
  const auto problem_with = [&](const std::string& probe) {
    return refusal(walled + "[[probe]]\nevery = 1e-4\n" + probe + "\n");
  };
  const std::string rods = problem_with("plugin = 'surfaces'\nsurfaces = [1, 'rods']");
  CHECK(rods.ends_with(":16: no surface 'rods'; did you mean 'rod'?"));
  CHECK(problem_with("plugin = 'walls'\nwalls = ['rod']").find("no plane 'rod'") != std::string::npos);
  CHECK(problem_with("plugin = 'contact'\npairs = [1, 'rod']").find("scene.toml:") != std::string::npos);
  CHECK(problem_with("plugin = 'surfaces'\nsurfaces = ['rod', true]") != "");
}
