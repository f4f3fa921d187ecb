#include "plan_support.hpp"

#include <array>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// 900 discs of three materials.
std::string scene_of_material(const std::string& material) {
  const std::string others = "[[material]]\nname = 'b'\ndensity = 1\n[[material]]\nname = 'c'\ndensity = 1\n";
  return with(with(with(discs, "count = [3, 3]", "count = [30, 30]"), "random_velocity = 0.1\n",
                   "material = " + material + "\n" + others),
              "plugin = 'box'\n", "plugin = 'box'\nmaterial = 'b'\n");
}

}  // namespace

TEST_CASE("shares of materials are met to less than one body, at random places", "[scenario]") {
  const auto bodies = plan_of(scene_of_material("{ grain = 0.5, c = 0.1666, b = 0.3334 }")).scene.bodies;
  REQUIRE(bodies.size() == 900);
  std::array<int, 3> count{}, low{};
  for (const Body& body : bodies) {
    ++count.at(body.material);
    if (body.id <= 450) ++low.at(body.material);
  }
  CHECK(count == std::array{450, 300, 150});  // 150, 300.06 and 149.94
  // Of 450 drawn from 900 the deviation is below sqrt(900/16) = 7.5 for each material; five of them.
  CHECK(std::abs(low[0] - 225) < 38);
  CHECK(std::abs(low[1] - 150) < 38);
  // The order of the lattice says nothing of the material.
  int changes = 0;
  for (std::size_t k = 1; k < bodies.size(); ++k) changes += bodies[k].material != bodies[k - 1].material;
  CHECK(changes > 400);
}

TEST_CASE("shares of materials that are none are refused", "[scenario]") {
  CHECK(refusal(scene_of_material("{ grain = 0.5, b = 0.4 }")) ==
        "scene.toml:16:12: the shares of the materials add up to 0.9; make them add up to 1");
  CHECK(refusal(scene_of_material("{ grain = 0.5, d = 0.5 }")) ==
        "scene.toml:16:31: no material 'd'; there are: grain, b, c");
}
