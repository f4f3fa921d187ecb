#include "impact.hpp"

#include "coefficients.hpp"
#include "dormand_prince.hpp"
#include "setups.hpp"

#include <catch2/catch.hpp>

// The reference against closed forms. Where nothing else is said the tolerances are 1e-10: the steps are
// exact to 1e-11 of the whole each, there are about a hundred, and their errors add up as random ones.

using namespace setups;
using std::numbers::pi;

TEST_CASE("the coefficients of the integration meet the conditions of order") {
  namespace dp = dormand_prince;
  for (int power = 0; power < 8; ++power) {
    double sum = 0;
    for (int i = 0; i < dp::stages; ++i) sum += dp::weights[i] * std::pow(dp::nodes[i], power);
    CHECK(sum == Approx(1.0 / (power + 1)).epsilon(1e-14));  // rounding of a sum whose terms reach 6
  }
  for (int i = 0; i < dp::stages; ++i) {
    double sum = 0;
    for (const double coefficient : dp::matrix[i]) sum += coefficient;
    CHECK(sum == Approx(dp::nodes[i]).margin(2e-14));  // terms reach 43
  }
}

TEST_CASE("the linear law has its restitution and contact time") {
  const double e = GENERATE(1.0, 0.9, 0.5, 0.2);
  const double frequency = std::sqrt(stiffness / mass);
  SECTION("with tension") {
    const Outcome outcome = integrate(on_wall(linear(e, Tension::allowed)));
    const double ratio = -std::log(e) / std::hypot(pi, std::log(e));
    CHECK(outcome.a.velocity.z == Approx(e).epsilon(1e-10));
    CHECK(outcome.contact_time == Approx(pi / (frequency * std::sqrt(1 - ratio * ratio))).epsilon(1e-10));
  }
  SECTION("without") {
    const Outcome outcome = integrate(on_wall(linear(e, Tension::cut)));
    const double ratio = damping_ratio(e, Tension::cut), root = std::sqrt(1 - ratio * ratio);
    const double pushing = std::atan2(2 * ratio * root, 2 * ratio * ratio - 1) / (frequency * root);
    CHECK(outcome.a.velocity.z == Approx(e).epsilon(1e-10));
    CHECK(outcome.pushing_time == Approx(pushing).epsilon(1e-10));
    const double left =
        std::exp(-ratio * frequency * pushing) * std::sin(frequency * root * pushing) / (frequency * root);
    CHECK(outcome.contact_time == Approx(pushing + left / e).epsilon(1e-10));
  }
}

TEST_CASE("the overdamped linear law without tension has its restitution") {
  const double e = GENERATE(0.135, 0.1, 0.03);  // exp(-2) = 0.1353 is that of critical damping
  const Outcome outcome = integrate(on_wall(linear(e, Tension::cut)));
  CHECK(damping_ratio(e, Tension::cut) > 1);
  CHECK(outcome.a.velocity.z ==
        Approx(e).epsilon(1e-9));  // a part e of the velocity is left of which to lose digits
}

TEST_CASE("the hertz law has its restitution at every speed") {
  const double e = GENERATE(0.3, 0.5, 0.8, 1.0), speed = GENERATE(0.001, 0.1, 10.0);
  const Tension tension = GENERATE(Tension::allowed, Tension::cut);
  const Outcome outcome = integrate(on_wall(hertz(e, tension, History::rescaled), 0, speed));
  CHECK(outcome.a.velocity.z == Approx(e * speed).epsilon(1e-10));
  CHECK(outcome.normal_impulse == Approx(mass * speed * (1 + e)).epsilon(1e-10));
}

TEST_CASE("the undamped hertz law has its contact time and overlap") {
  const double modulus = 1e8 / (2 * (1 - 0.09)), speed = 0.7;
  const Outcome outcome = integrate(on_wall(hertz(1, Tension::cut, History::rescaled), 0, speed));
  // 2.8682656992 (m*²/(R* E*² v))^(1/5), to the digits of the number
  CHECK(outcome.contact_time ==
        Approx(2.8682656992 * std::pow(mass * mass / (radius * modulus * modulus * speed), 0.2))
            .epsilon(1e-10));
  const double overlap = std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
  CHECK(outcome.largest_overlap == Approx(overlap).epsilon(1e-10));
}

