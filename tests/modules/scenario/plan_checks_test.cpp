#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

TEST_CASE("mixed precision is refused where magnitudes leave its range", "[scenario]") {
  const std::vector<std::string> mixed = {"time.precision='mixed'"};
  CHECK(refusal(discs, mixed) == "no error");
  // Discs of 1e-31 m.
  CHECK_THAT(
      refusal(discs, {"time.precision='mixed'", "particles.radius=1e-31", "particles.lattice.gap=1e-31"}),
      Catch::StartsWith("--set time.precision='mixed': at 1 m/s, a mass of some ") &&
          Catch::Contains("the range of single precision; use precision = \"double\", or check "));
}

TEST_CASE("a probe of energies is refused without the balance of energy", "[scenario]") {
  CHECK(
      refusal(discs, {"time.energy_audit=false"}) ==
      "--set time.energy_audit=false: the probe 'energy' needs the energy audit; set energy_audit = true, or "
      "remove it");
}

TEST_CASE("spins are stored from the start if a later stage makes bodies rotate", "[scenario]") {
  const std::string stages = with(discs, "duration = 1e-4\n", "") + "[[stage]]\nduration = 1\n";
  CHECK_FALSE(plan_of(stages).scene.spin);
  CHECK(plan_of(stages + "[[stage]]\nduration = 1\nset.linear_spring_dashpot = "
                         "{ static_friction = 0.5, tangential_stiffness = 1 }\n")
            .scene.spin);
}
