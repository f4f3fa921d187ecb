// Linear spring and dashpot with a tangential spring, Coulomb friction and stick/slip history, after
// David, García-Rojo, Herrmann, Luding, "Hysteresis and creep in powders and grains" (2005), [D1]-[D4].

#include <cmath>
#include <numbers>

#include <scree/plugin/contact_law.hpp>
#include <scree/plugin/friction.hpp>
#include <scree/plugin/restitution.hpp>
#include <scree/plugin/rolling.hpp>
#include <scree/plugin/stability.hpp>

namespace {

using scree::Contact;
using scree::Response;
using scree::Vec;

constexpr double pi = std::numbers::pi;

enum class Friction { none, undamped, spring, total };  // undamped: both slip rules are the same

struct LinearSpringDashpot : scree::ContactLaw {
  double normal_stiffness = 0;
  double normal_damping = 0;
  double restitution = 0;  // 0: normal_damping was given
  int tension = 0;         // scree::Tension
  double tangential_stiffness = 0;
  double tangential_damping = 0;
  double static_friction = 0;
  double dynamic_friction = -1;  // below 0: same as static_friction
  int slip_rule = 0;             // 0: spring force, 1: total force
  scree::RollingResistance rolling_resistance;
  double damping_ratio = 0;
  double damping_by_root_mass = 0;          // γ/√m* = 2ζ √k
  double inverse_tangential_stiffness = 0;  // 1/k_t

  static constexpr scree::About about = {
      "linear_spring_dashpot",
      "linear spring and dashpot, tangential spring with static and dynamic friction",
      "f_n = k δ + γ δ'                                  normal force\n"
      "ξ <- ξ + v_t Δt (mid-step normal)                 displacement of the step\n"
      "ξ <- ξ − n (n·ξ)                                  projection onto the tangent plane\n"
      "f_t = −P(k_t ξ + γ_t v_t)                         P: limits the magnitude to C = μ max(f_n, 0)\n"
      "stick: |k_t ξ| <= C                               μ = μ_s while sticking, μ_d while sliding\n"
      "slip:  ξ shortened to |k_t ξ| = μ_d f_n           the dashpot never causes slip\n"
      "       both only dissipate: friction k_t ξ·s >= 0 (s: slip velocity),\n"
      "       dashpot (P(k_t ξ + γ_t v) − k_t ξ)·v >= 0 (P is monotone)\n"
      "slip_rule = total, as printed in [D3], [D4]: slip where |k_t ξ + γ_t v_t| > C,\n"
      "       then ξ = −(f_t + γ_t v_t)/k_t; may create energy where γ_t v_t changes during slip,\n"
      "       shown by the energy audit\n"
      "T = −μ_r k δ R* Δω/|Δω|  rolling; at most 0.4 m* R*² |Δω|/τ_r\n"
      "arms of the torque: R − δ/2 (angular momentum is conserved)",
      "David et al. 2005, equations 1 to 4"};

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.number("normal_stiffness", normal_stiffness, "N/m", positive, "k, stiffness of the normal spring")
        .required();
    d.number("normal_damping", normal_damping, "kg/s", non_negative, "γ, independent of mass")
        .or_else("restitution");
    d.number("restitution", restitution, "", positive_coefficient,
             "r, independent of mass: γ = 2ζ√(k m*), ζ from r and tension")
        .or_else("normal_damping");
    d.choice("tension", tension, "allowed|cut",
             "whether the force may become attractive at the end of a contact; r is reached either way");
    d.number("tangential_stiffness", tangential_stiffness, "N/m", non_negative,
             "k_t of the tangential spring");
    d.number("tangential_damping", tangential_damping, "kg/s", non_negative, "γ_t of the tangential dashpot");
    d.number("static_friction", static_friction, "", non_negative,
             "μ_s; 0: frictionless, no tangential force");
    d.number("dynamic_friction", dynamic_friction, "", non_negative, "μ_d <= μ_s; μ_s if absent").optional();
    d.choice("slip_rule", slip_rule, "spring|total",
             "force compared with the limit: that of the spring, or the total as in David et al.");
    rolling_resistance.declare(d);
  }

  void prepare(const scree::Setup& setup) {
    if (dynamic_friction < 0) dynamic_friction = static_friction;
    if (dynamic_friction > static_friction)
      return setup.refuse("dynamic_friction is above static_friction; give at most the static value");
    if (static_friction > 0 && tangential_stiffness <= 0)
      return setup.refuse("friction needs tangential_stiffness above 0; give it, or static_friction = 0");
    // Its reciprocal, and the square of the time γ_t/k_t, must be finite in single precision too.
    if (static_friction > 0 && !(tangential_stiffness > 1e-15 * std::max(1.0, tangential_damping)))
      return setup.refuse(
          "tangential_stiffness is too small for the number format; "
          "give at least 1e-15 N/m and at least 1e-15/s times tangential_damping");
    if (restitution > 0) damping_ratio = scree::damping_ratio_of(restitution, scree::Tension(tension));
    damping_by_root_mass = 2 * damping_ratio * std::sqrt(normal_stiffness);
    if (tangential_stiffness > 0) inverse_tangential_stiffness = 1 / tangential_stiffness;
  }

