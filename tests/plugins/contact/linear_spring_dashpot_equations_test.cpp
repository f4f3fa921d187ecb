#include "law_batch.hpp"

#include <cmath>

#include <catch2/catch.hpp>

// [D1]-[D4] of David et al. 2005 for one contact, written out by hand. Each result is a few operations:
// equal to within a few roundings.

using namespace scree;
using namespace scree::test;

namespace {

constexpr struct {
  double k = 5000, gamma_n = 0.5, k_t = 1000, gamma_t = 0.2, mu_s = 0.5, mu_d = 0.3;
  double overlap = 1e-3, step = 1e-6;
} constants;

enum Rule { by_spring, by_total };

LawBatch contact(Rule rule = by_total) {
  LawBatch c("linear_spring_dashpot", {{"normal_stiffness", {constants.k}},
                                       {"normal_damping", {constants.gamma_n}},
                                       {"tangential_stiffness", {constants.k_t}},
                                       {"tangential_damping", {constants.gamma_t}},
                                       {"static_friction", {constants.mu_s}},
                                       {"dynamic_friction", {constants.mu_d}},
                                       {"slip_rule", {double(rule)}}});
  c.set(SCREE_NORMAL, {{0, 0, 1}});
  c.input(SCREE_OVERLAP) = constants.overlap;
  return c;
}

void set_spring(LawBatch& c, const Vec3& spring, bool sliding = false) {
  for (int a = 0; a < 3; ++a) c.history(std::size_t(a)) = spring[a];
  c.history(3) = sliding;
}

Vec3 spring_of(const LawBatch& c) { return {{c.history(0), c.history(1), c.history(2)}}; }

void check_equal(const Vec3& a, const Vec3& b, double scale) { CHECK(norm(a - b) < 1e-14 * scale); }

}  // namespace

TEST_CASE("[D1]: f_n = k δ + γ δ'", "[equations]") {
  LawBatch c = contact();
  c.set(SCREE_RELATIVE_VELOCITY, {{0, 0, -0.3}});
  c.evaluate(constants.step);
  check_equal(c.force(), {{0, 0, constants.k * constants.overlap + constants.gamma_n * 0.3}}, 5);
  CHECK(c.output(SCREE_ELASTIC_NORMAL) == Approx(0.5 * constants.k * constants.overlap * constants.overlap));
  CHECK(c.output(SCREE_DISSIPATION_RATE_NORMAL) == Approx(constants.gamma_n * 0.09));
}

TEST_CASE("[D3]: in stick the force is that of the trial spring and the dashpot", "[equations]") {
  LawBatch c = contact();
  const Vec3 old = {{1e-4, 0, 0}}, moved = {{2e-5, 3e-5, 0}}, slip = {{0.1, -0.2, 0}};
  set_spring(c, old);
  c.set(SCREE_TANGENTIAL_INCREMENT, moved);
  c.set(SCREE_RELATIVE_VELOCITY, slip);
  c.evaluate(constants.step);
  check_equal(c.force(),
              Vec3{{0, 0, constants.k * constants.overlap}} - constants.k_t * (old + moved) -
                  constants.gamma_t * slip,
              5);
  check_equal(spring_of(c), old + moved, 1e-4);
  CHECK(c.history(3) == 0);
  CHECK(c.output(SCREE_ELASTIC_TANGENTIAL) == Approx(0.5 * constants.k_t * dot(old + moved, old + moved)));
  CHECK(c.output(SCREE_DISSIPATION_RATE_TANGENTIAL) == Approx(constants.gamma_t * dot(slip, slip)));
  CHECK(c.output(SCREE_DISSIPATED_FRICTION) == Approx(0).margin(1e-20));
}

TEST_CASE("the spring is projected onto the present tangent plane", "[equations]") {
  LawBatch c = contact();
  const double angle = 0.1;
  c.set(SCREE_NORMAL, {{std::sin(angle), 0, std::cos(angle)}});
  set_spring(c, {{1e-4, 5e-5, 0}});
  c.evaluate(constants.step);
  const Vec3 n = {{std::sin(angle), 0, std::cos(angle)}}, old = {{1e-4, 5e-5, 0}};
  check_equal(spring_of(c), old - dot(n, old) * n, 1e-4);
}

