#include "impact_deviation.hpp"

#include <catch2/catch.hpp>

// Impacts over the grid of all options together, law × history × tension × restitution × friction × angle ×
// spin × wall or pair, against the reference, which integrates the same continuous laws to 1e-10 and shares
// no code with the kernel. Errors are of the velocity and of the spin at the surface, over the speed of the
// impact, rms over eight phases of first touch.

using namespace scree;
using namespace scree::test;

namespace {

using reference::History;
using reference::SlipRule;
using reference::Tension;

// Both laws with all histories; the linear one with and without a tangential dashpot.
std::vector<ImpactCase> contact_laws() {
  std::vector<ImpactCase> all;
  for (const bool damped : {true, false}) all.push_back({.tangential_damping = damped});
  for (const History history : {History::displacement, History::rescaled, History::potential})
    all.push_back({.hertz = true, .history = history});
  return all;
}

// One impact in `stride`.
template <class Visit>
void each_impact(const std::vector<double>& restitutions, const std::vector<double>& frictions,
                 const std::vector<double>& angles, const std::vector<Vec3>& impact_spins, const Visit& visit,
                 std::size_t stride = 1) {
  std::size_t count = 0;
  for (ImpactCase c : contact_laws())
    for (const double e : restitutions)
      for (const Tension tension : {Tension::allowed, Tension::cut})
        for (const double mu : frictions)
          for (const double angle : angles)
            for (const Vec3& spin : impact_spins)
              for (const bool wall : {true, false}) {
                if (e == 1 && tension == Tension::cut) continue;  // without a dashpot there is no tension
                c.restitution = e, c.tension = tension, c.friction = mu;
                c.angle = angle * std::numbers::pi / 180, c.spin = spin, c.wall = wall;
                if (count++ % (stride * every) == 0) visit(c);
              }
}

}  // namespace

TEST_CASE("all options together: motion, energy and each column of the energy balance follow the laws",
          "[grid]") {
  double coarse_squares = 0, fine_squares = 0, coarse_residual = 0, fine_residual = 0;
  each_impact(
      {1, 0.9, 0.5, 0.3}, {0.1, 0.3, 1}, {10, 30, 45, 60, 75, 85}, impact_spins, [&](const ImpactCase& c) {
        const ImpactPair pair(c);
        const reference::Outcome exact = pair.reference();
        const Deviation coarse = deviation(pair, exact, 50), fine = deviation(pair, exact, 200);
        INFO(name_of(c));
        // The extra normal force of the potential form has a peak where its spring reaches the limit, a few
        // steps after first touch.
        const bool peak = c.hertz && c.history == History::potential;
        CHECK(coarse.motion < (peak ? 2 : 1) * step_error(50));
        CHECK(fine.motion < step_error(200));
        // Energies are squares, with twice the relative error; the balance sums powers by the trapezoidal
        // rule as well.
        CHECK(coarse.column < 3 * step_error(50));
        CHECK(fine.column < 3 * step_error(200));
        CHECK(fine.residual < 3 * step_error(200));
        // Velocity Verlet keeps an oscillator's energy to (ω h)²/4 relative.
        CHECK(coarse.largest_gain < 0.25 * step_error(50));
        if (c.history != History::displacement || !c.hertz) CHECK(fine.largest_created < 1e-12);
        coarse_squares += coarse.motion * coarse.motion, fine_squares += fine.motion * fine.motion;
        coarse_residual += coarse.residual * coarse.residual, fine_residual += fine.residual * fine.residual;
      });
  const double motion = order(coarse_squares, fine_squares, 16),
               balance = order(coarse_residual, fine_residual, 16);
  WARN("rms over the grid: order of motion " << motion << ", of the energy residual " << balance);
  CHECK(motion > 1.8);
  CHECK(balance > 1.8);
}

