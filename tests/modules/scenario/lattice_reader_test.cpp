#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

TEST_CASE("a list of radii is drawn by its weights", "[scenario]") {
  const std::string list = "radius = { distribution = 'list', radii = [0.01, 0.004], weights = [0, 1] }";
  for (const Body& body : plan_of(with(discs, "radius = 0.01", list)).scene.bodies)
    CHECK(body.radius == 0.004);
  CHECK(refusal(with(discs, "radius = 0.01", with(list, "[0, 1]", "[1]"))) ==
        "scene.toml:15:68: particles.radius.weights has 1 element; give an array of 2 numbers");
}

TEST_CASE("an impossible lattice is refused", "[scenario]") {
  const std::string close = refusal(with(discs, "gap = 0.1", "spacing = 0.01"));
  CHECK(close.starts_with("scene.toml:14:11: lattice: bodies "));
  CHECK(close.ends_with(" overlap by 0.01 m; give a spacing of at least 0.02 m"));
  CHECK(refusal(discs, {"particles.lattice.count=[100000000,100000000]"}).find("GB of memory") !=
        std::string::npos);
  CHECK(refusal(with(discs, "dimension = 2", "dimension = 3"))
            .starts_with("scene.toml:14:20: particles.lattice.kind = \"square\" is none of the choices"));
}