TEST_CASE("[D4]: beyond μ_s f_n it slides at μ_d f_n and the spring is reset including the dashpot force",
          "[equations]") {
  LawBatch c = contact();
  const Vec3 old = {{3e-3, 1e-3, 0}}, slip = {{0.5, -1, 0}};
  set_spring(c, old);
  c.set(SCREE_RELATIVE_VELOCITY, slip);
  c.evaluate(0);  // with step 0 the slip direction cannot turn
  const double f_n = constants.k * constants.overlap;
  const Vec3 f_0 = -constants.k_t * old - constants.gamma_t * slip;
  REQUIRE(norm(f_0) > constants.mu_s * f_n);
  const Vec3 f_t = (constants.mu_d * f_n / norm(f_0)) * f_0;
  check_equal(c.force(), Vec3{{0, 0, f_n}} + f_t, 5);
  check_equal(spring_of(c), (-1 / constants.k_t) * (f_t + constants.gamma_t * slip), 1e-3);
  CHECK(c.history(3) == 1);
  CHECK(c.output(SCREE_DISSIPATED_FRICTION) == Approx(-dot(f_t, old - spring_of(c))));
}

TEST_CASE("[D4]: the spring compensates the whole dashpot force, whatever its onset weight", "[equations]") {
  LawBatch c = contact();
  const Vec3 old = {{3e-3, 1e-3, 0}}, slip = {{0.5, -1, 0}};
  set_spring(c, old);
  c.set(SCREE_RELATIVE_VELOCITY, slip);
  c.input(SCREE_ONSET_WEIGHT) = 0.4;
  c.evaluate(0);
  const Vec3 f_0 = -constants.k_t * old - constants.gamma_t * slip,
             f_t = (constants.mu_d * constants.k * constants.overlap / norm(f_0)) * f_0;
  check_equal(spring_of(c), (-1 / constants.k_t) * (f_t + constants.gamma_t * slip), 1e-3);
}

TEST_CASE("[D3]: the force obeys Coulomb's law also with onset weights", "[equations]") {
  for (const double weight : {0.1, 0.7, 1.4}) {
    LawBatch c = contact();
    // Stick: the test force without weights is below the limit, which the normal dashpot increases.
    c.set(SCREE_RELATIVE_VELOCITY, {{20, 0, -10}});
    c.input(SCREE_ONSET_WEIGHT) = weight;
    c.evaluate(constants.step);
    const double f_n = constants.k * constants.overlap + weight * constants.gamma_n * 10;
    REQUIRE(c.history(3) == 0);
    INFO("weight " << weight);
    CHECK(c.force()[2] == Approx(f_n));
    CHECK(std::abs(c.force()[0]) == Approx(std::min(weight * constants.gamma_t * 20, constants.mu_s * f_n)));
  }
}

TEST_CASE("by the spring: in stick the force is that of spring and dashpot, limited by Coulomb's law",
          "[equations]") {
  LawBatch c = contact(by_spring);
  const Vec3 old = {{1e-3, 0, 0}}, slip = {{3, 4, 0}};
  set_spring(c, old);
  c.set(SCREE_RELATIVE_VELOCITY, slip);
  c.evaluate(constants.step);
  const double f_n = constants.k * constants.overlap;
  const Vec3 whole = -constants.k_t * old - constants.gamma_t * slip;
  REQUIRE(norm(constants.k_t * old) < constants.mu_s * f_n);
  REQUIRE(norm(whole) < constants.mu_s * f_n);
  check_equal(c.force(), Vec3{{0, 0, f_n}} + whole, 5);
  c.set(SCREE_RELATIVE_VELOCITY, 10 * slip);
  c.evaluate(constants.step);
  const Vec3 more = -constants.k_t * old - 10 * constants.gamma_t * slip;
  check_equal(c.force(), Vec3{{0, 0, f_n}} + (constants.mu_s * f_n / norm(more)) * more, 5);
  check_equal(spring_of(c), old, 1e-4);  // the dashpot never causes slip
  CHECK(c.history(3) <= 0);
  CHECK(c.output(SCREE_DISSIPATED_FRICTION) == 0);
  CHECK(c.output(SCREE_DISSIPATION_RATE_TANGENTIAL) ==
        Approx(dot((constants.mu_s * f_n / norm(more)) * (-1.0 * more) - constants.k_t * old, 10 * slip)));
}

