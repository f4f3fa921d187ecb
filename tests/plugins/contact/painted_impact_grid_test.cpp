#include "impact_deviation.hpp"

#include <catch2/catch.hpp>

// Impacts with a spring between painted points, over normal force × restitution × tension × tangential
// dashpot × friction × angle × spin × wall or pair × rigidity, against a reference that takes forces and
// torques as derivatives of the stored energy with respect to the painted points and shares no code with the
// kernel.

using namespace scree;
using namespace scree::test;

namespace {

using reference::Tension;

// One impact in so many: prime to the number of values of each option, so that all values and most pairs of
// them occur.
constexpr std::size_t stride = 97;

struct Opposite {
  bool wall;
  double size_ratio, mass_ratio;
};

std::vector<ImpactCase> painted_laws() {
  std::vector<ImpactCase> all;
  for (const bool damped : {true, false}) all.push_back({.tangential_damping = damped, .painted = true});
  all.push_back({.hertz = true, .history = reference::History::potential, .painted = true});
  return all;
}

// Of the velocity, over the speed: points are painted anew at the first step, up to h late, on which an arc
// exceeds 0.1 rad. Until then twist at ω_n stretches the spring by up to ω_n 0.1 R h; it takes about a
// contact time to pull.
double painting_error(const ImpactCase& c, const ImpactPair& pair, double steps) {
  const double rolled =
      pair.contact_time() * (ImpactPair::speed / ImpactPair::radius + norm(c.spin));  // (rad) at most
  return rolled > 0.1 ? c.spin[2] * 0.1 * ImpactPair::radius / ImpactPair::speed / steps : 0;
}

template <class Visit>
void each_painted_impact(const Visit& visit) {
  std::size_t count = 0;
  for (ImpactCase c : painted_laws())
    for (const double e : {1.0, 0.8, 0.4})
      for (const Tension tension : {Tension::allowed, Tension::cut})
        for (const double mu : {0.0, 0.1, 0.3, 1.0, 10.0})
          for (const double angle : {10, 35, 60, 80})
            for (const Vec3& spin : impact_spins)
              for (const Opposite& other : {Opposite{true, 1, 1}, {false, 1, 1}, {false, 0.6, 0.4}})
                for (const double rigidity : {1.0, 0.03}) {
                  if (e == 1 && tension == Tension::cut) continue;  // without a dashpot there is no tension
                  c.restitution = e, c.tension = tension, c.friction = mu, c.spin = spin;
                  c.angle = angle * std::numbers::pi / 180, c.rigidity = rigidity;
                  c.wall = other.wall, c.size_ratio = other.size_ratio, c.mass_ratio = other.mass_ratio;
                  if (count++ % (stride * every) == 0) visit(c);
                }
}

}  // namespace

TEST_CASE("painted points, all options together: motion, energy and each column of the energy balance",
          "[grid]") {
  each_painted_impact([&](const ImpactCase& c) {
    const ImpactPair pair(c);
    const reference::Outcome exact = pair.reference();
    const Deviation coarse = deviation(pair, exact, 50), fine = deviation(pair, exact, 200);
    INFO(name_of(c));
    // Limits as of the laws without painted points: of the extra normal force of Hertz's stored energy, which
    // has a peak a few steps after first touch, and of energies, squares with twice the relative error.
    CHECK(coarse.motion < (c.hertz ? 2 : 1) * step_error(50));
    CHECK(fine.motion < step_error(200) + painting_error(c, pair, 200));
    CHECK(coarse.column < 3 * step_error(50));
    CHECK(fine.column < 3 * step_error(200));
    CHECK(fine.residual < 3 * step_error(200));
    CHECK(coarse.largest_gain < 0.25 * step_error(50));
    CHECK(fine.largest_created < 1e-12);
  });
}

TEST_CASE("painted points with dynamic friction below the static one: of second order", "[grid]") {
  double coarse = 0, fine = 0;
  for (const bool damped : {true, false})
    for (const double degrees : {20.0, 35.0, 60.0})
      for (const bool wall : {true, false}) {
        const ImpactPair pair({.friction = 0.4,
                               .dynamic_share = 0.5,
                               .tangential_damping = damped,
                               .angle = degrees * std::numbers::pi / 180,
                               .spin = {{0, -60, 0}},
                               .wall = wall,
                               .painted = true});
        // Its own error is below that of 160 steps by (160/3000)².
        const ImpactResult exact = pair.run(3000, 0.5);
        const auto square_error = [&](double steps) {
          double sum = 0;
          for (int k = 0; k < phases; ++k) {
            const ImpactResult r = pair.run(steps, (k + 0.5) / phases);
            const Vec3 off = r.velocity - exact.velocity, turned = ImpactPair::radius * (r.spin - exact.spin);
            sum += (dot(off, off) + 0.4 * dot(turned, turned)) / phases;
            CHECK(r.balance.created / r.kinetic_before < 1e-12);
          }
          return sum;
        };
        coarse += square_error(40), fine += square_error(160);
      }
  const double observed = order(coarse, fine, 16);
  WARN("order " << observed);
  CHECK(observed > 1.8);
}