  Friction friction_model() const {
    if (!(static_friction > 0)) return Friction::none;
    if (tangential_damping == 0) return Friction::undamped;
    return slip_rule == 0 ? Friction::spring : Friction::total;
  }

  // The dashpot force jumps at first touch (onset_power 0). At the end it jumps or, with cut tension, the
  // force is already 0.
  double parting_power() const { return scree::Tension(tension) == scree::Tension::cut ? continuous : 0; }

  std::uint32_t closed_forms(const scree_encounter& e, scree_closed_form* forms,
                             std::uint32_t capacity) const {
    const double m = e.reduced_mass, k = normal_stiffness, omega_0 = std::sqrt(k / m);
    const double zeta = restitution > 0 ? damping_ratio : normal_damping / (2 * std::sqrt(k * m));
    const double r = scree::restitution_of(zeta, scree::Tension(tension));
    // t_c = −ln r / η holds in both conventions: the motion decays as exp(−ηt) until the contact ends.
    const double contact_time =
        zeta > 0 && r < 1 ? (r > 0 ? -std::log(r) / (zeta * omega_0) : scree::infinity) : pi / omega_0;
    const double inverse_mass = static_friction > 0 ? scree::tangential_inverse_mass / m : 0;
    const double critical_step = scree::critical_step(
        {k / m, 2 * zeta * omega_0}, {inverse_mass * tangential_stiffness, inverse_mass * tangential_damping},
        e.network);
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
};

template <Friction friction, bool rolling, bool by_restitution>
struct Kernel : LinearSpringDashpot {
  static bool suits(const LinearSpringDashpot& p) {
    return p.friction_model() == friction && (p.rolling_resistance.friction > 0) == rolling &&
           (p.restitution > 0) == by_restitution;
  }
  static constexpr bool frictional = friction != Friction::none;
  static constexpr std::uint32_t reads =
      scree::reads_normal | scree::reads_overlap | scree::reads_relative_velocity |
      scree::reads_onset_weight | (frictional ? scree::reads_tangential_increment : 0u) |
      (by_restitution ? scree::reads_reduced_mass_root : 0u) |
      (rolling ? scree::reads_relative_spin | scree::reads_reduced_mass_root | scree::reads_effective_radius
               : 0u);
  static constexpr bool tangential = frictional || rolling;
  static constexpr bool writes_couple = rolling;

  template <int D, class T>
  struct Spring {
    Vec<D, T> spring;  // ξ (m)
    T sliding;         // 1 while the contact slides
    static constexpr int sliding_column = D;
    static constexpr auto names = [] {
      std::array<const char*, D + 1> all = {"spring_x", "spring_y"};
      if constexpr (D == 3) all[2] = "spring_z";
      all[D] = "sliding";
      return all;
    }();
  };
  template <int D, class T>
  using History = std::conditional_t<frictional, Spring<D, T>, scree::NoHistory<D, T>>;

  template <int D, class T>
  T stored_energy(const Spring<D, T>& h) const {
    return T(0.5 * tangential_stiffness) * dot(h.spring, h.spring);
  }

  template <int D, class T>
  void force(const Contact<D, T, reads>& c, History<D, T>& h, Response<D, T, writes_couple>& out) const {
    const T v_n = dot(c.relative_velocity, c.normal);
    T gamma = T(normal_damping), predicted = T(1);
    if constexpr (by_restitution) {
      gamma = T(damping_by_root_mass) * c.reduced_mass_root;
      predicted = scree::prediction_share(T(0.5) * c.step * c.step, T(normal_stiffness), c.reduced_mass_root);
    }

    // [D1], δ' = −v_n
    const T spring_force = T(normal_stiffness) * c.overlap, damping_force = predicted * gamma * v_n;
    const T total = scree::fused(-c.onset_weight, damping_force, spring_force);
    const T repulsive = std::max(total, T(0));
    const T f_n = scree::Tension(tension) == scree::Tension::cut ? repulsive : total;
    out.elastic_normal = T(0.5) * spring_force * c.overlap;
    out.dissipation_rate_normal = (spring_force - f_n) * v_n;
    if constexpr (friction == Friction::undamped || friction == Friction::spring)
      slide_or_stick(c, repulsive, h, out);
    if constexpr (friction == Friction::total)
      slide_or_stick_by_total(c, repulsive, std::max(spring_force - damping_force, T(0)), h, out);
    if constexpr (frictional)
      out.force = fused(f_n, c.normal, out.force);
    else
      out.force = f_n * c.normal;
    if constexpr (rolling) scree::resist_rolling(c, spring_force, rolling_resistance, out);
  }

