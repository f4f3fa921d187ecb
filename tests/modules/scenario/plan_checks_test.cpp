#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

TEST_CASE("of the key precision of earlier versions, double is accepted and mixed refused", "[scenario]") {
  CHECK(refusal(discs, {"time.precision=double"}) == "no error");
  CHECK(
      refusal(discs, {"time.precision=mixed"}) ==
      "--set time.precision=mixed: all numbers are double; mixed precision has been removed; remove it; a run "
      "that began with it goes on as a new one from its state (particles.state)");
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