TEST_CASE("restitution of damped contacts at a fiftieth of a contact, both tensions", "[grid]") {
  const auto error = [](const ImpactCase& c, double steps) {
    double squares = 0;
    for (int k = 0; k < phases; ++k)
      squares +=
          std::pow(ImpactPair(c).run(steps, (k + 0.5) / phases).velocity[2] - c.restitution, 2) / phases;
    return std::sqrt(squares);
  };
  for (const bool hertz : {false, true})
    for (const Tension tension : {Tension::allowed, Tension::cut})
      for (const double e : {0.5, 0.9}) {
        const ImpactCase c = {.hertz = hertz, .restitution = e, .tension = tension, .angle = 0};
        const double at_fifty = error(c, 50), fine = error(c, 400);
        WARN((hertz ? "hertz" : "linear")
             << (tension == Tension::cut ? " cut" : " allowed") << " e = " << e << ": error " << at_fifty
             << ", order " << order(at_fifty, fine, 8));
        CHECK(at_fifty < (e == 0.5 ? 1.5e-3 : 3e-4));
        // Where this is small, the error from the time of first touch within a step remains: at most
        // (h/t_c)².
        CHECK(fine < std::pow(1.0 / 400, 2) * 3);
      }
}

TEST_CASE("sliding impacts: frictional impulse to a per mille at a fiftieth of a contact", "[grid]") {
  double worst = 0, worst_kinked = 0;
  double coarse_squares[2] = {}, fine_squares[2] = {};
  each_impact({1, 0.9, 0.7, 0.5, 0.3}, {0.1, 0.3}, {75, 80}, {{}}, [&](const ImpactCase& c) {
    const ImpactPair pair(c);
    const reference::Outcome exact = pair.reference();
    const Deviation coarse = deviation(pair, exact, 50), fine = deviation(pair, exact, 400);
    INFO(name_of(c));
    // The extra normal force of the potential form peaks within the first steps, where the spring reaches the
    // limit. Fifty steps do not resolve this; the error is less than the contribution of one step.
    const bool kinked = c.hertz && c.history == History::potential;
    // Without a tangential dashpot friction grows to a limit that jumps. Where in a step this ends follows
    // from velocities at its end, which dashpots with e = 0.3 change by a fifth in the two steps that count.
    const bool grows = !c.hertz && !c.tangential_damping && c.restitution < 1;
    coarse_squares[kinked] += coarse.impulse * coarse.impulse;
    fine_squares[kinked] += fine.impulse * fine.impulse;
    CHECK(fine.impulse < 1e-4);
    CHECK(coarse.impulse < (kinked ? 1.0 / 50 : grows ? 0.2 / 50 : 1e-3));
    double& largest = kinked ? worst_kinked : worst;
    largest = std::max(largest, coarse.impulse);
    // The impulse is μ times that of the normal force: with cut tension μ (1 + e) v_n.
    if (!kinked && !grows && c.wall && c.tension == Tension::cut)
      CHECK(norm(ImpactPair::vec(exact.tangential_impulse)) / exact.a.mass ==
            Approx(c.friction * (1 + c.restitution) * std::cos(c.angle)).epsilon(1e-6));
  });
  for (const bool kinked : {false, true}) {
    const double observed = order(coarse_squares[kinked], fine_squares[kinked], 64);
    WARN((kinked ? "with a kink in the first steps: " : "")
         << "largest error of the impulse " << (kinked ? worst_kinked : worst) << ", order " << observed);
    CHECK(observed > 1.5);
  }
}

TEST_CASE("impacts that stick from first touch: sixty steps per contact for a per mille, every history",
          "[grid]") {
  // The remaining spring is released when the normal force vanishes: with μ = 1 within a few steps, with 10
  // in less than one, a jump within a step, which is an error of first order.
  for (const double mu : {1.0, 10.0}) {
    double coarse_squares = 0, fine_squares = 0, worst = 0;
    each_impact({1, 0.9, 0.5, 0.3}, {mu}, {10, 20, 30}, {{}}, [&](const ImpactCase& c) {
      const ImpactPair pair(c);
      const reference::Outcome exact = pair.reference();
      const Deviation coarse = deviation(pair, exact, 60), fine = deviation(pair, exact, 480);
      INFO(name_of(c));
      CHECK(coarse.across < 1e-3);
      worst = std::max(worst, coarse.across);
      coarse_squares += coarse.across * coarse.across, fine_squares += fine.across * fine.across;
    });
    const double observed = order(coarse_squares, fine_squares, 64);
    WARN("μ = " << mu << ": largest error " << worst << ", order " << observed);
    CHECK(observed > (mu == 1 ? 1.5 : 1));
  }
}