 private:
  // The old spring plus the displacement of this step, projected onto the present tangent plane.
  template <int D, class T>
  static Vec<D, T> trial_spring(const Contact<D, T, reads>& c, const Spring<D, T>& h) {
    return tangential_part(h.spring + c.tangential_increment, c.normal);
  }

  template <int D, class T>
  scree::SlipStep<D, T> step_of(const Contact<D, T, reads>& c, const Spring<D, T>& h, const Vec<D, T>& trial,
                                const Vec<D, T>& v_t, const T& f_n, const T& weight) const {
    const T sliding_limit = T(dynamic_friction) * f_n;
    return {.trial_spring = trial,
            .stiffness = T(tangential_stiffness),
            .inverse_stiffness = T(inverse_tangential_stiffness),
            .velocity = v_t,
            .delay = weight * T(tangential_damping * inverse_tangential_stiffness),
            .step = c.step,
            .limit = h.sliding > T(0) ? sliding_limit : T(static_friction) * f_n,
            .sliding_limit = sliding_limit};
  }

  // Stores spring and force. Returns the mean of the spring forces before and after the step.
  template <int D, class T>
  Vec<D, T> store(const scree::Slip<D, T>& slip, Spring<D, T>& h, Response<D, T, writes_couple>& out) const {
    const Vec<D, T> mean_force = T(0.5 * tangential_stiffness) * (h.spring + slip.spring);
    h.spring = slip.spring;
    h.sliding = slip.slides ? T(1) : T(0);
    out.force = slip.force;
    out.elastic_tangential = stored_energy(h);
    return mean_force;
  }

  template <int D, class T>
  void slide_or_stick(const Contact<D, T, reads>& c, const T& f_n, Spring<D, T>& h,
                      Response<D, T, writes_couple>& out) const {
    const Vec<D, T> v_t = tangential_part(c.relative_velocity, c.normal), trial = trial_spring(c, h);
    constexpr bool damped = friction != Friction::undamped;
    const scree::Slip<D, T> slip =
        scree::slide_or_stick<damped>(step_of(c, h, trial, v_t, f_n, c.onset_weight));
    const Vec<D, T> mean_force = store(slip, h, out);
    if constexpr (damped)
      out.dissipation_rate_tangential = -dot(fused(T(tangential_stiffness), h.spring, slip.force), v_t);
    out.dissipated_friction = std::max(dot(mean_force, trial - h.spring), T(0));
  }

  template <int D, class T>
  void slide_or_stick_by_total(const Contact<D, T, reads>& c, const T& f_n, const T& unweighted_f_n,
                               Spring<D, T>& h, Response<D, T, writes_couple>& out) const {
    const Vec<D, T> v_t = tangential_part(c.relative_velocity, c.normal), trial = trial_spring(c, h);
    const T weighted_sliding_limit = T(dynamic_friction) * f_n;
    const T weighted_limit = h.sliding > T(0) ? weighted_sliding_limit : T(static_friction) * f_n;
    const scree::Slip<D, T> slip =
        scree::slide_or_stick_by_total(step_of(c, h, trial, v_t, unweighted_f_n, T(1)), c.onset_weight,
                                       weighted_limit, weighted_sliding_limit);
    const Vec<D, T> mean_force = store(slip, h, out), slipped = trial - h.spring;
    const T dashpot_power = -dot(fused(T(tangential_stiffness), h.spring, slip.force), v_t);
    // During slip the dashpot changes the energy of the spring, by γ_t v_t·ξ' of either sign.
    out.dissipation_rate_tangential = slip.slides ? T(0) : dashpot_power;
    out.dissipated_friction = slip.slides ? -dot(slip.force, slipped) : T(0);
    out.dissipated_release =
        slip.slides ? dot(mean_force + slip.force, slipped) + c.step * dashpot_power : T(0);
  }
};

using enum Friction;

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(LinearSpringDashpot, Kernel<none, false, false>, Kernel<none, false, true>,
                         Kernel<none, true, false>, Kernel<none, true, true>, Kernel<undamped, false, false>,
                         Kernel<undamped, false, true>, Kernel<undamped, true, false>,
                         Kernel<undamped, true, true>, Kernel<spring, false, false>,
                         Kernel<spring, false, true>, Kernel<spring, true, false>, Kernel<spring, true, true>,
                         Kernel<total, false, false>, Kernel<total, false, true>, Kernel<total, true, false>,
                         Kernel<total, true, true>)
