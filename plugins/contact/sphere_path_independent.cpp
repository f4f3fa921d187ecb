// Spheres with a tangential spring between painted points, after McNamara, García-Rojo, Herrmann (2008),
// [M18]-[M30], taken to three dimensions; the normal force is that of David et al. (2005), [D1], or Hertz's.

#include "hertz_normal.hpp"
#include "linear_normal.hpp"
#include "painted_points.hpp"
#include "sphere_keys.hpp"

namespace {

using scree::Contact;
using scree::LawOutput;
using scree::Vec;
using sphere::Normal;
using tangential::choose;

struct SpherePathIndependent : sphere::Keys {
  static constexpr scree::About about = {
      "sphere_path_independent",
      "spheres: tangential spring between painted points, normal force linear or Hertz's",
      "f_n = k δ + γ δ'                                  normal = linear, keys as of linear_spring_dashpot\n"
      "f_n = k_n δ + γ_n δ'                              normal = hertz, keys as of hertz_mindlin; k_t = 8 G* √(R* δ);\n"
      "                                                  and ½ k_t'(δ) ξ² along the normal, outside Coulomb's limit\n"
      "ξ = R_a log_C(A) − R_b log_n(B)                   A, B: points of the surfaces, painted at first touch; n: normal,\n"
      "                                                  C = −n; log: arc of a great circle, as a tangent vector\n"
      "    at a plane R_a log_C(A) + tangential part of x_a − x_w less that when painted; at a surface R_a log_C(A) +\n"
      "    arc from B to the nearest point: exact on flats, edges, cylinders and spheres; on cones and rims the third\n"
      "    order of the angle between the two is left out\n"
      "V = normal part + ½ k_t ξ²                        forces and torques are −∂V/∂q; angular momentum is conserved\n"
      "f_d = P(k_t ξ + γ_t ξ') − k_t ξ                   dashpot; P: limits the magnitude to C = μ max(f_n, 0);\n"
      "                                                  ξ' = α v_t + e (ω_a − ω_b) × n as of discs: rolling is free\n"
      "stick: |k_t ξ| <= C                               slip: ξ shortened to |k_t ξ| = C moves both points by half;\n"
      "                                                  the dashpot never causes slip; both only dissipate\n"
      "Closed paths of centres and rotations without slip leave no spring as long as both points stay within 0.1 rad of\n"
      "the contact. A point farther away: both are painted anew with the same ξ, less what the arcs stretched it across\n"
      "the direction of rolling, so that straight rolling leaves none. A spring across it grows by 2e-4 a radian of\n"
      "rolling without damping and slip, by 3e-3 in a hollow as narrow as the sphere. Points are painted anew at the\n"
      "end of a step: of bodies that twist the energy is then of first order in the step. Longer paths may leave a\n"
      "spring: a loop of radius ρ on a wall with the rotation vector z × x/R of the displacement x leaves ½ π ρ³/R²,\n"
      "0.04 R for ρ = 0.3 R; with an even twist to the first orientation a hundredth of that.\n"
      "Twist by ψ about the normal turns each painted point about the contact: after rolling by s since the painting it\n"
      "stretches ξ by ψ s. Rolling is not holonomic: no function of the configuration is 0 for all rolling with twist.\n"
      "Of the two, closed paths are kept, for loads that oscillate; bodies that roll far while they spin about the\n"
      "normal are braked, by a torque of at most 0.1 R μ f_n: after 50 R at 0.5 m/s (R = 5 mm, 1 g, μ = 0.5, γ_t =\n"
      "0.01 kg/s) 3 % of a spin of 20 rad/s are lost with k_t = 1e3 N/m, 72 % with 1e5 N/m, and the path is deflected\n"
      "by 0.14 R. linear_spring_dashpot and hertz_mindlin leave such a spin alone.\n"
      "normal = hertz without friction limit (μ from 100 on) and with restitution 1: contacts part with a stretched\n"
      "spring, whose normal force grows as δ^(-1/2); the energy then errs by some per cent at any usual step. With μ\n"
      "to 10 the spring slips to 0 first, and the error is of second order; with restitution 0.8 it is some 1e-3",
      "after McNamara et al. 2008, equations 18 to 30, in 3D"};

