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

TEST_CASE("a law of the other dimension is refused before its parameters are", "[scenario]") {
  const std::string scene = with(with(std::string(discs), "linear_spring_dashpot", "sphere_path_independent"),
                                 "normal_stiffness", "stiffness");
  CHECK_THAT(
      refusal(scene),
      Catch::Contains(
          "sphere_path_independent: a law of spheres; set [scene] dimension = 3, or choose a law for 2D"));
}

TEST_CASE("with several materials every wall needs one", "[scenario]") {
  const std::string silent =
      with(with_materials_named(two_materials), "gap = 0.005\nmaterial = 'steel'\n", "gap = 0.005\n");
  CHECK_THAT(refusal(silent), Catch::Contains("[[boundary]] has no 'material'"));
  CHECK(plan_of(with_materials_named(two_materials)).scene.boundaries[0].material == 1);
  const std::string circle = "[[boundary]]\nplugin = 'cylinder'\npoint = [0, 0]\nradius = 9\n";
  CHECK_THAT(refusal(with_materials_named(two_materials) + circle),
             Catch::Contains("[[boundary]] has no 'material'"));
}

TEST_CASE("a material of walls alone needs no law with itself", "[scenario]") {
  const std::string of_grains =
      with(two_materials, "[[contact]]\n", "[[contact]]\nbetween = ['grain', 'grain']\n");
  CHECK(plan_of(with_materials_named(of_grains) + second_law).scene.law_of ==
        std::vector<std::uint32_t>{0, 1, 1, 0});
  CHECK_THAT(refusal(with_materials_named(of_grains)),
             Catch::Contains(
                 "no [[contact]] applies to 'grain' and 'steel'; add one, or leave 'between' out of one"));
  // Bodies of that material may touch each other.
  CHECK_THAT(refusal(with(with_materials_named(of_grains) + second_law, "radius = 0.01\nmaterial = 'grain'\n",
                          "radius = 0.01\nmaterial = 'steel'\n")),
             Catch::Contains("no [[contact]] applies to 'steel' and 'steel'"));
}
