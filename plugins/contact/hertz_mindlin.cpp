// Hertzian normal and Mindlin (no-slip) tangential springs with damping, Coulomb limit and rolling
// resistance, after Lemrich, Johnson, Guyer, Jia, Carmeliet, "Linear and nonlinear elastic properties of
// dense granular packings" (2017), [L1]-[L7], with the effective moduli of the code that they used.

#include "hertz_normal.hpp"

#include <scree/plugin/friction.hpp>
#include <scree/plugin/rolling.hpp>

namespace {

using scree::Contact;
using scree::LawOutput;
using scree::Vec;

enum HistoryForm { displacement, rescaled, potential };

struct HertzMindlin : scree::ContactLaw {
  normal::Hertz along_normal;
  double friction = 0;
  int history = rescaled;
  scree::RollingResistance rolling_resistance;

  static constexpr scree::About about = {
      "hertz_mindlin", "Hertz normal force, Mindlin tangential spring, friction, rolling resistance",
      "f_n = k_n δ − γ_n v_n          k_n = (4/3) E* √(R* δ),  γ_n = 2β √(5/3 m* E*) (R* δ)^(1/4)\n"
      "f_t = −P(k_t ξ + γ_t v_t)      k_t = 8 G* √(R* δ),      γ_t = 4β √(5/3 m* G*) (R* δ)^(1/4)\n"
      "                               P: limits the magnitude to C = μ max(f_n, 0)\n"
      "stick: |k_t ξ| <= C            slip: ξ shortened to |k_t ξ| = C; the dashpot never causes slip;\n"
      "       both only dissipate: friction k_t ξ·s >= 0 (s: slip velocity),\n"
      "       dashpot (P(k_t ξ + γ_t v) − k_t ξ)·v >= 0\n"
      "T = −μ_r k_n δ R* Δω/|Δω|      rolling; at most 0.4 m* R*² |Δω|/τ_r\n"
      "1/E* = Σ (1−ν²)/E,  1/G* = Σ 2(2−ν)(1+ν)/E   over both bodies;\n"
      "       equal materials: E* = E/(2(1−ν²)), G* = E/(4(2−ν)(1+ν))\n"
      "history: displacement (ξ kept: creates ½ ξ² dk_t while k_t grows, shown by the energy audit),\n"
      "         rescaled (f_t kept while k_t grows, at its mean over the step; ξ kept while k_t falls:\n"
      "         dissipates ½ ξ² |dk_t|),\n"
      "         potential (½ k_t(δ) ξ², with the extra normal force ½ k_t'(δ) ξ² that conserves energy; with μ from 100 on\n"
      "         and restitution 1 the spring is still stretched at parting, where this force grows as δ^(-1/2): the\n"
      "         energy of such impacts errs by some per cent at any usual step; with e < 1 it has a peak soon after\n"
      "         first touch, which impacts that graze resolve with `grazing_steps` only)",
      "Lemrich et al. 2017, equations 1 to 7"};

  void declare(scree::Declaration& d) {
    using namespace scree;
    constexpr Range poisson = normal::Hertz::poissons_range;
    d.number("youngs_modulus", along_normal.youngs_modulus, "Pa", positive, "E of the bodies").required();
    d.number("poissons_ratio", along_normal.poissons_ratio, "", poisson, "ν of the bodies").required();
    d.number("other_youngs_modulus", along_normal.other_youngs_modulus, "Pa", positive,
             "E of the second material, if different")
        .optional();
    d.number("other_poissons_ratio", along_normal.other_poissons_ratio, "", poisson,
             "ν of the second material, if different")
        .optional();
    d.number("restitution", along_normal.restitution, "", positive_coefficient,
             "e, independent of speed; β from e and tension");
    d.choice("tension", along_normal.tension, "allowed|cut",
             "whether the force may become attractive at the end of a contact; e is reached either way");
    d.number("friction", friction, "", non_negative, "μ; 0: frictionless, no tangential force");
    d.choice("history", history, "displacement|rescaled|potential",
             "quantity that the tangential spring keeps when k_t changes");
    rolling_resistance.declare(d);
  }