  std::uint32_t closed_forms(const scree_encounter& e, scree_closed_form* forms,
                             std::uint32_t capacity) const {
    if (chosen_normal() == Normal::hertz) return hertz.closed_forms(e, friction, true, forms, capacity);
    return linear.closed_forms(e, tangent.acting(), forms, capacity);
  }
};

template <Normal kind, bool by_restitution>
struct Frictionless : SpherePathIndependent {
  static bool suits(const SpherePathIndependent& p) {
    return p.chosen_normal() == kind && p.damped_by_mass() == by_restitution && !(p.friction > 0);
  }
  static constexpr std::uint32_t reads = scree::reads_normal | scree::reads_overlap |
                                         scree::reads_relative_velocity | scree::reads_onset_weight |
                                         (kind == Normal::hertz ? scree::reads_contact_radius : 0u) |
                                         (by_restitution ? scree::reads_reduced_mass_root : 0u);
  template <int D, class T>
  using History = scree::NoHistory<D, T>;

  template <int D, class T>
  void force(const Contact<D, T, reads>& c, History<D, T>&, LawOutput<D, T>& out) const {
    out.force = normal_force(c, out).total * c.normal;
  }

 protected:
  template <class AnyContact, class AnyOutput>
  auto normal_force(const AnyContact& c, AnyOutput& out) const {
    if constexpr (kind == Normal::hertz)
      return hertz.force(c, out);
    else
      return linear.template force<by_restitution>(c, out);
  }
};

// falls: μ_d < μ_s.
template <Normal kind, bool by_restitution, bool falls = false>
struct Frictional : Frictionless<kind, by_restitution> {
  static bool suits(const SpherePathIndependent& p) {
    return p.chosen_normal() == kind && p.damped_by_mass() == by_restitution && p.friction > 0 &&
           p.tangent.limit_falls() == falls;
  }
  static constexpr std::uint32_t reads = Frictionless<kind, by_restitution>::reads |
                                         scree::reads_tangential_increment | scree::reads_reduced_mass_root |
                                         scree::reads_relative_spin | scree::reads_orientations |
                                         scree::reads_separation | scree::reads_radii |
                                         (kind == Normal::hertz ? scree::reads_effective_radius : 0u);
  static constexpr bool tangential = true;
  static constexpr bool writes_couple = true;
  static constexpr bool follows_backwards = true;
  static constexpr bool follows_onset = kind == Normal::linear && !falls;
  static constexpr bool follows_surfaces = true;

  template <int D, class T>
  struct History {
    tangential::Points<T> points;
    Vec<D, T> spring;  // ξ (m)
    // linear: 1 while the contact slides; falls: state of FallingSlip (m), above 0 while it slides;
    // hertz: ±√(R* δ) at the last update of ξ (m), above 0 while it slides
    T state;
    static constexpr int sliding_column = 9;
    static constexpr std::array<const char*, 10> names = {
        "painted_a_x", "painted_a_y",
        "painted_a_z", "painted_b_x",
        "painted_b_y", "painted_b_z",
        "spring_x",    "spring_y",
        "spring_z",    kind == Normal::hertz ? "signed_contact_radius" : "sliding"};
  };

  template <int D, class T>
  T stored_energy(const History<D, T>& h) const {
    return T(0.5) * stiffness_of(h) * dot(h.spring, h.spring);
  }

  template <int D, class T>
  void force(const Contact<D, T, reads>& c, History<D, T>& h, LawOutput<D, T, true>& out) const {
    const normal::Force<T> f_n = this->normal_force(c, out);
    const tangential::PaintedPair<T, Contact<D, T, reads>> pair(c);
    const Vec<D, T> rate = pair.rate_at_contact();
    const bool painted = pair.painted(h.points);
    // At first touch the spring is as long as the pair moved while touching.
    const Vec<D, T> moved = tangential_part(c.tangential_increment, c.normal);
    const Vec<D, T> first = pair.first_share_of_a(moved);
    tangential::Shares<T> shares = pair.shares(h.points);
    shares = {choose(painted, shares.a, first), choose(painted, shares.b, moved - first),
              painted ? shares.bend : T(0)};
    const Vec<D, T> without_slip = shares.a + shares.b, stretching = pair.stretching(shares, rate);
    const bool far = pair.is_far(shares);
    const Vec<D, T> anew = pair.painted_anew(shares);
    shares = {choose(far, anew, shares.a), choose(far, anew, shares.b), shares.bend};
    const Vec<D, T> trial = shares.a + shares.b;

    const scree::SlipStep<D, T> step = slip_step(c, h, trial, rate, stretching, f_n.repulsive);
    scree::FallingSlip<D, T> result;
    if constexpr (falls)
      result = scree::slide_or_stick(
          this->tangent.falling(step, f_n.repulsive, c.normal, h.spring, h.state, c.kick));
    else
      result = slide_or_stick(c, step, h);
    const scree::Slip<D, T>& slip = result.slip;
    const T stiffness_before = stiffness_of(h);
    const Vec<D, T> before = h.spring;
    shares = pair.slipped(shares, trial - slip.spring);
    place(pair, shares, painted & !slip.slides, far, h);
    h.spring = slip.spring;
    h.state = falls ? result.state : state_of(c, slip.slides);

    Vec<D, T> pull = -slip.force;
    if constexpr (adds_to_force) pull -= result.begun;
    const tangential::SpringLoads<T> loads = pair.loads(shares, step.stiffness, pull);
    T along_normal = f_n.total;
    if constexpr (kind == Normal::hertz)
      along_normal += this->hertz.force_of_potential(c, dot(slip.spring, slip.spring));
    out.force = fused(along_normal, c.normal, loads.force);
    out.couple = loads.couple;
    out.elastic_tangential = stored_energy(h);
    out.dissipation_rate_tangential = -dot(fused(step.stiffness, slip.spring, slip.force), rate);
    const Vec<D, T> mean_force = T(0.5) * fused(stiffness_before, before, step.stiffness * slip.spring);
    T friction_work = dot(mean_force, without_slip - slip.spring);
    if constexpr (adds_to_force) friction_work -= c.kick * dot(result.begun, rate);
    out.dissipated_friction = c.backwards ? friction_work : std::max(friction_work, T(0));
  }

