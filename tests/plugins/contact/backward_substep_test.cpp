#include "impact_deviation.hpp"

#include <catch2/catch.hpp>

// Impacts with `fourth_order`, whose third substep goes backwards in time through slip, through springs that
// were rescaled and, with a dashpot, through first touch: against the reference, which shares no code with
// the kernel. Errors are of the velocity and of the spin at the surface, over the speed of the impact, rms
// over eight phases of first touch.

using namespace scree;
using namespace scree::test;

namespace {

using reference::History;
using reference::Tension;

std::vector<ImpactCase> laws_with_springs() {
  std::vector<ImpactCase> all = {{}, {.dynamic_share = 0.6}, {.painted = true}};
  for (const History history : {History::displacement, History::rescaled, History::potential})
    all.push_back({.hertz = true, .history = history});
  for (ImpactCase& c : all) c.integration = Integration::fourth_order;
  return all;
}

// One impact in five, prime to the number of values of each option.
template <class Visit>
void each_impact_backwards(double restitution, const Visit& visit) {
  std::size_t count = 0;
  for (ImpactCase c : laws_with_springs())
    for (const double mu : {0.1, 0.5})
      for (const double degrees : {20.0, 45.0, 75.0})
        for (const Vec3& spin : impact_spins)
          for (const bool wall : {true, false}) {
            c.restitution = restitution, c.friction = mu, c.angle = degrees * std::numbers::pi / 180;
            c.tension = restitution < 1 ? Tension::cut : Tension::allowed;
            c.spin = spin, c.wall = wall;
            if (count++ % 5 == 0) visit(c);
          }
}

// Sums of squares with 25 and with 200 steps.
struct BackwardErrors {
  double coarse = 0, fine = 0, coarse_balance = 0, fine_balance = 0;
  double largest = 0;  // with 25 steps

  double of_motion() const { return order(coarse, fine, 64); }
  double of_balance() const { return order(coarse_balance, fine_balance, 64); }
};

BackwardErrors errors_backwards(double restitution) {
  BackwardErrors sums;
  each_impact_backwards(restitution, [&](const ImpactCase& c) {
    const ImpactPair pair(c);
    const reference::Outcome exact = pair.reference();
    const Deviation coarse = deviation(pair, exact, 25), fine = deviation(pair, exact, 200);
    INFO(name_of(c));
    if (c.history != History::displacement || !c.hertz) CHECK(fine.largest_created < 1e-12);
    sums.coarse += coarse.motion * coarse.motion, sums.fine += fine.motion * fine.motion;
    sums.coarse_balance += coarse.residual * coarse.residual;
    sums.fine_balance += fine.residual * fine.residual;
    sums.largest = std::max(sums.largest, coarse.motion);
  });
  WARN("e = " << restitution << ": largest error " << sums.largest << ", order " << sums.of_motion()
              << ", of the balance " << sums.of_balance());
  return sums;
}

}  // namespace

TEST_CASE("fourth_order goes backwards through slip and rescaled springs: of second order without dashpots",
          "[grid]") {
  const BackwardErrors errors = errors_backwards(1);
  CHECK(errors.largest < step_error(25) / 10);
  CHECK(errors.of_motion() > 1.6);
  CHECK(errors.of_balance() > 1.8);
}

TEST_CASE("fourth_order with dashpots: of first order, by their onset", "[grid]") {
  // A jump within a step of which an end of a substep is up to a fifth away.
  const BackwardErrors errors = errors_backwards(0.7);
  CHECK(errors.largest < 0.2 / 25);
  CHECK(errors.of_motion() > 0.9);
  CHECK(errors.of_balance() > 1.4);
}
