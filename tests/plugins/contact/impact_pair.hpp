#pragma once

#include "impact.hpp"
#include "painted_impact.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <scree/closed_forms.hpp>

// One impact, computed by the kernel and by the reference, which share no code.

namespace scree::test {

struct ImpactCase {
  bool hertz = false;
  reference::History history = reference::History::rescaled;
  reference::SlipRule slip_rule = reference::SlipRule::spring;
  double restitution = 0.5;
  reference::Tension tension = reference::Tension::cut;
  double friction = 0.3;             // μ_s
  double dynamic_share = 1;          // μ_d/μ_s
  double stiffness_ratio = 2.0 / 7;  // k_t/k of the linear law
  bool tangential_damping = true;    // γ_t = 2ζ √(k_t m*) of the linear law; Hertz has it with e < 1
  double angle = 0.5;                // between the velocity and the normal at first touch (rad)
  Vec3 spin = {};                    // of a (rad/s)
  bool wall = true;
  int dimension = 3;
  bool painted = false;     // sphere_path_independent, with the normal force of the law above
  double size_ratio = 0.6;  // R_b/R_a
  double mass_ratio = 0.4;  // m_b/m_a
  double rigidity = 1;      // scale of all stiffnesses
  Integration integration = Integration::velocity_verlet;
};

inline std::string name_of(const ImpactCase& c) {
  char text[200];
  const char* histories[] = {"displacement", "rescaled", "potential"};
  std::snprintf(text, sizeof(text), "%s%s %s e=%g %s mu=%g,%g angle=%.3g spin=(%g,%g,%g) %s %g %dD%s %s",
                c.painted ? "painted " : "", c.hertz ? "hertz" : "linear",
                c.hertz ? histories[int(c.history)] : (c.tangential_damping ? "damped" : "undamped"),
                c.restitution, c.tension == reference::Tension::cut ? "cut" : "allowed", c.friction,
                c.dynamic_share * c.friction, c.angle * 180 / std::numbers::pi, c.spin[0], c.spin[1],
                c.spin[2], c.wall ? "wall" : "pair", c.size_ratio, c.dimension,
                c.slip_rule == reference::SlipRule::total ? " total" : "", traits_of(c.integration).name);
  return text;
}

// Result of an impact, for body a.
struct ImpactResult {
  Vec3 velocity = {}, spin = {};
  double kinetic_before = 0, kinetic_after = 0;  // of all bodies (J)
  scree_energy balance = {};
};

class ImpactPair {
 public:
  explicit ImpactPair(const ImpactCase& c) : case_(c) {}

  // Undamped contact of the same normal law at the same normal speed (s).
  double contact_time() const {
    if (!case_.hertz) return std::numbers::pi * std::sqrt(reduced_mass() / stiffness());
    const double modulus = youngs_modulus() / (1 - poissons_ratio * poissons_ratio) / 2;
    return 2.8682656992 *
           std::pow(reduced_mass() * reduced_mass() /
                        (effective_radius() * modulus * modulus * speed * std::cos(case_.angle)),
                    0.2);
  }

  // The kernel, with this number of steps per contact time; first touch is after the fraction `phase` of a
  // step.
  ImpactResult run(double steps, double phase) const {
    const double step = contact_time() / steps;
    std::vector<scree::Body> bodies;
    for (const reference::Body& b : bodies_at(-phase * step))
      bodies.push_back(body(std::int64_t(bodies.size()) + 1, b.radius, b.mass, vec(b.position),
                            vec(b.velocity), vec(b.spin), b.dimension));
    Scene s = scene(case_.dimension, step, bodies, parameters_of_law(), name_of_law());
    s.pair_forces = false;
    s.integration = case_.integration;
    if (case_.wall) add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", plane_normal()}});
    Simulation simulation(s);
    ImpactResult r;
    r.kinetic_before = kinetic(simulation.energy());
    std::uint64_t count = 0;
    const auto end = std::uint64_t(20 * steps);
    simulation.run(end, [&] { return ++count < std::uint64_t(2.2 * steps) + 3; });
    const scree::Body a = simulation.particles().body(0);
    r.velocity = a.velocity;
    r.spin = a.spin;
    r.balance = simulation.energy();
    r.kinetic_after = kinetic(r.balance);
    return r;
  }

  reference::Outcome reference(double tolerance = 1e-10) const {
    reference::Impact impact;
    impact.law = law();
    const auto bodies = bodies_at(case_.painted ? 0 : -0.1 * contact_time());
    impact.a = bodies[0];
    if (case_.wall)
      impact.other = reference::Wall{{}, up()};
    else
      impact.other = bodies[1];
    if (case_.painted) return reference::integrate_painted(impact, painted_steps);
    return reference::integrate(impact, tolerance);
  }

