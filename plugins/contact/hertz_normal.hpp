// Hertzian normal force with its dashpot, and stiffness and damping of the tangential spring after Mindlin,
// from the moduli of two bodies: Lemrich, Johnson, Guyer, Jia, Carmeliet (2017), [L2]-[L5], and the closed
// forms of the law.

#pragma once

#include "normal_force.hpp"

#include <cmath>
#include <numbers>

#include <scree/plugin/contact_law.hpp>
#include <scree/plugin/stability.hpp>

namespace normal {

struct Hertz {
  double youngs_modulus = 0, poissons_ratio = 0;               // E (Pa), ν
  double other_youngs_modulus = 0, other_poissons_ratio = -1;  // of the second material, if different
  double restitution = 1;                                      // e
  int tension = 0;                                             // scree::Tension
  double effective_modulus = 0;                                // E*
  double effective_shear_modulus = 0;                          // G*
  double damping_ratio = 0;                                    // β
  double damping = 0, tangential_damping = 0;                  // 2β √(5/3 E*), 4β √(5/3 G*)
  double inverse_shear_stiffness = 0;                          // 1/(8 G*)

  static constexpr double tan_80 = 5.671281819617709;
  static constexpr scree::Range poissons_range{.minimum = -1, .maximum = 0.5, .minimum_excluded = true};

  void prepare() {
    const double e2 = other_youngs_modulus > 0 ? other_youngs_modulus : youngs_modulus;
    const double nu = poissons_ratio, nu2 = other_poissons_ratio > -1 ? other_poissons_ratio : nu;
    effective_modulus = 1 / ((1 - nu * nu) / youngs_modulus + (1 - nu2 * nu2) / e2);
    effective_shear_modulus = 1 / (2 * (2 - nu) * (1 + nu) / youngs_modulus + 2 * (2 - nu2) * (1 + nu2) / e2);
    damping_ratio = scree::damping_ratio_of(restitution, scree::Tension(tension));
    damping = 2 * damping_ratio * std::sqrt(5.0 / 3.0 * effective_modulus);
    tangential_damping = 4 * damping_ratio * std::sqrt(5.0 / 3.0 * effective_shear_modulus);
    inverse_shear_stiffness = 1 / (8 * effective_shear_modulus);
  }

  // The dashpot force begins as δ^(1/4). At the end it falls likewise or, with cut tension, the force is
  // already 0.
  static constexpr double onset_power = 0.25;
  double parting_power() const {
    return scree::Tension(tension) == scree::Tension::cut ? scree::ContactLaw::continuous : 0.25;
  }

  // potential: whether the tangential spring has a potential, ½ k_t(δ) ξ².
  std::uint32_t closed_forms(const scree_encounter& e, double friction, bool potential,
                             scree_closed_form* forms, std::uint32_t capacity) const {
    const bool frictional = friction > 0;
    const double stiffness = 4.0 / 3.0 * effective_modulus * std::sqrt(e.effective_radius);
    const double max_overlap = std::pow(5 * e.reduced_mass * e.speed * e.speed / (4 * stiffness), 0.4);
    const double contact_time =
        2.8682656992 * std::pow(e.reduced_mass * e.reduced_mass /
                                    (e.effective_radius * effective_modulus * effective_modulus * e.speed),
                                0.2);
    const scree_closed_form all[] = {
        {"contact_time", "s", "t_c = 2.8682656992 (m*²/(R* E*² v))^(1/5), undamped", contact_time},
        {"restitution", "", "e, independent of speed", restitution},
        {"critical_step", "s", "longest stable step of velocity Verlet for this pair at δ_max",
         critical_step(e, max_overlap, frictional)},
        {"rayleigh_time", "s", "π R √(ρ/G)/(0.1631 ν + 0.8766), of equal bodies", rayleigh_time(e)},
        {"damping_ratio", "", "β", damping_ratio},
        {"max_overlap", "m", "δ_max = (5 m* v²/(4 k))^(2/5), k = (4/3) E* √R*, undamped", max_overlap},
        {"max_force", "N", "k δ_max^(3/2)", stiffness * max_overlap * std::sqrt(max_overlap)},
        {"grazing_steps", "1",
         "4 (tan α/(0.0865 (E*/G*) μ β))^(4/5), steps in t_c that resolve the extra normal force of the potential in\n"
         "                        impacts at α = 80° from the normal; 0 where it contributes below 1e-3",
         grazing_steps(friction, tan_80)}};
    const std::size_t stated = std::size(all) - (frictional && potential && damping_ratio > 0 ? 0 : 1);
    std::uint32_t n = 0;
    for (; n < std::min<std::size_t>(capacity, stated); ++n) forms[n] = all[n];
    return n;
  }