TEST_CASE("discs: all options together", "[grid]") {
  each_impact({1, 0.5}, {0.3, 1}, {20, 45, 70}, {{}, {{0, 0, 150}}}, [&](ImpactCase c) {
    c.dimension = 2;
    const ImpactPair pair(c);
    const reference::Outcome exact = pair.reference();
    INFO(name_of(c));
    CHECK(deviation(pair, exact, 50).motion < 2 * step_error(50));
    CHECK(deviation(pair, exact, 200).motion < step_error(200));
  });
}

TEST_CASE("the slip rule of David et al., by the total force: impacts that slide throughout", "[grid]") {
  double coarse_squares = 0, fine_squares = 0;
  for (const double e : {0.9, 0.5})
    for (const Tension tension : {Tension::allowed, Tension::cut})
      for (const double angle : {75.0, 80.0, 85.0})
        for (const bool wall : {true, false}) {
          const ImpactPair pair({.slip_rule = SlipRule::total,
                                 .restitution = e,
                                 .tension = tension,
                                 .angle = angle * std::numbers::pi / 180,
                                 .wall = wall});
          const reference::Outcome exact = pair.reference();
          if (exact.switches > 0) continue;
          const Deviation coarse = deviation(pair, exact, 50), fine = deviation(pair, exact, 400);
          INFO("e = " << e << ", " << angle << " degrees");
          CHECK(coarse.impulse < 1e-3);
          CHECK(fine.impulse < 1e-4);
          coarse_squares += coarse.impulse * coarse.impulse, fine_squares += fine.impulse * fine.impulse;
        }
  CHECK(order(coarse_squares, fine_squares, 64) > 1.5);
}

namespace {

// What every impact must satisfy, and squares of the errors for the order. The steps are those of the grid
// above.
class Convergence {
 public:
  void check(const ImpactCase& c) {
    INFO(name_of(c));
    const auto [coarse, fine] = check_motion(c);
    CHECK(coarse.column < 3 * step_error(50));
    CHECK(fine.column < 3 * step_error(200));
    CHECK(fine.residual < 3 * step_error(200));
    CHECK(fine.largest_created < 1e-12);
  }
  // Returns the deviations with 50 and with 200 steps.
  std::pair<Deviation, Deviation> check_motion(const ImpactCase& c) {
    const ImpactPair pair(c);
    const reference::Outcome exact = pair.reference();
    const Deviation coarse = deviation(pair, exact, 50), fine = deviation(pair, exact, 200);
    INFO(name_of(c));
    CHECK(coarse.motion < step_error(50));
    CHECK(fine.motion < step_error(200));
    CHECK(coarse.largest_gain < 0.25 * step_error(50));
    coarse_ += coarse.motion * coarse.motion, fine_ += fine.motion * fine.motion;
    coarse_residual_ += coarse.residual * coarse.residual, fine_residual_ += fine.residual * fine.residual;
    ++impacts_;
    return {coarse, fine};
  }
  // Errors of a few impacts dominate the rms: of the whole grid only, not of its sample under the sanitizers.
  void check_order_of_motion() const {
    WARN(impacts_ << " impacts: order of motion " << motion());
    if (every == 1) CHECK(motion() > 1.8);
  }
  void check_order_of_balance() const {
    WARN(impacts_ << " impacts: order of the energy residual " << balance());
    if (every == 1) CHECK(balance() > 1.8);
  }

 private:
  double motion() const { return order(coarse_, fine_, 16); }
  double balance() const { return order(coarse_residual_, fine_residual_, 16); }

  double coarse_ = 0, fine_ = 0, coarse_residual_ = 0, fine_residual_ = 0;
  int impacts_ = 0;
};

}  // namespace