TEST_CASE("a sticking sphere reverses its slip as the spring swings as long as the contact lasts") {
  Impact impact = on_wall(linear(1, Tension::cut), 45, 0.01);
  impact.law.friction = std::numeric_limits<double>::infinity();
  impact.a.spin = {0, -1.5, 0};
  const Outcome outcome = integrate(impact);
  // The arm is shorter than the radius by half the overlap.
  const double margin = 3 * outcome.largest_overlap / radius * std::abs(slip_along_x(impact.a));
  CHECK(slip_along_x(outcome.a) == Approx(-slip_along_x(impact.a)).margin(margin));
  CHECK(outcome.slides == 0);
}

TEST_CASE("the impulse of what slides from first to last is friction times the normal impulse") {
  const History history = GENERATE(History::displacement, History::rescaled, History::potential);
  Impact impact =
      GENERATE_COPY(on_wall(linear(1, Tension::cut), 80), on_wall(linear(1, Tension::allowed), 80),
                    on_wall(hertz(1, Tension::cut, history), 80));
  impact.law.friction = 0.2;
  const Outcome outcome = integrate(impact);
  CHECK(outcome.slides == 1);
  CHECK(outcome.switches == 0);
  // The spring of the potential history adds to the normal impulse, not to the limit.
  if (impact.law.kind == LawKind::linear || history != History::potential)
    CHECK(-outcome.tangential_impulse.x == Approx(0.2 * outcome.normal_impulse).epsilon(1e-10));
  else
    CHECK(-outcome.tangential_impulse.x < 0.2 * outcome.normal_impulse);
  CHECK(norm(outcome.tangential_impulse) == Approx(std::abs(outcome.tangential_impulse.x)));
}

TEST_CASE("a strong tangential dashpot keeps a sticking spring at the Coulomb limit") {
  Impact impact = on_wall(linear(0.5, Tension::cut), 80);
  impact.law.friction = 0.2;
  impact.law.tangential_damping = 100;
  const Outcome outcome = integrate(impact);
  CHECK(-outcome.tangential_impulse.x == Approx(0.2 * outcome.normal_impulse).epsilon(1e-10));
}

TEST_CASE("samples follow the motion before, during and after the contact") {
  Impact impact = on_wall(linear(1, Tension::cut));
  impact.a.position.z += 0.001;
  const double frequency = std::sqrt(stiffness / mass), half = pi / frequency;
  impact.sample_times = {0.0005, 0.001 + 0.01 * half, 0.001 + 0.3 * half, 0.001 + 0.8 * half, 0.002 + half};
  const Outcome outcome = integrate(impact);
  REQUIRE(outcome.samples.size() == 5);
  CHECK(outcome.first_touch == Approx(0.001).epsilon(1e-12));
  CHECK(outcome.samples[0].overlap == Approx(-0.0005).epsilon(1e-12));
  CHECK(outcome.samples[4].overlap == Approx(-0.001).epsilon(1e-9));
  for (const int i : {1, 2, 3}) {
    const Sample& sample = outcome.samples[i];
    CHECK(sample.time == Approx(impact.sample_times[i]).epsilon(1e-13));
    const double overlap = std::sin(frequency * (impact.sample_times[i] - 0.001)) / frequency;
    CHECK(sample.overlap == Approx(overlap).epsilon(1e-10));
    CHECK(radius - sample.a.position.z == Approx(overlap).epsilon(1e-9));
    CHECK(sample.force.z == Approx(stiffness * overlap).epsilon(1e-10));
  }
}

TEST_CASE("bodies that miss or recede do not touch") {
  Impact impact = on_body(linear(1, Tension::cut));
  impact.a.velocity = -impact.a.velocity;
  std::get<Body>(impact.other).velocity = {};
  CHECK_FALSE(integrate(impact).touched);
  impact = on_wall(linear(1, Tension::cut));
  impact.a.velocity = {1, 0, 0};
  CHECK_FALSE(integrate(impact).touched);
}

TEST_CASE("ill-posed impacts are refused") {
  Impact impact = on_wall(linear(1, Tension::cut));
  impact.a.position.z *= 0.9;
  CHECK_THROWS_AS(integrate(impact), std::invalid_argument);
  impact = on_wall(hertz(0.5, Tension::cut, History::rescaled));
  impact.law.slip_rule = SlipRule::total;
  CHECK_THROWS_AS(integrate(impact), std::invalid_argument);
  impact = on_wall(linear(1, Tension::allowed));
  impact.law.restitution.reset();
  impact.law.normal_damping = 2.1 * std::sqrt(stiffness * mass);
  CHECK_THROWS_AS(integrate(impact), std::invalid_argument);
}