  // History potential, damped: k_t ξ reaches μ f_n soon after first touch, at t_s, before which the spring
  // grows as t and after which the limit, of the dashpot, grows as δ^(1/4):
  //   k_t v_t t_s = μ γ_n v_n  at  δ = v_n t_s:  (t_s/t_c)^(5/4) = 0.0865 (E*/G*) μ β/tan α,  tan α = v_t/v_n
  // The extra normal force has a peak there and then falls as 1/t. Its share of the normal impulse is about
  // (5/24) (E*/G*) (μ β)². Four steps in t_s resolve it. 0: the share is below 1e-3.
  double grazing_steps(double friction, double tangent) const {
    const double moduli = effective_modulus / effective_shear_modulus, limit = friction * damping_ratio;
    if (!(5.0 / 24 * moduli * limit * limit > 1e-3)) return 0;
    return 4 * std::pow(tangent / (0.0865 * moduli * limit), 0.8);
  }

  // Factor of both dashpots, (m*)^½ (R* δ)^¼ with the onset weight.
  template <int D, class T, std::uint32_t reads>
  static T damping_weight(const scree::Contact<D, T, reads>& c) {
    return c.onset_weight * c.reduced_mass_root * c.contact_radius_root;
  }

  // Sets the energies of the normal direction.
  template <int D, class T, std::uint32_t reads, bool couple>
  Force<T> force(const scree::Contact<D, T, reads>& c, scree::LawOutput<D, T, couple>& out) const {
    const T v_n = dot(c.relative_velocity, c.normal);
    const T spring = T(4.0 / 3.0 * effective_modulus) * c.contact_radius.value * c.overlap;
    const T stiffness = T(2 * effective_modulus) * c.contact_radius.value;  // of the normal spring
    const T gamma = damping_weight(c) * T(damping) *
                    scree::prediction_share(T(0.5) * c.step * c.step, stiffness, c.reduced_mass_root);
    out.elastic_normal = T(0.4) * spring * c.overlap;
    return with_tension(scree::Tension(tension), spring, scree::fused(-gamma, v_n, spring), v_n, out);
  }

  // k_t = 8 G* a (N/m), a: contact radius (m).
  template <class T>
  T tangential_stiffness(const T& contact_radius) const {
    return T(8 * effective_shear_modulus) * contact_radius;
  }
  // ½ k_t ξ² (J), ξ² = `square` (m²).
  template <class T>
  T tangential_energy(const T& contact_radius, const T& square) const {
    return T(4 * effective_shear_modulus) * contact_radius * square;
  }
  // −∂/∂(distance) of ½ k_t(δ) ξ² (N), k_t' = k_t/(2δ) = 4 G* R*/a.
  template <int D, class T, std::uint32_t reads>
  T force_of_potential(const scree::Contact<D, T, reads>& c, const T& square) const {
    return T(2 * effective_shear_modulus) * c.effective_radius * c.contact_radius.inverse * square;
  }

 private:
  // Longest stable step (s) with the stiffnesses dF/dδ = 2 E* a and k_t = 8 G* a, a = √(R* δ), and their
  // dashpots.
  double critical_step(const scree_encounter& e, double overlap, bool frictional) const {
    const double a = std::sqrt(e.effective_radius * overlap), m = e.reduced_mass;
    const double beta = damping_ratio * std::sqrt(5.0 / 3.0 * a / m);
    const double inverse_mass = frictional ? scree::tangential_inverse_mass : 0;
    return scree::critical_step({2 * effective_modulus * a / m, 2 * beta * std::sqrt(effective_modulus)},
                                {inverse_mass * 8 * effective_shear_modulus * a / m,
                                 inverse_mass * 4 * beta * std::sqrt(effective_shear_modulus)},
                                e.network);
  }

  double rayleigh_time(const scree_encounter& e) const {
    constexpr double pi = std::numbers::pi;
    const double radius = 2 * e.effective_radius, mass = 2 * e.reduced_mass;
    const double density = mass / (4.0 / 3.0 * pi * radius * radius * radius);
    const double shear_modulus = youngs_modulus / (2 * (1 + poissons_ratio));
    return pi * radius * std::sqrt(density / shear_modulus) / (0.1631 * poissons_ratio + 0.8766);
  }
};

}  // namespace normal
