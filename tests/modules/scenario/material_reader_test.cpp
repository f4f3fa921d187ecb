#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

TEST_CASE("a material name that a packing cannot hold is refused", "[scenario]") {
  for (const std::string name : {"a,b", "a\\\"b", "a\\nb", " a", "a "})
    CHECK_THAT(refusal(discs, {"material.name=\"" + name + "\""}),
               Catch::Contains(": the material name '") &&
                   Catch::Contains("' cannot be written to a packing; rename it"));
  CHECK(refusal(discs, {"material.name='glass bead'"}) == "no error");
}

TEST_CASE("more than 1000 materials are refused", "[scenario]") {
  std::string text = discs;
  for (int k = 0; k < 999; ++k) text += "[[material]]\nname = 'm" + std::to_string(k) + "'\ndensity = 1\n";
  CHECK_FALSE(refusal(text).ends_with("merge those of the same density and contacts"));
  CHECK(
      refusal(text + "[[material]]\nname = 'one more'\ndensity = 1\n") ==
      "scene.toml:3024:1: the scene has more than 1000 materials; merge those of the same density and contacts");
}