  void prepare(const scree::Setup&) { along_normal.prepare(); }

  double onset_power() const { return normal::Hertz::onset_power; }
  double parting_power() const { return along_normal.parting_power(); }

  std::uint32_t closed_forms(const scree_encounter& e, scree_closed_form* forms,
                             std::uint32_t capacity) const {
    return along_normal.closed_forms(e, friction, history == potential, forms, capacity);
  }
};

template <bool frictional, HistoryForm form, bool rolling>
struct Kernel : HertzMindlin {
  static bool suits(const HertzMindlin& p) {
    return (p.friction > 0) == frictional && (!frictional || p.history == form) &&
           (p.rolling_resistance.friction > 0) == rolling;
  }
  static constexpr std::uint32_t reads =
      scree::reads_normal | scree::reads_overlap | scree::reads_relative_velocity |
      scree::reads_onset_weight | scree::reads_contact_radius | scree::reads_reduced_mass_root |
      (frictional ? scree::reads_tangential_increment : 0u) |
      (rolling ? scree::reads_relative_spin | scree::reads_effective_radius : 0u) |
      (form == potential ? scree::reads_effective_radius : 0u);
  static constexpr bool tangential = frictional || rolling;
  static constexpr bool writes_couple = rolling;
  static constexpr bool follows_backwards = frictional;

  template <int D, class T>
  struct Friction {
    Vec<D, T> spring;         // ξ (m)
    T signed_contact_radius;  // ±√(R* δ) at the last update of ξ (m), above 0 while the contact slides
    static constexpr int sliding_column = D;
    static constexpr auto names = [] {
      std::array<const char*, D + 1> all = {"spring_x", "spring_y"};
      if constexpr (D == 3) all[2] = "spring_z";
      all[D] = "signed_contact_radius";
      return all;
    }();
    T contact_radius() const { return std::max(signed_contact_radius, -signed_contact_radius); }
  };
  template <int D, class T>
  using History = std::conditional_t<frictional, Friction<D, T>, scree::NoHistory<D, T>>;

  template <int D, class T>
  T stored_energy(const Friction<D, T>& h) const {
    return along_normal.tangential_energy(h.contact_radius(), dot(h.spring, h.spring));
  }

  template <int D, class T>
  void force(const Contact<D, T, reads>& c, History<D, T>& h, LawOutput<D, T, writes_couple>& out) const {
    const normal::Force<T> f_n = along_normal.force(c, out);
    if constexpr (!frictional) out.force = f_n.total * c.normal;
    if constexpr (frictional) slide_or_stick(c, f_n, h, out);
    if constexpr (rolling) scree::resist_rolling(c, f_n.spring, rolling_resistance, out);
  }

 private:
  // Mean of k_t over a step / k_t at its end, for k_t ∝ √δ with δ growing linearly, where g = `growth` is k_t
  // at the start / k_t at the end: (2/3)(1 + g + g²)/(1 + g), approximated to 0.01 at g = 0.4 and better
  // elsewhere; exact to second order at 0 and 1. Backwards in time, g > 1: exact to first order at 1.
  template <class T>
  static T mean_stiffness(const T& growth, bool backwards) {
    using scree::fused;
    if (backwards) return fused(T(0.5), growth, T(0.5));
    return fused(growth * growth, fused(T(-1.0 / 6), growth, T(0.5)), T(2.0 / 3));
  }

