#pragma once

#include "impact_pair.hpp"

// Errors of impacts against the reference: of the velocity and of the spin at the surface, over the speed of
// the impact, rms over eight phases of first touch.

namespace scree::test {

inline constexpr int phases = 8;
#ifdef SCREE_TEST_FEWER_IMPACTS
inline constexpr std::size_t every = 11;
#else
inline constexpr std::size_t every = 1;
#endif

// None; backwards; about an axis outside the plane of impact, with a part along the normal (rad/s).
inline const std::vector<Vec3> impact_spins = {{}, {{0, -150, 0}}, {{200, 50, 80}}};

// (ω h)²: the step error of an oscillator whose half period, the contact time, takes this number of steps.
inline double step_error(double steps) { return std::pow(std::numbers::pi / steps, 2); }

// Errors over all phases of an impact.
struct Deviation {
  double motion = 0;           // rms error
  double across = 0;           // of the velocity component perpendicular to the normal at first touch
  double impulse = 0;          // the same, relative to the change of that component by friction
  double largest_gain = -1;    // of kinetic energy, relative to that before
  double column = 0;           // largest error of any energy column, relative to the kinetic energy before
  double residual = 0;         // rms of the residual of the energy balance, likewise
  double largest_created = 0;  // largest energy created by the law, likewise
};

inline double column_error(const scree_energy& e, const reference::Outcome& o) {
  const double errors[] = {e.dissipated_normal - o.dissipated.normal,
                           e.dissipated_tangential - o.dissipated.tangential,
                           e.dissipated_friction - o.dissipated.friction,
                           e.dissipated_release - o.dissipated.release,
                           e.created - o.created,
                           e.elastic_normal,
                           e.elastic_tangential};
  double largest = 0;
  for (const double error : errors) largest = std::max(largest, std::abs(error));
  return largest;
}

inline Deviation deviation(const ImpactPair& pair, const reference::Outcome& exact, double steps) {
  Deviation d;
  const Vec3 velocity = ImpactPair::vec(exact.a.velocity), spin = ImpactPair::vec(exact.a.spin);
  const double impulse = norm(ImpactPair::vec(exact.tangential_impulse)) / exact.a.mass;
  for (int k = 0; k < phases; ++k) {
    const ImpactResult r = pair.run(steps, (k + 0.5) / phases);
    const Vec3 off = r.velocity - velocity, turned = exact.a.radius * (r.spin - spin);
    d.motion += (dot(off, off) + 0.4 * dot(turned, turned)) / phases;
    const Vec3 across = tangential_part(off, pair.normal());
    d.across += dot(across, across) / phases;
    d.largest_gain = std::max(d.largest_gain, r.kinetic_after / r.kinetic_before - 1);
    d.column = std::max(d.column, column_error(r.balance, exact) / r.kinetic_before);
    d.residual += std::pow(r.balance.residual / r.kinetic_before, 2) / phases;
    d.largest_created = std::max(d.largest_created, r.balance.created / r.kinetic_before);
  }
  d.motion = std::sqrt(d.motion), d.across = std::sqrt(d.across), d.residual = std::sqrt(d.residual);
  d.impulse = d.across / impulse;
  return d;
}

inline double order(double coarse, double fine, double refinement) {
  return std::log(coarse / fine) / std::log(refinement);
}

}  // namespace scree::test
