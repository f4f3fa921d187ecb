// Linear spring and dashpot with a tangential spring, Coulomb friction and stick/slip history, after
// David, García-Rojo, Herrmann, Luding, "Hysteresis and creep in powders and grains" (2005), [D1]-[D4].

#include "linear_normal.hpp"
#include "linear_tangential.hpp"

#include <scree/plugin/falling_limit.hpp>
#include <scree/plugin/rolling.hpp>

namespace {

using scree::Contact;
using scree::LawOutput;
using scree::Vec;

enum class Friction { none, undamped, spring, total };  // undamped: both slip rules are the same

struct LinearSpringDashpot : scree::ContactLaw {
  normal::Linear along_normal;
  tangential::Linear tangent;
  int slip_rule = 0;  // 0: spring force, 1: total force
  scree::RollingResistance rolling_resistance;

  static constexpr scree::About about = {
      "linear_spring_dashpot",
      "linear spring and dashpot, tangential spring with static and dynamic friction",
      "f_n = k δ + γ δ'                                  normal force\n"
      "ξ <- ξ + v_t Δt (mid-step normal)                 displacement of the step\n"
      "ξ <- ξ − n (n·ξ)                                  projection onto the tangent plane\n"
      "f_t = −P(k_t ξ + γ_t v_t)                         P: limits the magnitude to C = μ max(f_n, 0)\n"
      "stick: |k_t ξ| <= C                               μ = μ_s while sticking, μ_d while sliding\n"
      "slip:  ξ shortened to |k_t ξ| = μ_d f_n           the dashpot never causes slip\n"
      "       μ_d < μ_s: the jump of f_t as slip begins or ends is located within the step; so that the impulse is that\n"
      "       of the jump, f_t of this one step may leave the range from μ_d f_n to μ_s f_n, by half the jump or less\n"
      "       where slip begins, by the jump or less where it ends\n"
      "       both only dissipate: friction k_t ξ·s >= 0 (s: slip velocity),\n"
      "       dashpot (P(k_t ξ + γ_t v) − k_t ξ)·v >= 0 (P is monotone)\n"
      "slip_rule = total, as printed in [D3], [D4]: slip where |k_t ξ + γ_t v_t| > C,\n"
      "       then ξ = −(f_t + γ_t v_t)/k_t; may create energy where γ_t v_t changes during slip,\n"
      "       shown by the energy audit; with μ_d < μ_s jumps are at ends of steps, an error of first order\n"
      "T = −μ_r k δ R* Δω/|Δω|  rolling; at most 0.4 m* R*² |Δω|/τ_r\n"
      "arms of the torque: R − δ/2 (angular momentum is conserved)",
      "David et al. 2005, equations 1 to 4"};

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.number("normal_stiffness", along_normal.stiffness, "N/m", positive, "k, stiffness of the normal spring")
        .required();
    d.number("normal_damping", along_normal.damping, "kg/s", non_negative, "γ, independent of mass")
        .or_else("restitution");
    d.number("restitution", along_normal.restitution, "", positive_coefficient,
             "r, independent of mass: γ = 2ζ√(k m*), ζ from r and tension")
        .or_else("normal_damping");
    d.choice("tension", along_normal.tension, "allowed|cut",
             "whether the force may become attractive at the end of a contact; r is reached either way");
    d.number("tangential_stiffness", tangent.stiffness, "N/m", non_negative, "k_t of the tangential spring");
    d.number("tangential_damping", tangent.damping, "kg/s", non_negative, "γ_t of the tangential dashpot");
    d.number("static_friction", tangent.static_friction, "", non_negative,
             "μ_s; 0: frictionless, no tangential force");
    d.number("dynamic_friction", tangent.dynamic_friction, "", non_negative, "μ_d <= μ_s; μ_s if not given")
        .optional();
    d.choice("slip_rule", slip_rule, "spring|total",
             "force compared with the limit: that of the spring, or the total as in David et al.");
    rolling_resistance.declare(d);
  }

