#include "plan_support.hpp"

#include <catch2/catch.hpp>

// Scenes with several materials.

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

const std::string two_materials =
    with(std::string(discs), "[[contact]]\n", "[[material]]\nname = 'steel'\ndensity = 7800\n[[contact]]\n");
const std::string second_law =
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nbetween = ['grain', 'steel']\nnormal_stiffness = 2e4\n"
    "normal_damping = 0\n";

std::string with_materials_named(std::string text) {
  return with(with(text, "radius = 0.01\n", "radius = 0.01\nmaterial = 'grain'\n"), "gap = 0.005\n",
              "gap = 0.005\nmaterial = 'steel'\n");
}

}  // namespace

TEST_CASE("two laws of the same plug-in are numbered unless they are named", "[scenario]") {
  const Plan plan = plan_of(with_materials_named(two_materials) + second_law);
  REQUIRE(plan.scene.laws.size() == 2);
  CHECK(plan.scene.laws[0].name == "linear_spring_dashpot");
  CHECK(plan.scene.laws[1].name == "linear_spring_dashpot_2");
  CHECK(plan.scene.law_of == std::vector<std::uint32_t>{0, 1, 1, 0});
}

TEST_CASE("with several materials every wall needs one", "[scenario]") {
  const std::string silent =
      with(with_materials_named(two_materials), "gap = 0.005\nmaterial = 'steel'\n", "gap = 0.005\n");
  CHECK_THAT(refusal(silent), Catch::Contains("[[boundary]] has no 'material'"));
  CHECK(plan_of(with_materials_named(two_materials)).scene.boundaries[0].material == 1);
}