TEST_CASE("dynamic friction below the static one, all options together: of second order", "[grid]") {
  // Prime to the number of values of each option, so that all values and most pairs of them occur.
  constexpr std::size_t stride = 11;
  for (const int dimension : {2, 3}) {
    Convergence convergence;
    for (const double share : {0.9, 0.6, 0.2})
      each_impact(
          {1, 0.9, 0.5, 0.3}, {0.1, 0.3, 1}, {10, 30, 45, 60, 75, 85},
          dimension == 3 ? impact_spins : std::vector<Vec3>{{}, {{0, 0, 150}}, {{0, 0, -150}}},
          [&](ImpactCase c) {
            if (c.hertz) return;  // one coefficient of friction
            c.dynamic_share = share, c.dimension = dimension;
            convergence.check(c);
          },
          stride);
    INFO(dimension << "D");
    convergence.check_order_of_motion();
    convergence.check_order_of_balance();
  }
}

TEST_CASE("with a dashpot, slip that ends at once or while the limit rises: of second order", "[grid]") {
  Convergence convergence;
  for (const double mu : {0.5, 0.55, 0.6})
    for (const double angle : {0.2, 0.25})
      for (const Tension tension : {Tension::allowed, Tension::cut}) {
        const ImpactCase c = {.restitution = 0.3,
                              .tension = tension,
                              .friction = mu,
                              .dynamic_share = 0.3,
                              .stiffness_ratio = 0.5,
                              .angle = angle,
                              .spin = {{200, 50, 80}}};
        INFO(name_of(c));
        CHECK(ImpactPair(c).reference().switches >= 2);  // one begin and one end at least
        convergence.check(c);
      }
  convergence.check_order_of_motion();
}

TEST_CASE("position Verlet as velocity Verlet, also where bodies touch in its first half step", "[grid]") {
  // Its energy balance counts half of what the first half step dissipates, a term of first order: motion
  // only.
  Convergence convergence;
  each_impact(
      {1, 0.9, 0.5, 0.3}, {0.1, 0.3, 1}, {10, 30, 45, 60, 75, 85}, impact_spins,
      [&](ImpactCase c) {
        if (c.hertz && c.history == History::potential) return;  // its peak is not resolved
        c.integration = Integration::position_verlet;
        convergence.check_motion(c);
        if (!c.hertz) c.dynamic_share = 0.6, convergence.check_motion(c);
      },
      37);
  convergence.check_order_of_motion();
}

TEST_CASE("grazing impacts with the potential of the tangential spring need the steps that the law states",
          "[grid]") {
  double coarse_squares = 0, fine_squares = 0, worst = 0, few = 0;
  for (const double e : {0.5, 0.3})
    for (const Tension tension : {Tension::allowed, Tension::cut})
      for (const double mu : {0.3, 1.0})
        for (const double angle : {73.0, 80.0, 85.0, 89.0})
          for (const bool wall : {true, false}) {
            const ImpactCase c = {.hertz = true,
                                  .history = History::potential,
                                  .restitution = e,
                                  .tension = tension,
                                  .friction = mu,
                                  .angle = angle * std::numbers::pi / 180,
                                  .wall = wall};
            const ImpactPair pair(c);
            const double steps = std::max(50.0, pair.grazing_steps());
            const reference::Outcome exact = pair.reference();
            const double impulse = exact.normal_impulse / exact.a.mass / ImpactPair::speed;
            const double coarse = deviation(pair, exact, steps).motion / impulse,
                         fine = deviation(pair, exact, 3 * steps).motion / impulse;
            INFO(name_of(c) << ", " << steps << " steps");
            // As of other histories with fifty steps; of the impulse, which is small.
            CHECK(coarse < step_error(50));
            worst = std::max(worst, coarse);
            few = std::max(few, deviation(pair, exact, 50).motion / impulse);
            coarse_squares += coarse * coarse, fine_squares += fine * fine;
          }
  const double observed = order(coarse_squares, fine_squares, 9);
  WARN("largest error of the impulse " << worst << ", with fifty steps " << few << "; order " << observed);
  CHECK(observed > 1.5);
  CHECK(few > 5 * step_error(50));  // where the law states more than fifty steps, they are needed
}