 private:
  // Whether the moment in a step at which slip begins adds to the force.
  static constexpr bool adds_to_force = falls || follows_onset;

  template <int D, class T, class AnyHistory>
  scree::FallingSlip<D, T> slide_or_stick(const Contact<D, T, reads>& c, const scree::SlipStep<D, T>& step,
                                          const AnyHistory& h) const {
    if (kind == Normal::hertz || !c.onset) {
      return {scree::slide_or_stick(step), {}, T(0)};
    } else {
      // With a tangential dashpot as if the contact slid before.
      const T slid = h.state + T(this->tangent.damping);
      return scree::slide_or_stick(
          this->linear.first_slip(c, step, this->linear.template damping_coefficient<by_restitution>(c),
                                  T(this->friction), h.spring, slid));
    }
  }

  // k_t at the last update of the spring (N/m).
  template <class AnyHistory>
  auto stiffness_of(const AnyHistory& h) const {
    using T = std::decay_t<decltype(h.state)>;
    if constexpr (kind == Normal::hertz)
      return this->hertz.tangential_stiffness(T(std::max(h.state, -h.state)));
    else
      return T(this->tangent.stiffness);
  }
  template <class AnyContact>
  static auto state_of(const AnyContact& c, bool slides) {
    using T = std::decay_t<decltype(c.overlap)>;
    if constexpr (kind == Normal::hertz)
      return slides ? c.contact_radius.value : -c.contact_radius.value;
    else
      return slides ? T(1) : T(0);
  }

  template <int D, class T, class AnyHistory>
  scree::SlipStep<D, T> slip_step(const Contact<D, T, reads>& c, const AnyHistory& h, const Vec<D, T>& trial,
                                  const Vec<D, T>& rate, const Vec<D, T>& stretching,
                                  const T& repulsive) const {
    T stiffness = T(this->tangent.stiffness), inverse = T(this->tangent.inverse_stiffness);
    T damping = c.onset_weight * T(this->tangent.damping);
    if constexpr (kind == Normal::hertz) {
      stiffness = this->hertz.tangential_stiffness(c.contact_radius.value);
      inverse = T(this->hertz.inverse_shear_stiffness) * c.contact_radius.inverse;
      damping = normal::Hertz::damping_weight(c) * T(this->hertz.tangential_damping);
    }
    const T sliding_limit = T(this->tangent.dynamic_friction) * repulsive;
    return {.trial_spring = trial,
            .stiffness = stiffness,
            .inverse_stiffness = inverse,
            .velocity = rate,
            .delay = damping * inverse,
            .step = c.step,
            .limit = h.state > T(0) ? sliding_limit : T(this->friction) * repulsive,
            .sliding_limit = sliding_limit,
            .stretching = stretching,
            .returns = c.backwards && h.state > T(0)};
  }

  // Paints the points at their shares; those that stay keep their bits, unless they are painted anew.
  template <class Pair, class T, class AnyHistory>
  static void place(const Pair& pair, const tangential::Shares<T>& shares, bool stay, bool anew,
                    AnyHistory& h) {
    const tangential::Points<T> points = pair.points(shares);
    h.points = {choose(anew, points.a, choose(stay, h.points.a, points.a)),
                choose(anew, points.b, choose(stay, h.points.b, points.b))};
  }
};

using enum Normal;

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(SpherePathIndependent, Frictionless<linear, false>, Frictionless<linear, true>,
                         Frictionless<hertz, true>, Frictional<linear, false>, Frictional<linear, true>,
                         Frictional<linear, false, true>, Frictional<linear, true, true>,
                         Frictional<hertz, true>)