  void prepare(const scree::Setup& setup) {
    if (const char* fault = tangent.prepare()) return setup.refuse(fault);
    along_normal.prepare();
  }

  Friction friction_model() const {
    if (!(tangent.static_friction > 0)) return Friction::none;
    if (tangent.damping == 0) return Friction::undamped;
    return slip_rule == 0 ? Friction::spring : Friction::total;
  }

  // Whether friction falls as slip begins, at a moment within the step. As printed, [D4] falls at the end of
  // it.
  bool limit_falls() const {
    const Friction model = friction_model();
    return (model == Friction::undamped || model == Friction::spring) && tangent.limit_falls();
  }

  double parting_power() const { return along_normal.parting_power(); }

  std::uint32_t closed_forms(const scree_encounter& e, scree_closed_form* forms,
                             std::uint32_t capacity) const {
    return along_normal.closed_forms(e, tangent.acting(), forms, capacity);
  }
};

// falls: μ_d < μ_s, by the spring.
template <Friction friction, bool falls, bool rolling, bool by_restitution>
struct Kernel : LinearSpringDashpot {
  static bool suits(const LinearSpringDashpot& p) {
    return p.friction_model() == friction && p.limit_falls() == falls &&
           (p.rolling_resistance.friction > 0) == rolling &&
           (p.along_normal.restitution > 0) == by_restitution;
  }
  static constexpr bool frictional = friction != Friction::none;
  static constexpr std::uint32_t reads =
      scree::reads_normal | scree::reads_overlap | scree::reads_relative_velocity |
      scree::reads_onset_weight | (frictional ? scree::reads_tangential_increment : 0u) |
      (by_restitution || friction == Friction::undamped ? scree::reads_reduced_mass_root : 0u) |
      (rolling ? scree::reads_relative_spin | scree::reads_reduced_mass_root | scree::reads_effective_radius
               : 0u);
  static constexpr bool tangential = frictional || rolling;
  static constexpr bool writes_couple = rolling;
  static constexpr bool follows_onset = friction == Friction::undamped && !falls;
  static constexpr bool follows_backwards = frictional && friction != Friction::total;

  template <int D, class T>
  struct Spring {
    Vec<D, T> spring;  // ξ (m)
    T sliding;         // 1 while the contact slides; falls: state of FallingSlip (m), above 0 while it slides
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
    return T(0.5 * tangent.stiffness) * dot(h.spring, h.spring);
  }

  template <int D, class T>
  void force(const Contact<D, T, reads>& c, History<D, T>& h, LawOutput<D, T, writes_couple>& out) const {
    const normal::Force<T> f_n = along_normal.template force<by_restitution>(c, out);
    if constexpr (friction == Friction::undamped || friction == Friction::spring)
      slide_or_stick(c, f_n.repulsive, h, out);
    if constexpr (friction == Friction::total) {
      const T unweighted = f_n.spring - along_normal.template damping_force<by_restitution>(c);
      slide_or_stick_by_total(c, f_n.repulsive, std::max(unweighted, T(0)), h, out);
    }
    if constexpr (frictional)
      out.force = fused(f_n.total, c.normal, out.force);
    else
      out.force = f_n.total * c.normal;
    if constexpr (rolling) scree::resist_rolling(c, f_n.spring, rolling_resistance, out);
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
    const T sliding_limit = T(tangent.dynamic_friction) * f_n;
    return {.trial_spring = trial,
            .stiffness = T(tangent.stiffness),
            .inverse_stiffness = T(tangent.inverse_stiffness),
            .velocity = v_t,
            .delay = weight * T(tangent.damping * tangent.inverse_stiffness),
            .step = c.step,
            .limit = h.sliding > T(0) ? sliding_limit : T(tangent.static_friction) * f_n,
            .sliding_limit = sliding_limit,
            .returns = c.backwards && h.sliding > T(0)};
  }

