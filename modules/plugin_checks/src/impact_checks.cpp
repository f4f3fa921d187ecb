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
constexpr Impact impacts[] = {{0, 0}, {0.4, 0}, {0.8, 0.7}, {0.8, -1.5}, {1.3, 0}};

struct Outcome {
  double residual, created, momentum, kinetic_ratio, duration;
};

Body body_of(const CheckedPair& pair, int dimension, std::int64_t id, double radius) {
  const double r = radius;
  const double mass = pair.density * (dimension == 2 ? pi * r * r : 4.0 / 3.0 * pi * r * r * r);
  return {.id = id, .radius = r, .mass = mass, .inertia = (dimension == 2 ? 0.5 : 0.4) * mass * r * r};
}

Scene scene_of(const Parameters& law, const CheckedPair& pair, int dimension, const Impact& impact,
               double step) {
  Body a = body_of(pair, dimension, 1, pair.radius), b = body_of(pair, dimension, 2, 1.5 * pair.radius);
  const double reach = a.radius + b.radius;
  // They touch after a few steps, b at rest at the origin.
  const double gap = 3.3 * step * pair.speed * std::cos(impact.angle);
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
std::optional<Outcome> outcome_of(const Parameters& law, const CheckedPair& pair, int dimension,
                                  const Impact& impact, double contact_time, int steps_per_contact) {
  const double step = contact_time / steps_per_contact;
  Simulation simulation(scene_of(law, pair, dimension, impact, step));
  const double before = kinetic(simulation.energy());
  int touching = 0;
  double residual = 0;  // largest, also while they touch and energy is stored
  for (int k = 0; k < 20 * steps_per_contact; ++k) {
    simulation.step();
    residual = std::max(residual, simulation.energy_residual());
    const bool touches = !simulation.contact_list().a.empty();
    if (!touches && touching > 0)
      return Outcome{residual, simulation.energy_created(), simulation.momentum_residual(),
                     kinetic(simulation.energy()) / before, touching * step};
    touching += touches;
  }
  return std::nullopt;
}

// The larger of values that must fall with the step: at a quarter of the step at most 1/3 of it remains
// (first order, with a margin), unless it is round-off.
double remaining(double coarse, double fine) {
  constexpr double round_off = 1e-11;
  return fine <= round_off ? 0 : fine / std::max(coarse, round_off);
}

std::optional<double> closed_form(const Parameters& law, const CheckedPair& pair, int dimension,
                                  std::string_view name) {
  const ConfiguredLaw configured(law, dimension, no_bounds, no_bounds);
  const double m1 = body_of(pair, dimension, 1, pair.radius).mass,
               m2 = body_of(pair, dimension, 2, 1.5 * pair.radius).mass;
  const scree_encounter encounter = {m1 * m2 / (m1 + m2), pair.radius * 1.5 / 2.5, pair.speed, 1};
  scree_closed_form forms[16];
  const std::uint32_t n = configured.interface().closed_forms(configured.storage(), &encounter, forms, 16);
  for (std::uint32_t k = 0; k < n; ++k)
    if (forms[k].name == name) return forms[k].value;
  return std::nullopt;
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
  constexpr int coarse_steps = 100, fine_steps = 400;
  const std::string balance = "the energy balance of impacts closes as the step falls",
                    created = "no energy is created, but for a part that vanishes with the step",
                    momentum = "momentum is conserved",
                    restitution = "the closed form of the restitution holds";
  const ConfiguredLaw configured(law, dimension, no_bounds, no_bounds);
  const double contact_time = contact_time_of(configured, pair, dimension);
  if (contact_time <= 0) {
    const std::string why = "the law has no closed form contact_time";
    return {{balance, Verdict::skipped, why},
            {created, Verdict::skipped, why},
            {momentum, Verdict::skipped, why},
            {restitution, Verdict::skipped, why}};
  }
  double open = 0, made = 0, residual = 0, made_fine = 0, net_momentum = 0, head_on = -1;
  for (const Impact& impact : impacts) {
    const auto coarse = outcome_of(law, pair, dimension, impact, contact_time, coarse_steps);
    const auto fine = outcome_of(law, pair, dimension, impact, contact_time, fine_steps);
    if (!coarse || !fine) continue;  // they stay together
    open = std::max(open, remaining(coarse->residual, fine->residual));
    made = std::max(made, remaining(coarse->created, fine->created));
    residual = std::max(residual, fine->residual);
    made_fine = std::max(made_fine, fine->created);
    net_momentum = std::max({net_momentum, coarse->momentum, fine->momentum});
    if (impact.angle == 0) head_on = measured_restitution(pair, dimension, fine->kinetic_ratio);
  }
  constexpr double first_order = 1.0 / 3;
  Checks all = {bounded(balance, open, first_order), bounded(created, made, first_order),
                bounded(momentum, net_momentum, 1e-12)};
  all[0].detail = fmt::format("residual {:.2g} at t_c/{}, {:.2g} of that at t_c/{}", residual, fine_steps,
                              open, coarse_steps);
  all[1].detail = fmt::format("{:.2g} of the energy turned over at t_c/{}", made_fine, fine_steps);
  const auto stated = closed_form(law, pair, dimension, "restitution");
  if (stated && head_on >= 0)
    all.push_back(bounded(restitution, std::abs(head_on - *stated), 1e-3));
  else
    all.push_back({restitution, Verdict::skipped, stated ? "the bodies do not part" : "the law states none"});
  return all;
}

}  // namespace scree::plugin_checks
