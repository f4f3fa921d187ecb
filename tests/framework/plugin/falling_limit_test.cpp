#include <cmath>

#include <catch2/catch.hpp>

#include <scree/plugin/falling_limit.hpp>

using namespace scree;

namespace {

constexpr double falling_stiffness = 1000, mu_s = 0.5, mu_d = 0.2;  // N/m

// A contact that is moved past another at velocity(t) (m/s) with the normal force pressing(t) (N).
template <class Velocity, class Pressing>
struct Drive {
  double damping;  // kg/s
  Velocity velocity;
  Pressing pressing;

  // Impulse of the tangential force (N s) over a time (s), from the state at t = 0, the sum over steps.
  Vec2 impulse(double time, int steps, Vec2 spring, bool slid) const {
    const double h = time / steps;
    double state = slid ? slip_at_start(h) : norm(spring) - mu_s * pressing(0) / falling_stiffness;
    const Vec2 first = falling_stiffness * spring + damping * velocity(0);
    Vec2 sum = (-0.5 * h) * detail::limited(first, (slid ? mu_d : mu_s) * pressing(0));
    for (int n = 1; n <= steps; ++n) {
      const FallingSlip<2, double> result = step(spring, h * velocity((n - 0.5) * h), n * h, h, state);
      spring = result.slip.spring, state = result.state;
      sum += (n == steps ? 0.5 * h : h) * (result.slip.force + result.begun);
    }
    return sum;
  }
  FallingSlip<2, double> step(const Vec2& spring, const Vec2& moved, double t, double h, double state) const {
    const Vec2 trial = spring + moved, v = velocity(t);
    return slide_or_stick(FallingLimit<2, double>{.step = {.trial_spring = trial,
                                                           .stiffness = falling_stiffness,
                                                           .inverse_stiffness = 1 / falling_stiffness,
                                                           .velocity = v,
                                                           .delay = damping / falling_stiffness,
                                                           .step = h,
                                                           .limit = 0,
                                                           .sliding_limit = mu_d * pressing(t)},
                                                  .static_limit = mu_s * pressing(t),
                                                  .ratio = mu_d / mu_s,
                                                  .before = spring,
                                                  .state_before = state,
                                                  .moving = h > 0});
  }
  // S of a step before t = 0, along x.
  double slip_at_start(double h) const {
    return h * velocity(-0.5 * h)[0] - mu_d * (pressing(0) - pressing(-h)) / falling_stiffness;
  }
};

// Observed order of the impulse over a time, from rms errors of ten times.
template <class AnyDrive>
double order_of_impulse(const AnyDrive& drive, double time, const Vec2& spring, bool slid) {
  double coarse = 0, fine = 0;
  for (int k = 0; k < 10; ++k) {
    const double t = (1 + 0.01 * k) * time;
    const Vec2 exact = drive.impulse(t, 20000, spring, slid);
    const Vec2 few = drive.impulse(t, 40, spring, slid) - exact,
               many = drive.impulse(t, 160, spring, slid) - exact;
    coarse += dot(few, few), fine += dot(many, many);
  }
  return std::log(coarse / fine) / std::log(16.0);
}

double constant(double) { return 2; }

}  // namespace

TEST_CASE("the impulse does not depend on where in a step slip begins", "[friction]") {
  const double v = 0.03, C_s = mu_s * 2, C_d = mu_d * 2, begins = C_s / (falling_stiffness * v);
  const auto steady = [&](double) { return Vec2{{v, 0}}; };
  const Drive<decltype(steady), decltype(&constant)> drive = {0, steady, &constant};
  for (const double time : {1.5, 1.51, 1.53, 1.57, 1.6}) {
    const double after = time * begins, exact = 0.5 * C_s * begins + C_d * (after - begins);
    INFO("until " << time << " times the begin of slip");
    // The kink at θ from the slope k v to 0 leaves ½ θ (1 − θ) k v h²; the fall by 0.6 N would leave up to
    // 0.3 N h.
    const double h = after / 20;
    CHECK(std::abs(-drive.impulse(after, 20, {}, false)[0] - exact) < 0.13 * falling_stiffness * v * h * h);
  }
}

TEST_CASE("slip that begins across the spring, with a dashpot, has an impulse of second order",
          "[friction]") {
  const auto across = [](double t) { return Vec2{{0.03, 0.01 + 0.2 * t}}; };
  const Drive<decltype(across), decltype(&constant)> drive = {8, across, &constant};
  CHECK(order_of_impulse(drive, 0.06, {{0, 0.0004}}, false) == Approx(2).margin(0.25));
}

TEST_CASE("where slip ends while the limit rises, the force of the dashpot jumps: second order",
          "[friction]") {
  // Slip ends where v = μ_d f_n'/k = 0.02 m/s, at t = 0.05 s.
  const auto slowing = [](double t) { return Vec2{{0.03 - 0.2 * t, 0}}; };
  const auto rising = [](double t) { return 2 + 100 * t; };
  const Drive<decltype(slowing), decltype(rising)> drive = {10, slowing, rising};
  CHECK(order_of_impulse(drive, 0.08, {{mu_d * 2 / falling_stiffness, 0}}, true) == Approx(2).margin(0.25));
}

TEST_CASE("a spring that falls and then falls short of the limit sticks at once", "[friction]") {
  // In the step μ_s f_n falls from 1 to 0.8 N and k ξ from 0.99 to 0.85 N: e from −0.01 to 0.05 N, θ = 1/6.
  // There μ_s f_n = 29/30 N, and k ξ falls by 0.6 of it, to 0.27 N at the end of the step, where μ_d f_n =
  // 0.32 N.
  const auto back = [](double) { return Vec2{{-0.14, 0}}; };
  const auto falling = [](double t) { return 2 - 400 * t; };
  const Drive<decltype(back), decltype(falling)> drive = {1, back, falling};
  const auto result = drive.step({{0.99e-3, 0}}, {{-1.4e-4, 0}}, 1e-3, 1e-3, -1e-5);
  CHECK(result.slip.slides);
  CHECK(falling_stiffness * result.slip.spring[0] == Approx(0.27));
  CHECK(falling_stiffness * result.state == Approx(0.27 - 0.8));
  CHECK(result.slip.force[0] == Approx(-0.27 + 0.14));
  CHECK(result.begun[0] == Approx((0.5 - 1.0 / 6) * 0.6 * 29 / 30));
}

TEST_CASE("without motion the force is that of the configuration", "[friction]") {
  const auto still = [](double) { return Vec2{}; };
  const Drive<decltype(still), decltype(&constant)> drive = {1, still, &constant};
  const auto result = drive.step({{0.002, 0}}, {}, 0, 0, -1e-4);
  CHECK(result.begun == Vec2{});
  CHECK(result.slip.force[0] == Approx(-mu_d * 2));
}