  // Stores spring and force. Returns the mean of the spring forces before and after the step.
  template <int D, class T>
  Vec<D, T> store(const scree::Slip<D, T>& slip, Spring<D, T>& h, LawOutput<D, T, writes_couple>& out) const {
    const Vec<D, T> mean_force = T(0.5 * tangent.stiffness) * (h.spring + slip.spring);
    h.spring = slip.spring;
    h.sliding = slip.slides ? T(1) : T(0);
    out.force = slip.force;
    out.elastic_tangential = stored_energy(h);
    return mean_force;
  }

  template <int D, class T>
  void slide_or_stick(const Contact<D, T, reads>& c, const T& f_n, Spring<D, T>& h,
                      LawOutput<D, T, writes_couple>& out) const {
    const Vec<D, T> v_t = tangential_part(c.relative_velocity, c.normal), trial = trial_spring(c, h);
    constexpr bool damped = friction != Friction::undamped;
    const scree::SlipStep<D, T> step = step_of(c, h, trial, v_t, f_n, c.onset_weight);
    scree::FallingSlip<D, T> result;
    if constexpr (falls)
      result =
          scree::slide_or_stick<damped>(tangent.falling(step, f_n, c.normal, h.spring, h.sliding, c.kick));
    else
      result.slip = scree::slide_or_stick<damped>(step);
    if constexpr (follows_onset) {
      if (c.onset)
        result = scree::slide_or_stick<false>(
            along_normal.first_slip(c, step, along_normal.template damping_coefficient<by_restitution>(c),
                                    T(tangent.static_friction), h.spring, h.sliding));
    }
    const Vec<D, T> mean_force = store(result.slip, h, out);
    if constexpr (damped)
      out.dissipation_rate_tangential = -dot(fused(T(tangent.stiffness), h.spring, result.slip.force), v_t);
    T friction_work = dot(mean_force, trial - h.spring);
    if (falls || (follows_onset && c.onset)) {
      h.sliding = result.state;
      out.force += result.begun;
      friction_work -= c.kick * dot(result.begun, v_t);
    }
    out.dissipated_friction = c.backwards ? friction_work : std::max(friction_work, T(0));
  }

  template <int D, class T>
  void slide_or_stick_by_total(const Contact<D, T, reads>& c, const T& f_n, const T& unweighted_f_n,
                               Spring<D, T>& h, LawOutput<D, T, writes_couple>& out) const {
    const Vec<D, T> v_t = tangential_part(c.relative_velocity, c.normal), trial = trial_spring(c, h);
    const T weighted_sliding_limit = T(tangent.dynamic_friction) * f_n;
    const T weighted_limit = h.sliding > T(0) ? weighted_sliding_limit : T(tangent.static_friction) * f_n;
    const scree::Slip<D, T> slip =
        scree::slide_or_stick_by_total(step_of(c, h, trial, v_t, unweighted_f_n, T(1)), c.onset_weight,
                                       weighted_limit, weighted_sliding_limit);
    const Vec<D, T> mean_force = store(slip, h, out), slipped = trial - h.spring;
    const T dashpot_power = -dot(fused(T(tangent.stiffness), h.spring, slip.force), v_t);
    const T released = dot(mean_force + slip.force, slipped) + c.step * dashpot_power;
    // During slip the dashpot changes the energy of the spring, by γ_t v_t·ξ' of either sign.
    out.dissipation_rate_tangential = slip.slides ? T(0) : dashpot_power;
    out.dissipated_friction = slip.slides ? -dot(slip.force, slipped) : T(0);
    out.dissipated_release = slip.slides ? released : T(0);
  }
};

using enum Friction;

}  // namespace

#define KERNELS(friction, falls)                                               \
  Kernel<friction, falls, false, false>, Kernel<friction, falls, false, true>, \
      Kernel<friction, falls, true, false>, Kernel<friction, falls, true, true>

SCREE_CONTACT_LAW_PLUGIN(LinearSpringDashpot, KERNELS(none, false), KERNELS(undamped, false),
                         KERNELS(undamped, true), KERNELS(spring, false), KERNELS(spring, true),
                         KERNELS(total, false))