  // Steps per contact that the law states for an impact of 80 degrees, at the angle of this one.
  double grazing_steps() const {
    const ConfiguredLaw law(parameters(name_of_law(), SCREE_CONTACT_LAW, parameters_of_law()),
                            case_.dimension, nowhere, nowhere);
    for (const scree_closed_form& form : closed_forms(law, {reduced_mass(), effective_radius(), speed, 1}))
      if (std::string(form.name) == "grazing_steps")
        return form.value * std::pow(std::tan(case_.angle) / std::tan(80 * std::numbers::pi / 180), 0.8);
    return 0;
  }

  Vec3 normal() const { return vec(up()); }  // of the contact at first touch
  static Vec3 vec(const reference::Vector& v) { return {{v.x, v.y, v.z}}; }
  // Of the reference with painted points; four times as many change no motion by 1e-6 of the speed.
  static constexpr int painted_steps = 5000;
  static constexpr double speed = 1;       // (m/s) of a against the other
  static constexpr double radius = 0.005;  // (m) of a

 private:
  static constexpr double mass = 1.3e-3, poissons_ratio = 0.3;
  static constexpr double nowhere[3] = {};

  static double kinetic(const scree_energy& e) { return e.kinetic_translation + e.kinetic_rotation; }
  reference::Vector up() const {
    return case_.dimension == 2 ? reference::Vector{0, 1, 0} : reference::Vector{0, 0, 1};
  }
  std::vector<double> plane_normal() const {
    return case_.dimension == 2 ? std::vector<double>{0, 1, 0} : std::vector<double>{0, 0, 1};
  }
  double stiffness() const { return 1e5 * case_.rigidity; }
  double youngs_modulus() const { return 1e9 * case_.rigidity; }
  double reduced_mass() const { return case_.wall ? mass : mass * case_.mass_ratio / (1 + case_.mass_ratio); }
  double effective_radius() const {
    return case_.wall ? radius : radius * case_.size_ratio / (1 + case_.size_ratio);
  }

  // Both bodies at a time after first touch, in free flight; the total momentum of a pair is 0.
  std::vector<reference::Body> bodies_at(double time) const {
    const reference::Vector x = {1, 0, 0};
    const reference::Vector approach =
        speed * std::sin(case_.angle) * x - speed * std::cos(case_.angle) * up();
    const double share = case_.wall ? 1 : case_.mass_ratio / (1 + case_.mass_ratio);
    reference::Body a{case_.dimension, radius,           mass,
                      radius * up(),   share * approach, {case_.spin[0], case_.spin[1], case_.spin[2]}};
    a.position = a.position + time * a.velocity;
    if (case_.wall) return {a};
    reference::Body b{case_.dimension,         case_.size_ratio * radius,
                      case_.mass_ratio * mass, -case_.size_ratio * radius * up(),
                      (share - 1) * approach,  {}};
    b.position = b.position + time * b.velocity;
    return {a, b};
  }

  double tangential_stiffness() const { return case_.stiffness_ratio * stiffness(); }
  double tangential_damping() const {
    if (!case_.tangential_damping || case_.restitution == 1) return 0;
    const double decrement = -std::log(case_.restitution);
    return 2 * decrement / std::hypot(std::numbers::pi, decrement) *
           std::sqrt(tangential_stiffness() * reduced_mass());
  }

  reference::Law law() const {
    reference::Law law;
    law.kind = case_.hertz ? reference::LawKind::hertz : reference::LawKind::linear;
    law.tension = case_.tension;
    law.restitution = case_.restitution;
    law.friction = case_.friction;
    if (case_.dynamic_share < 1) law.dynamic_friction = case_.dynamic_share * case_.friction;
    law.normal_stiffness = stiffness();
    law.tangential_stiffness = tangential_stiffness();
    law.tangential_damping = tangential_damping();
    law.slip_rule = case_.slip_rule;
    law.youngs_modulus = youngs_modulus();
    law.poissons_ratio = poissons_ratio;
    law.history = case_.history;
    return law;
  }

  std::string name_of_law() const {
    if (case_.painted) return "sphere_path_independent";
    return case_.hertz ? "hertz_mindlin" : "linear_spring_dashpot";
  }

  Values parameters_of_law() const {
    const double cut = case_.tension == reference::Tension::cut;
    Values values = {{"restitution", {case_.restitution}}, {"tension", {cut}}};
    const auto add = [&](const char* key, double value) { values.push_back({key, {value}}); };
    if (case_.painted) add("normal", case_.hertz);
    if (case_.hertz) {
      add("youngs_modulus", youngs_modulus());
      add("poissons_ratio", poissons_ratio);
      add("friction", case_.friction);
      if (!case_.painted) add("history", double(case_.history));
      return values;
    }
    add("normal_stiffness", stiffness());
    add("tangential_stiffness", tangential_stiffness());
    add("tangential_damping", tangential_damping());
    add("static_friction", case_.friction);
    if (case_.dynamic_share < 1) add("dynamic_friction", case_.dynamic_share * case_.friction);
    if (!case_.painted) add("slip_rule", double(case_.slip_rule));
    return values;
  }

  ImpactCase case_;
};

}  // namespace scree::test
