// Linear spring and dashpot along the normal, after David, García-Rojo, Herrmann, Luding (2005), [D1], and
// the closed forms of the law.

#pragma once

#include "normal_force.hpp"

#include <cmath>
#include <numbers>

#include <scree/plugin/contact_law.hpp>
#include <scree/plugin/first_slip.hpp>
#include <scree/plugin/stability.hpp>

namespace normal {

struct Linear {
  double stiffness = 0;             // k (N/m)
  double damping = 0;               // γ (kg/s)
  double restitution = 0;           // r; 0: the damping was given
  int tension = 0;                  // scree::Tension
  double damping_ratio = 0;         // ζ
  double damping_by_root_mass = 0;  // γ/√m* = 2ζ √k

  void prepare() {
    if (restitution > 0) damping_ratio = scree::damping_ratio_of(restitution, scree::Tension(tension));
    damping_by_root_mass = 2 * damping_ratio * std::sqrt(stiffness);
  }

  // The dashpot force jumps at first touch (onset_power 0). At the end it jumps or, with cut tension, the
  // force is already 0.
  double parting_power() const {
    return scree::Tension(tension) == scree::Tension::cut ? scree::ContactLaw::continuous : 0;
  }

  // tangential: k_t (N/m) and γ_t (kg/s), 0 without friction.
  std::uint32_t closed_forms(const scree_encounter& e, const scree::Stiffness& tangential,
                             scree_closed_form* forms, std::uint32_t capacity) const {
    const double m = e.reduced_mass, k = stiffness, omega_0 = std::sqrt(k / m);
    const double zeta = restitution > 0 ? damping_ratio : damping / (2 * std::sqrt(k * m));
    const double r = scree::restitution_of(zeta, scree::Tension(tension));
    // t_c = −ln r / η holds in both conventions: the motion decays as exp(−ηt) until the contact ends.
    const double contact_time = zeta > 0 && r < 1
                                    ? (r > 0 ? -std::log(r) / (zeta * omega_0) : scree::infinity)
                                    : std::numbers::pi / omega_0;
    const double inverse_mass = scree::tangential_inverse_mass / m;
    const double critical_step = scree::critical_step(
        {k / m, 2 * zeta * omega_0},
        {inverse_mass * tangential.over_mass, inverse_mass * tangential.damping_over_mass}, e.network);
    const scree_closed_form all[] = {
        {"contact_time", "s", "t_c = π/ω, ω² = k/m* − η², η = γ/2m* (tension cut: until f_n = 0)",
         contact_time},
        {"restitution", "", "r = exp(−η t_c)", r},
        {"critical_step", "s",
         "2/(√(k/m* + (γ/m*)²) + γ/m*), longest stable step of velocity Verlet for this pair;\n"
         "                        with 7/2 k_t, 7/2 γ_t if that is shorter",
         critical_step},
        {"damping_ratio", "", "ζ = γ/(2√(k m*))", zeta}};
    std::uint32_t n = 0;
    for (; n < std::min<std::size_t>(capacity, std::size(all)); ++n) forms[n] = all[n];
    return n;
  }

  // Without onset weight (kg/s). by_restitution: whether the damping follows from the restitution.
  template <bool by_restitution, int D, class T, std::uint32_t reads>
  T damping_coefficient(const scree::Contact<D, T, reads>& c) const {
    if constexpr (by_restitution) {
      const T gamma = T(damping_by_root_mass) * c.reduced_mass_root;
      return scree::prediction_share(T(0.5) * c.step * c.step, T(stiffness), c.reduced_mass_root) * gamma;
    } else {
      return T(damping);
    }
  }
  template <bool by_restitution, int D, class T, std::uint32_t reads>
  T damping_force(const scree::Contact<D, T, reads>& c) const {
    return damping_coefficient<by_restitution>(c) * dot(c.relative_velocity, c.normal);
  }

  // A sliding step under the limit μ f_n, with what that does after first touch; coefficient: see above.
  template <int D, class T, std::uint32_t reads>
  scree::FirstSlip<D, T> first_slip(const scree::Contact<D, T, reads>& c, const scree::SlipStep<D, T>& step,
                                    const T& coefficient, const T& friction, const scree::Vec<D, T>& before,
                                    const T& sliding) const {
    const T v_n = dot(c.relative_velocity, c.normal), travel = -c.step * v_n;
    const T pressing = std::max(scree::fused(-coefficient, v_n, T(stiffness) * c.overlap), T(0));
    const T lost = pressing * c.step / (c.reduced_mass_root * c.reduced_mass_root);  // speed in a step (m/s)
    const bool slides = sliding > T(0),
               weighs_one = c.onset_weight == T(1);  // with || loops do not vectorise
    return {.step = step,
            .limit = friction * pressing,
            .jump = -friction * coefficient * v_n,
            .growth = friction * T(stiffness) * travel,
            .slowing = friction * coefficient * lost,
            .touching = c.overlap / std::max(travel, scree::smallest_divisor<T>),
            .before = before,
            .slid = bool(slides | weighs_one),
            .moving = c.kick > T(0)};
  }

  // Sets the energies of the normal direction. [D1], δ' = −v_n
  template <bool by_restitution, int D, class T, std::uint32_t reads, bool couple>
  Force<T> force(const scree::Contact<D, T, reads>& c, scree::LawOutput<D, T, couple>& out) const {
    const T spring = T(stiffness) * c.overlap;
    const T total = scree::fused(-c.onset_weight, damping_force<by_restitution>(c), spring);
    out.elastic_normal = T(0.5) * spring * c.overlap;
    return with_tension(scree::Tension(tension), spring, total, dot(c.relative_velocity, c.normal), out);
  }
};

}  // namespace normal
