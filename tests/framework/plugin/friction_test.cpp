#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include <scree/plugin/friction.hpp>

using namespace scree;

namespace {

constexpr double slip_stiffness = 1000, slip_limit = 0.5;  // N/m, N

// A spring at the limit, in the plane, moved at slip_velocity(t) for a time. Returns the angle of its force.
template <class Velocity>
double angle_after(double angle, double time, int steps, const Velocity& slip_velocity) {
  const double h = time / steps;
  Vec2 spring = (slip_limit / slip_stiffness) * Vec2{{std::cos(angle), std::sin(angle)}};
  for (int n = 0; n < steps; ++n) {
    const Vec2 moved = spring + h * slip_velocity((n + 0.5) * h), velocity = slip_velocity((n + 1) * h);
    const auto slip = slide_or_stick(SlipStep<2, double>{.trial_spring = moved,
                                                         .stiffness = slip_stiffness,
                                                         .inverse_stiffness = 1 / slip_stiffness,
                                                         .velocity = velocity,
                                                         .delay = 0,
                                                         .step = h,
                                                         .limit = slip_limit,
                                                         .sliding_limit = slip_limit});
    spring = slip.spring;
  }
  return std::atan2(spring[1], spring[0]);
}

}  // namespace

TEST_CASE("the direction of a sliding spring turns towards a steady slip, at second order", "[friction]") {
  // α' = −(k v/C) sin α, with the angle α to the slip: tan(α/2) falls as exp(−k v t/C).
  const double v = 0.02, start = 1.2, time = 0.03;
  const double exact = 2 * std::atan(std::tan(start / 2) * std::exp(-slip_stiffness * v * time / slip_limit));
  const auto steady = [&](double) { return Vec2{{v, 0}}; };
  const auto error = [&](int steps) { return std::abs(angle_after(start, time, steps, steady) - exact); };
  // A step turns it by x = k v h/C = 1.2/steps; a scheme of second order has a relative error of about x².
  CHECK(error(40) < std::pow(1.2 / 40, 2));
  CHECK(std::log2(error(40) / error(160)) / 2 == Approx(2).margin(0.2));
}

TEST_CASE("a steadily turning slip is followed with the exact lag, also in steps longer than the memory",
          "[friction]") {
  // α' = (k v/C) sin(ωt − α): in the long run α = ωt − asin(ω C/(k v)).
  const double omega = 5, time = 2;
  for (const double v : {0.02, 0.2, 20.0}) {
    const auto turning = [&](double t) { return Vec2{{v * std::cos(omega * t), v * std::sin(omega * t)}}; };
    const double lag = std::asin(omega * slip_limit / (slip_stiffness * v));
    const auto error = [&](int steps) {
      return std::abs(
          std::remainder(angle_after(0, time, steps, turning) - (omega * time - lag), 2 * std::numbers::pi));
    };
    INFO("slip velocity " << v << " m/s, lag " << lag);
    // In a step the slip turns by ω h, and the spring follows by the fraction x = k v h/C. A return along
    // the trial spring would lag by ω h/2 more. Here it is (1 + x/2)/(1 + x/2 + x²/4) − 1 times ω h/x, by the
    // series of p in x: at most ω h/6, −x ω h/4 for small x.
    for (const int steps : {400, 1600}) {
      const double turned = omega * time / steps, x = slip_stiffness * v * time / steps / slip_limit;
      CHECK(error(steps) < 1.1 * std::min(x / 4, 1.0 / 6) * turned);
    }
  }
}

TEST_CASE("forces obey Coulomb's law, and spring and dashpot only dissipate, for any step", "[friction]") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(-3, 3), direction(-1, 1);
  const auto vector = [&](double size) {
    return size * Vec3{{direction(random), direction(random), direction(random)}};
  };
  int slid = 0, stuck = 0;
  for (int k = 0; k < 20000; ++k) {
    const double bound = slip_limit * std::pow(10, exponent(random));
    Vec3 old = vector(bound / slip_stiffness);
    old = (std::min(1.0, bound / slip_stiffness / norm(old))) * old;
    const Vec3 velocity = vector(std::pow(10, exponent(random)));
    const double h = 1e-3 * std::pow(10, exponent(random));
    const Vec3 moved = old + h * velocity;
    const double damping = 0.1 * std::pow(10, exponent(random));
    const auto slip = slide_or_stick(SlipStep<3, double>{.trial_spring = moved,
                                                         .stiffness = slip_stiffness,
                                                         .inverse_stiffness = 1 / slip_stiffness,
                                                         .velocity = velocity,
                                                         .delay = damping / slip_stiffness,
                                                         .step = h,
                                                         .limit = bound,
                                                         .sliding_limit = bound});
    (slip.slides ? slid : stuck)++;
    const double round_off = 1e-14;
    CHECK(norm(slip.force) <= bound * (1 + round_off));
    CHECK(slip_stiffness * norm(slip.spring) <= bound * (1 + round_off));
    // Power of the dashpot, and work of the spring's force on slip.
    CHECK(-dot(slip.force + slip_stiffness * slip.spring, velocity) >= -round_off * bound * norm(velocity));
    if (!slip.slides) CHECK(slip.spring == moved);
    // On a straight path the spring slips forwards.
    CHECK(dot(slip.spring, moved - slip.spring) >= -round_off * dot(moved, moved));
  }
  CHECK(slid > 5000);
  CHECK(stuck > 2000);
}
