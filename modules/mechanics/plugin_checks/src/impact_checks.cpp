#include "law_under_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/simulation.hpp>

// Impacts of two bodies, followed by the kernel.

namespace scree::plugin_checks {

namespace {

using Verdict = Check::Verdict;
constexpr double pi = std::numbers::pi;

// Angle between the velocity and the normal at first touch (rad), and spin of the first body in units of
// speed/radius.
struct Impact {
  double angle, spin;
};
constexpr int coarse_steps = 100, fine_steps = 400;  // in a contact
// Parts of a step that are left at first touch: errors depend on them.
constexpr double phases[] = {0.1, 0.3, 0.5, 0.7, 0.9};
constexpr Impact impacts[] = {{0, 0}, {0.4, 0}, {0.8, 0.7}, {0.8, -1.5}, {1.3, 0}};

// Residuals are the largest of an impact, relative to the energy turned over.
struct Residuals {
  double residual, created, momentum, kinetic_ratio, duration;
};

// The largest over all impacts.
struct Errors {
  double residual = 0, created = 0, momentum = 0;

  void add(const Residuals& o) {
    raise(residual, o.residual);
    raise(created, o.created);
    raise(momentum, o.momentum);
  }
  // A number that is not finite stays.
  static void raise(double& largest, double value) {
    if (!(value <= largest)) largest = value;
  }
};

Body body_of(const CheckedPair& pair, int dimension, std::int64_t id, double radius) {
  const double r = radius;
  const double mass = pair.density * (dimension == 2 ? pi * r * r : 4.0 / 3.0 * pi * r * r * r);
  return {.id = id, .radius = r, .mass = mass, .inertia = (dimension == 2 ? 0.5 : 0.4) * mass * r * r};
}

Scene scene_of(const Parameters& law, const CheckedPair& pair, int dimension, const Impact& impact,
               double phase, double step) {
  Body a = body_of(pair, dimension, 1, pair.radius), b = body_of(pair, dimension, 2, 1.5 * pair.radius);
  const double reach = a.radius + b.radius;
  // They touch after a few steps, b at rest at the origin.
  const double gap = (3 + phase) * step * pair.speed * std::cos(impact.angle);
  a.position = {{-reach - gap, 0, 0}};
  a.velocity = pair.speed * Vec3{{std::cos(impact.angle), std::sin(impact.angle), 0}};
  a.position[1] -= gap * std::tan(impact.angle);
  a.spin[2] = impact.spin * pair.speed / pair.radius;
  Scene scene;
  scene.dimension = dimension;
  scene.step = step;
  scene.materials = {"grain"};
  scene.bodies = {a, b};
  scene.laws = {{law.plugin().name, law}};
  scene.law_of = {0};
  scene.spin = exerts_torque(law, dimension);
  scene.limits.overlap_ratio = 1;  // soft laws are checked too
  return scene;
}

double kinetic(const scree_energy& e) { return e.kinetic_translation + e.kinetic_rotation; }

// Nothing if the bodies do not part within 20 contact times.
std::optional<Residuals> residuals_of(const Parameters& law, const CheckedPair& pair, int dimension,
                                      const Impact& impact, double phase, double contact_time,
                                      int steps_per_contact) {
  const double step = contact_time / steps_per_contact;
  Simulation simulation(scene_of(law, pair, dimension, impact, phase, step));
  const double before = kinetic(simulation.energy());
  int touching = 0;
  double residual = 0;  // largest, also while they touch and energy is stored
  for (int k = 0; k < 20 * steps_per_contact; ++k) {
    simulation.step();
    Errors::raise(residual, simulation.energy_residual());
    const bool touches = !simulation.contact_list().a.empty();
    if (!touches && touching > 0)
      return Residuals{residual, simulation.energy_created(), simulation.momentum_residual(),
                       kinetic(simulation.energy()) / before, touching * step};
    touching += touches;
  }
  return std::nullopt;
}

// An error that must fall with the step: of the largest over all impacts and their phases at most 1/3 may
// remain at a quarter of the step (first order, with a margin), unless it is round-off.
Check falling(const std::string& name, double coarse, double fine) {
  constexpr double round_off = 1e-11, first_order = 1.0 / 3;
  if (fine <= round_off)
    return {name, Verdict::passed,
            fmt::format("{:.2g} of the energy turned over at t_c/{}: round-off", fine, fine_steps)};
  const double remaining = fine / std::max(coarse, round_off);
  Check check = bounded(name, remaining, first_order);
  check.detail = fmt::format(
      "{:.2g} of the energy turned over {} to {:.2f} of itself from t_c/{} to t_c/{}; at most {:.2f}", coarse,
      remaining > 1 ? "grows" : "falls", remaining, coarse_steps, fine_steps, first_order);
  return check;
}

// Kinetic energy in the frame of the common centre of mass, of which an impact leaves the square of the
// restitution.
double measured_restitution(const CheckedPair& pair, int dimension, double kinetic_ratio) {
  const double m1 = body_of(pair, dimension, 1, pair.radius).mass,
               m2 = body_of(pair, dimension, 2, 1.5 * pair.radius).mass;
  const double of_centre = m1 / (m1 + m2);
  return std::sqrt(std::max(0.0, (kinetic_ratio - of_centre) / (1 - of_centre)));
}

}  // namespace

Checks check_impacts(const Parameters& law, const CheckedPair& pair, int dimension) {
  const std::string balance = "the energy balance of impacts closes as the step falls",
                    created = "no energy is created, but for a part that vanishes with the step",
                    momentum = "momentum is conserved",
                    duration = "the closed form contact_time is that of a head-on impact",
                    restitution = "the closed form restitution is that of a head-on impact";
  const ConfiguredLaw configured(law, dimension, no_bounds, no_bounds);
  const double contact_time = contact_time_of(configured, pair, dimension);
  if (contact_time <= 0) {
    Checks none;
    for (const std::string& name : {balance, created, momentum, duration, restitution})
      none.push_back({name, Verdict::skipped, "the law has no closed form contact_time"});
    return none;
  }
  Errors coarse, fine;
  std::optional<Residuals> head_on;
  try {
    for (const Impact& impact : impacts)
      for (const double phase : phases) {
        const auto follow = [&](int steps) {
          return residuals_of(law, pair, dimension, impact, phase, contact_time, steps);
        };
        // Nothing if the bodies stay together.
        if (const auto o = follow(coarse_steps)) coarse.add(*o);
        const auto o = follow(fine_steps);
        if (o) fine.add(*o);
        if (impact.angle == 0) head_on = o;
      }
  } catch (const Error& error) {
    return {{"impacts can be followed", Verdict::failed, error.what()}};
  }
  Checks all = {falling(balance, coarse.residual, fine.residual),
                falling(created, coarse.created, fine.created),
                bounded(momentum, std::max(coarse.momentum, fine.momentum), 1e-12)};
  if (!head_on) {
    all.push_back(
        {duration, Verdict::failed,
         "the bodies do not part within 20 contact times; state the right time, or check at a higher "
         "--speed"});
    return all;
  }
  // Laws may state the time of the undamped contact, which damping changes by some per cent.
  all.push_back(bounded(duration, std::abs(head_on->duration / contact_time - 1), 0.2));
  if (const auto stated = closed_form(configured, pair, dimension, "restitution"))
    all.push_back(bounded(restitution,
                          std::abs(measured_restitution(pair, dimension, head_on->kinetic_ratio) - *stated),
                          1e-3));
  else
    all.push_back({restitution, Verdict::skipped, "the law states none"});
  return all;
}

}  // namespace scree::plugin_checks
