#include "audit/energy_audit.hpp"

#include "scenes.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include <scree/energy.hpp>

// Sums of small binary fractions are exact, so that these tests compare with ==.

using scree::BodySums;
using scree::ContactSums;
using scree::EnergyAudit;

TEST_CASE("powers are integrated by the trapezoidal rule, frictional work is added as it is") {
  EnergyAudit audit;
  const ContactSums first = {
      .dissipation_rate_normal = 2, .dissipation_rate_tangential = 4, .dissipated_friction = 100};
  const BodySums first_bodies = {.dissipation_rate_translation = 8, .dissipation_rate_rotation = 16};
  audit.set_stored(first, first_bodies);
  audit.start(0, 0, {});
  const ContactSums second = {
      .dissipation_rate_normal = 6, .dissipation_rate_tangential = 0, .dissipated_friction = 0.5};
  const BodySums second_bodies = {
      .dissipation_rate_translation = 0, .dissipation_rate_rotation = 32, .work = 7};
  audit.add_step(0.5, second, second_bodies);
  scree_energy e = audit.balance(0, 0, {});
  CHECK(e.dissipated_normal == 0.25 * (2 + 6));
  CHECK(e.dissipated_tangential == 0.25 * (4 + 0));
  CHECK(e.dissipated_friction == 0.5);  // dissipation of set_stored is not counted
  CHECK(e.dissipated_translation == 0.25 * (8 + 0));
  CHECK(e.dissipated_rotation == 0.25 * (16 + 32));
  CHECK(e.work == 7);

  audit.add_step(0.25, {}, {});
  e = audit.balance(0, 0, {});
  CHECK(e.dissipated_normal == 2 + 0.125 * 6);
  CHECK(e.dissipated_rotation == 12 + 0.125 * 32);
  CHECK(e.dissipated_friction == 0.5);
  CHECK(scree::dissipated_energy(e) == 2.75 + 1 + 0.5 + 2 + 16);
}

TEST_CASE("stored energy is that of the last evaluation, and the residual is the imbalance") {
  EnergyAudit audit;
  audit.set_stored({.elastic_normal = 1, .elastic_tangential = 2}, {.potential = 4});
  audit.start(8, 16, {.kinetic = 32, .work = 0, .dissipated = 0});
  CHECK(audit.balance(8, 16, {.kinetic = 32, .work = 0, .dissipated = 0}).residual == 0);

  audit.add_step(1, {.elastic_normal = 3, .elastic_tangential = 1, .dissipation_rate_normal = 2},
                 {.potential = -4});
  const scree_energy e = audit.balance(6, 20, {.kinetic = 40, .work = 5, .dissipated = 7});
  CHECK(e.elastic_normal == 3);
  CHECK(e.elastic_tangential == 1);
  CHECK(e.potential == -4);
  CHECK(scree::kinetic_energy(e) == 66);
  CHECK(scree::elastic_energy(e) == 4);
  CHECK(e.dissipated_boundary == 7);
  CHECK(e.work == 5);
  // Stored 66, at the start 63; dissipated 1 by the dashpot and 7 by the boundary; work 5.
  CHECK(e.residual == 66 + 4 - 4 - 63 + 1 + 7 - 5);
}

TEST_CASE("a jump of the stored energy between stages counts as work and leaves no residual") {
  EnergyAudit audit;
  audit.set_stored({.elastic_normal = 4}, {.potential = 1});
  audit.start(2, 0, {});
  audit.set_stored({.elastic_normal = 10, .elastic_tangential = 0.5}, {.potential = 0});
  scree_energy e = audit.balance(2, 0, {});
  CHECK(e.work == 5.5);
  CHECK(e.residual == 0);

  // Powers are integrated from the new parameters on.
  audit.set_stored({.elastic_normal = 8, .dissipation_rate_normal = 16}, {});
  audit.add_step(0.5, {.elastic_normal = 8}, {});
  e = audit.balance(2, 0, {});
  CHECK(e.work == 5.5 - 2.5);
  CHECK(e.dissipated_normal == 4);
}

TEST_CASE("energies present at the start do not count as work") {
  EnergyAudit audit;
  audit.set_stored({.elastic_normal = 4}, {});
  audit.set_stored({.elastic_normal = 6}, {.potential = 3});
  audit.start(1, 1, {});
  const scree_energy e = audit.balance(1, 1, {});
  CHECK(e.work == 0);
  CHECK(e.residual == 0);
}

TEST_CASE("turnover is the work, or kinetic, stored and dissipated energy if that is larger") {
  EnergyAudit audit;
  audit.set_stored({}, {.potential = 5});
  audit.start(1, 0, {});
  scree_energy e = {};
  CHECK(audit.turnover(e) == 1);  // kinetic at the start
  e.kinetic_translation = 1, e.elastic_normal = 2, e.dissipated_friction = 4;
  CHECK(audit.turnover(e) == 7);
  e.work = -9;
  CHECK(audit.turnover(e) == 9);
  audit.add_step(1, {.elastic_normal = 6}, {.potential = 8});  // 6 in springs and 3 in potentials
  audit.add_step(1, {}, {.potential = 5});
  CHECK(audit.turnover(e) == 13);
}

