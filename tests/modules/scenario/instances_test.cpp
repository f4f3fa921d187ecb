#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("a boundary that refuses to start is reported where the file names it", "[scenario]") {
  const TemporaryFolder folder;
  PluginHost both({SCREE_TEST_PLUGINS, SCREE_TEST_BROKEN});
  const std::string leaning = "[[boundary]]\nplugin = 'refuses_to_start'\n";
  const auto first = folder.write("first.toml", with(discs, "[[boundary]]", leaning + "[[boundary]]"));
  CHECK(message([&] { scenario::read_plan(first, {}, both); }) ==
        first.string() + ":18:10: refuses_to_start: there is no wall to lean on; add one before it");
  const auto last = folder.write("last.toml", discs + ("\n" + leaning));
  CHECK_NOTHROW(scenario::read_plan(last, {}, both));
}

namespace {

// The values of a key of the boundary "box" or the body force after the last stage; empty: not given.
std::vector<double> in_last_stage(const std::string& tables, const std::string& key) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.toml", with(discs, "duration = 1e-4\n", "") + tables);
  const scenario::Plan plan = scenario::read_plan(file, {}, host());
  const Parameters& last = plan.stages.back().changes.back().parameters;
  if (!last.given(key)) return {};
  for (std::uint32_t k = 0; k < last.plugin().parameter_count; ++k)
    if (key == last.plugin().parameters[k].key)
      return {last.values()[k].data, last.values()[k].data + last.values()[k].count};
  return {};
}

const std::string first_stage = "[[stage]]\nname = 'first'\nduration = 1e-4\n",
                  second_stage = "[[stage]]\nname = 'second'\nduration = 1e-4\n";

}  // namespace

TEST_CASE("a stage moves one wall of an axis whose walls had one control, and the other keeps it",
          "[scenario]") {
  const std::string both = with(discs, "x_low = 'fixed'\nx_high = 'fixed'\n", "x = 'fixed'\n");
  const TemporaryFolder folder;
  const auto plan_of = [&](const std::string& keys) {
    const auto file = folder.write("scene.toml", with(both, "duration = 1e-4\n", "") +
                                                     "[[stage]]\nname = 'go'\nduration = 1e-4\n" + keys);
    return scenario::read_plan(file, {}, host());
  };
  const scenario::Plan one = plan_of("set.box = { x_high = 'velocity', velocity_x_high = 0.1 }\n");
  const Parameters& box = one.stages[0].changes[0].parameters;
  CHECK_FALSE(box.given("x"));
  CHECK(box.given("x_low"));
  CHECK(box.given("x_high"));
  CHECK(box.given("gap"));
  // And back: the axis in place of its walls.
  const scenario::Plan back = plan_of("set.box = { x_high = 'velocity', velocity_x_high = 0.1 }\n" +
                                      second_stage + "set.box.x = 'fixed'\n");
  const Parameters& then = back.stages[1].changes[0].parameters;
  CHECK(then.given("x"));
  CHECK_FALSE(then.given("x_low"));
  CHECK_FALSE(then.given("x_high"));
  CHECK(then.given("y_low"));
  // In one table they still exclude each other.
  CHECK_THAT(message([&] { plan_of("set.box = { x = 'fixed', x_high = 'fixed' }\n"); }),
             Catch::Contains("x_high and x both say what moves a wall"));
}

TEST_CASE("a key that a stage sets replaces its parts and what it excludes", "[scenario]") {
  const std::string gravity = "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -2]\n";
  const std::string parts =
      gravity + "acceleration_x = { mean = 0, amplitude = 1, frequency_hz = 10 }\n" + first_stage;
  CHECK(in_last_stage(parts + "set.gravity.acceleration = [0, -1]\n", "acceleration_x").empty());
  CHECK(in_last_stage(parts + "set.gravity.acceleration = [0, -1]\n", "acceleration") ==
        std::vector<double>{0, -1, 0});
  // A part leaves the whole to the other axes.
  CHECK(in_last_stage(gravity + first_stage + "set.gravity.acceleration_x = 1\n", "acceleration") ==
        std::vector<double>{0, -2, 0});
  // normal_damping is given in the scene, and restitution excludes it.
  const std::string law = first_stage + "set.linear_spring_dashpot.restitution = 0.5\n";
  CHECK(in_last_stage(law, "normal_damping").empty());
  CHECK(in_last_stage(law, "restitution") == std::vector<double>{0.5});
  CHECK(in_last_stage(law, "normal_stiffness") == std::vector<double>{1e4});
}