TEST_CASE("by the spring: in slip the spring force stays μ_d f_n, and the dashpot acts against the motion",
          "[equations]") {
  LawBatch c = contact(by_spring);
  const double f_n = constants.k * constants.overlap, excess = 1e-3;
  const Vec3 unit = {{0.6, 0.8, 0}}, old = ((1 + excess) * constants.mu_d * f_n / constants.k_t) * unit;
  set_spring(c, old, true);
  c.set(SCREE_RELATIVE_VELOCITY, -0.5 * unit);
  c.evaluate(0);
  check_equal(spring_of(c), (constants.mu_d * f_n / constants.k_t) * unit, 1e-3);
  // The dashpot is exact to second order in the excess of the trial spring over the limit.
  CHECK(norm(c.force() - (Vec3{{0, 0, f_n}} - (constants.mu_d * f_n - 0.5 * constants.gamma_t) * unit)) <
        excess * excess);
  CHECK(c.history(3) > 0);
  CHECK(c.output(SCREE_DISSIPATED_FRICTION) ==
        Approx(0.5 * constants.k_t * dot(old + spring_of(c), old - spring_of(c))));
  CHECK(c.output(SCREE_DISSIPATION_RATE_TANGENTIAL) ==
        Approx(constants.gamma_t * 0.25).epsilon(excess * excess));
  CHECK(c.output(SCREE_DISSIPATED_RELEASE) == 0);
}

TEST_CASE("between μ_d and μ_s the previous state decides between stick and slip", "[equations]") {
  const double f_n = constants.k * constants.overlap;
  const Vec3 spring = {{0.4 * f_n / constants.k_t, 0, 0}};
  LawBatch sticking = contact();
  set_spring(sticking, spring, false);
  sticking.evaluate(constants.step);
  CHECK(sticking.history(3) == 0);
  CHECK(sticking.force()[0] == Approx(-0.4 * f_n));
  LawBatch sliding = contact();
  set_spring(sliding, spring, true);
  sliding.evaluate(constants.step);
  CHECK(sliding.history(3) == 1);
  CHECK(sliding.force()[0] == Approx(-constants.mu_d * f_n));
  // Below μ_d it sticks again.
  LawBatch again = contact();
  set_spring(again, 0.5 * spring, true);
  again.evaluate(constants.step);
  CHECK(again.history(3) == 0);
}

TEST_CASE("an open pair has no force, and the energy of its spring counts as released", "[equations]") {
  LawBatch c = contact();
  set_spring(c, {{1e-4, 0, 0}}, true);
  c.input(SCREE_OVERLAP) = -1e-6;
  c.set(SCREE_RELATIVE_VELOCITY, {{1, 1, 1}});
  c.evaluate(constants.step);
  check_equal(c.force(), {}, 1);
  check_equal(spring_of(c), {}, 1);
  CHECK(c.history(3) == 0);
  CHECK(c.output(SCREE_DISSIPATED_RELEASE) == Approx(0.5 * constants.k_t * 1e-8));
  CHECK(c.output(SCREE_DISSIPATED_FRICTION) == 0);
}

TEST_CASE("frictionless scenes pay nothing for friction", "[equations]") {
  const LawBatch smooth("linear_spring_dashpot",
                        {{"normal_stiffness", {constants.k}}, {"normal_damping", {constants.gamma_n}}});
  CHECK(smooth.instance().history_width == 0);
  CHECK(smooth.instance().tangential == 0);
  CHECK((smooth.instance().reads & (1u << SCREE_TANGENTIAL_INCREMENT)) == 0);
  const LawBatch flat("linear_spring_dashpot",
                      {{"normal_stiffness", {constants.k}},
                       {"normal_damping", {constants.gamma_n}},
                       {"tangential_stiffness", {constants.k_t}},
                       {"static_friction", {0.5}}},
                      2);
  CHECK(flat.instance().history_width == 3);
}