  template <int D, class T>
  void slide_or_stick(const Contact<D, T, reads>& c, const normal::Force<T>& f_n, Friction<D, T>& h,
                      LawOutput<D, T, writes_couple>& out) const {
    const T k_t = along_normal.tangential_stiffness(c.contact_radius.value);
    const Vec<D, T> v_t = tangential_part(c.relative_velocity, c.normal);
    const T inverse_k_t = T(along_normal.inverse_shear_stiffness) * c.contact_radius.inverse;
    const T gamma_t = normal::Hertz::damping_weight(c) * T(along_normal.tangential_damping);

    // While the contact grows, the rescaled form keeps the tangential force: ξ shrinks as k_t grows. A step
    // backwards in time undoes this where the contact had grown.
    T growth = T(1), mean = T(1);
    Vec<D, T> displaced = h.spring + c.tangential_increment;
    if constexpr (form == rescaled) {
      const T ratio = h.contact_radius() * c.contact_radius.inverse;
      growth = c.backwards ? std::max(ratio, T(1)) : std::min(ratio, T(1));
      mean = mean_stiffness(growth, c.backwards);
      displaced = fused(mean, c.tangential_increment, growth * h.spring);
    }
    const Vec<D, T> trial = tangential_part(displaced, c.normal);
    const T limit = T(friction) * f_n.repulsive;
    const scree::SlipStep<D, T> step = {.trial_spring = trial,
                                        .stiffness = k_t,
                                        .inverse_stiffness = inverse_k_t,
                                        .velocity = v_t,
                                        .delay = gamma_t * inverse_k_t,
                                        .step = c.step,
                                        .limit = limit,
                                        .sliding_limit = limit,
                                        .returns = c.backwards && h.signed_contact_radius > T(0)};
    const scree::Slip<D, T> slip = scree::slide_or_stick(step);
    const Friction<D, T> before = h;
    h.spring = slip.spring;
    h.signed_contact_radius = slip.slides ? c.contact_radius.value : -c.contact_radius.value;

    T normal_force = f_n.total;
    if constexpr (form == potential)
      normal_force += along_normal.force_of_potential(c, dot(h.spring, h.spring));
    out.force = fused(normal_force, c.normal, slip.force);
    out.elastic_tangential = stored_energy(h);
    out.dissipation_rate_tangential = -dot(fused(k_t, h.spring, slip.force), v_t);
    add_dissipation(before, h, trial, growth, mean, k_t, c.backwards, out);
  }

  // Energy that slip and changes of k_t take from the spring, such that the balance with the work of the mean
  // force before and after the step is exact. Terms that vanish with the step could become negative only
  // where a spring reverses within the step; they are set to 0 there.
  template <int D, class T>
  void add_dissipation(const Friction<D, T>& before, const Friction<D, T>& after, const Vec<D, T>& trial,
                       const T& growth, const T& mean, const T& k_t, bool backwards,
                       LawOutput<D, T, writes_couple>& out) const {
    const T k_before = along_normal.tangential_stiffness(before.contact_radius()), inverse_mean = T(1) / mean;
    const Vec<D, T> mean_force = T(0.5) * (k_before * before.spring + k_t * after.spring);
    const T slipped = dot(mean_force, trial - after.spring);  // (J) below 0 where slip is undone
    out.dissipated_friction = (backwards ? slipped : std::max(slipped, T(0))) * inverse_mean;
    if constexpr (form == potential) return;
    const T falls = k_before - growth * k_t;
    out.dissipated_release = T(0.5) * falls * std::max(dot(before.spring, after.spring), T(0));
    if constexpr (form == rescaled)
      out.dissipated_release += T(0.5) * k_t *
                                (dot(after.spring, after.spring) * (inverse_mean - T(1)) +
                                 dot(before.spring, before.spring) * growth * (T(1) - growth * inverse_mean));
  }
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(HertzMindlin, Kernel<false, displacement, false>, Kernel<true, displacement, false>,
                         Kernel<true, rescaled, false>, Kernel<true, potential, false>,
                         Kernel<false, displacement, true>, Kernel<true, displacement, true>,
                         Kernel<true, rescaled, true>, Kernel<true, potential, true>)