TEST_CASE("an energy that was not finite leaves no share of the turnover") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto share_after = [](const ContactSums& middle, const ContactSums& last) {
    EnergyAudit audit;
    audit.set_stored({}, {});
    audit.start(1, 0, {});
    audit.add_step(1, middle, {});
    audit.add_step(1, last, {});
    const scree_energy e = audit.balance(1, 0, {});
    return audit.share(std::abs(e.residual), e);
  };
  CHECK(share_after({}, {}) == 0);
  CHECK(std::isnan(share_after({}, {.elastic_normal = nan})));
  CHECK(std::isnan(share_after({.elastic_normal = nan}, {})));  // although it is finite again
  CHECK(std::isnan(share_after({.dissipated_friction = nan}, {})));
  CHECK(std::isnan(share_after({.elastic_normal = INFINITY}, {})));
  EnergyAudit audit;
  audit.start(1, 0, {});
  const scree_energy moved = audit.balance(1, 0, {.kinetic = 0, .work = nan, .dissipated = 0});
  CHECK(std::isnan(audit.share(std::abs(moved.residual), moved)));
}

TEST_CASE("the energy balance of an elastic bounce under gravity closes to the integrator's second order") {
  const auto residual = [](double step) {
    scree::Scene s = scree::test::scene(3, step, {scree::test::body(0, 1, 1, {{0, 0, 1.5}})},
                                        {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
    scree::test::add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
    scree::test::add_body_force(s, "gravity", {{"acceleration", {0, 0, -10}}});
    scree::Simulation simulation(s);
    double largest = 0;
    while (simulation.time() < 0.4) {
      simulation.step();
      largest = std::max(largest, std::abs(simulation.energy().residual));
    }
    return largest;
  };
  // Velocity Verlet conserves v²/2 + (1 − (ωh)²/4) ω²x²/2: the error is (ωh)²/4 of the spring energy, which
  // is at most 5 J plus the work of gravity, 10 N × 0.11 m. First touch is within a step, and the work of the
  // spring since then, up to k(vh)²/8 as the chord of a parabola, is missing: ω² = 1000/s², v² = 10 m²/s².
  const auto bound = [](double h) { return (1e3 * 6.2 / 4 + 1e3 * 10 / 8) * h * h; };
  const double fine = residual(1e-4), coarse = residual(4e-4);
  CHECK(fine < bound(1e-4));
  CHECK(coarse < bound(4e-4));
  CHECK(fine > 0);
}

TEST_CASE("without an audit all energies are zero") {
  scree::Scene s = scree::test::scene(3, 1e-3, {scree::test::body(0, 1, 1, {{0, 0, 0.9}})},
                                      {{"normal_stiffness", {1e3}}, {"normal_damping", {1}}});
  scree::test::add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  s.audit = false;
  scree::Simulation without(s);
  s.audit = true;
  scree::Simulation with(s);
  scree::test::run(without, 50);
  scree::test::run(with, 50);
  CHECK(without.energy().dissipated_normal == 0);
  CHECK(without.energy_residual() == 0);
  CHECK(with.energy().dissipated_normal > 0);
  // The audit does not change the motion.
  CHECK(with.state_hash() == without.state_hash());
}

TEST_CASE("the energy of a free wall that a stage stops counts as turned over") {
  scree::Scene s = scree::test::scene(2, 1e-3, {scree::test::body(1, 0.005, 1, {}, {}, {}, 2)},
                                      {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
  constexpr double force = 3, fixed = 0;
  const scree::test::Values geometry = {{"point", {0, 1, 0}}, {"normal", {0, -1, 0}}};
  scree::test::Values pressed = geometry, stopped = geometry;
  pressed.insert(pressed.end(), {{"control", {4}}, {"force", {0, force}}});
  stopped.push_back({"control", {fixed}});
  scree::test::add_boundary(s, "plane", pressed);
  scree::Simulation simulation(s);
  scree::test::run(simulation, 100);
  REQUIRE(simulation.energy().kinetic_boundary == Approx(0.5 * force * force * 0.01));
  simulation.reconfigure_boundary("plane", scree::test::parameters("plane", SCREE_BOUNDARY, stopped));
  simulation.apply_reconfiguration();
  simulation.step();
  CHECK(std::abs(simulation.energy().work) < 1e-15);
  // Round-off of 100 sums, not the 1 of nothing over nothing.
  CHECK(simulation.energy_residual() < 100 * 2.2e-16);
}
