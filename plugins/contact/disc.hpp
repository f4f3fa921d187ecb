// Parameters, normal force and slip of the laws for discs after McNamara, García-Rojo, Herrmann, "Microscopic
// origin of granular ratcheting" (2008), [M6]-[M30]. Their tangential springs differ; see the three plug-ins.

#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scree/plugin/contact_law.hpp>
#include <scree/plugin/restitution.hpp>
#include <scree/plugin/roots.hpp>
#include <scree/plugin/stability.hpp>

namespace disc {

using scree::Contact;
using scree::LawOutput;
using scree::Vec;

enum class Normal { overlap, area };

// Normal spring at one overlap.
template <class T>
struct NormalSpring {
  T force, stiffness, energy;  // (N), dF/dδ (N/m), (J)
};

struct Impact {
  double time, restitution;  // (s), 1
};

struct Law : scree::ContactLaw {
  int normal = 0;  // Normal
  double normal_stiffness = 0;
  double normal_damping = 0;
  double restitution = 0;  // 0: normal_damping was given
  double tangential_stiffness = 0;
  double tangential_damping = 0;
  double friction = 0;
  double damping_by_root_mass = 0;  // γ/√m* = 2ζ √k
  double inverse_tangential_stiffness = 0;

  static constexpr int only_dimension = 2;

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.choice("normal", normal, "overlap|area",
             "normal force in proportion to the overlap, or to the overlap area: k A/(4 R*)");
    d.number("normal_stiffness", normal_stiffness, "N/m", positive, "k, K_n of the paper").required();
    d.number("normal_damping", normal_damping, "kg/s", non_negative, "γ, independent of mass")
        .or_else("restitution");
    d.number("restitution", restitution, "", positive_coefficient,
             "r, independent of mass and speed, for normal = overlap: γ = 2ζ√(k m*)")
        .or_else("normal_damping");
    d.number("tangential_stiffness", tangential_stiffness, "N/m", positive, "k_t, K_t of the paper")
        .required();
    d.number("tangential_damping", tangential_damping, "kg/s", non_negative, "γ_t of the tangential dashpot");
    d.number("friction", friction, "", non_negative, "μ; 0: frictionless, 1e9: as good as infinite")
        .required();
  }

  void prepare(const scree::Setup& setup) {
    if (restitution > 0 && Normal(normal) == Normal::area)
      return setup.refuse(
          "restitution would depend on the speed with normal = \"area\"; give normal_damping, or normal = "
          "\"overlap\"");
    if (restitution > 0)
      damping_by_root_mass =
          2 * scree::damping_ratio_of(restitution, scree::Tension::allowed) * std::sqrt(normal_stiffness);
    inverse_tangential_stiffness = 1 / tangential_stiffness;
  }

  // Dashpots jump at first touch, and at parting.
  double onset_power() const { return 0; }
  double parting_power() const { return 0; }

  std::uint32_t closed_forms(const scree_encounter& e, scree_closed_form* forms,
                             std::uint32_t capacity) const {
    constexpr double pi = std::numbers::pi;
    const double m = e.reduced_mass, k = normal_stiffness, omega_0 = std::sqrt(k / m);
    const double gamma = restitution > 0 ? damping_by_root_mass * std::sqrt(m) : normal_damping;
    const double zeta = gamma / (2 * std::sqrt(k * m));
    const double inverse_mass = friction > 0 ? 3 / m : 0;  // 1 + m R²/I of discs
    const double critical_step = scree::critical_step(
        {k / m, gamma / m}, {inverse_mass * tangential_stiffness, inverse_mass * tangential_damping},
        e.network);
    const bool area = Normal(normal) == Normal::area;
    const Impact impact =
        area ? area_impact(e, gamma)
             : Impact{.time = zeta < 1 ? pi / (omega_0 * std::sqrt(1 - zeta * zeta)) : scree::infinity,
                      .restitution = scree::restitution_of(zeta, scree::Tension::allowed)};
    const scree_closed_form all[] = {
        {"contact_time", "s",
         area ? "m* δ'' = −(k √2/(3 √R*)) δ^{3/2} − γ δ', small overlaps, integrated"
              : "t_c = π/ω, ω² = k/m* − (γ/2m*)²",
         impact.time},
        {"restitution", "", area ? "of the same impact" : "r = exp(−π ζ/√(1 − ζ²)), ζ = γ/(2√(k m*))",
         impact.restitution},
        {"critical_step", "s",
         "2/(√(k/m* + (γ/m*)²) + γ/m*), longest stable step of velocity Verlet for this pair;\n"
         "                        with 3 k_t, 3 γ_t if that is shorter",
         critical_step}};
    std::uint32_t n = 0;
    for (; n < std::min<std::size_t>(capacity, std::size(all)); ++n) forms[n] = all[n];
    return n;
  }

 private:
  // Head-on impact with normal = area at small overlaps, 4R* F = (4/3) k √(2R*) δ^{3/2}, in units of the
  // length L in which the spring takes up the kinetic energy, and of L/v: x″ = −x^{3/2} − c x′, by
  // Runge-Kutta steps of 1e-3.
  Impact area_impact(const scree_encounter& e, double gamma) const {
    const double power_stiffness = normal_stiffness * std::sqrt(2 / e.effective_radius) / 3;
    const double length = std::pow(e.reduced_mass * e.speed * e.speed / power_stiffness, 0.4);
    const double c = gamma * length / (e.reduced_mass * e.speed);
    constexpr double h = 1e-3, longest = 100;
    const auto acceleration = [c](double x, double v) {
      return -std::max(x, 0.0) * std::sqrt(std::max(x, 0.0)) - c * v;
    };
    double x = 0, v = 1, t = 0;
    for (; t < longest; t += h) {
      const double a1 = acceleration(x, v), v2 = v + 0.5 * h * a1;
      const double a2 = acceleration(x + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2;
      const double a3 = acceleration(x + 0.5 * h * v2, v3), v4 = v + h * a3;
      const double a4 = acceleration(x + h * v3, v4);
      const double next = x + h / 6 * (v + 2 * v2 + 2 * v3 + v4);
      if (next < 0) return {(t + h * x / (x - next)) * length / e.speed, -v};
      x = next;
      v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return {scree::infinity, 0};
  }
};

// Normal spring and overlap area
//   A = ∫₀^δ 2a(s) ds, ∫₀^δ A ds = ∫₀^δ (δ − s) 2a(s) ds,   a: half the chord of the lens at overlap s,
//   a² = s g(s), g = (2R_a − s) (2R_b − s) (2S − s)/(4 (S − s)²), S = R_a + R_b; beside a wall g = 2R_a − s.
// With s = δ z both are ∫ √z h(z) dz with a smooth h: Gauss quadrature with four nodes, exact for h up to z⁷.
template <int D, class T, std::uint32_t reads>
NormalSpring<T> area_spring(const Law& law, const Contact<D, T, reads>& c) {
  constexpr double node[] = {0.10514028258908978, 0.37622451445317489, 0.69894801241780082,
                             0.93733424936346391};
  constexpr double weight[] = {0.065680519891724192, 0.19609626543099633, 0.25252734572920414,
                               0.152362535614742};
  const bool wall = c.radius_b == T(0);
  const T sum = c.radius_a + c.radius_b, overlap = std::max(c.overlap, T(0));
  const auto half_chord_per_root = [&](const T& s) {  // √g
    const T distance = sum - s;
    const T pair = (T(2) * c.radius_b - s) * (T(2) * sum - s) / (T(4) * distance * distance);
    return scree::root_of((T(2) * c.radius_a - s) * (wall ? T(1) : pair)).value;
  };
  T area = T(0), integral = T(0);
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    const T part = T(weight[k]) * half_chord_per_root(T(node[k]) * overlap);
    area += part;
    integral += T(1 - node[k]) * part;
  }
  const T root = scree::root_of(overlap).value, scale = T(law.normal_stiffness) / (T(4) * c.effective_radius);
  const T chord = T(2) * root * half_chord_per_root(overlap), power = T(2) * root * overlap;
  return {scale * power * area, scale * chord, scale * power * overlap * integral};
}

// History of springs that are integrated.
template <class T>
struct SpringHistory {
  T spring;   // D_t (m)
  T sliding;  // 1 while the contact slides
  static constexpr int sliding_column = 1;
  static constexpr std::array<const char*, 2> names = {"spring", "sliding"};
};

// Normal force of a law whose parameters derive from Law, and slip of its tangential spring.
template <class Parameters, Normal kind>
struct Kernel : Parameters {
  static bool suits(const Parameters& p) { return Normal(p.normal) == kind && p.friction > 0; }
  static constexpr bool tangential = true;
  static constexpr std::uint32_t reads =
      scree::reads_normal | scree::reads_overlap | scree::reads_relative_velocity |
      scree::reads_onset_weight | scree::reads_reduced_mass_root |
      (kind == Normal::area ? scree::reads_effective_radius | scree::reads_radii : 0u);

  // Of histories with a spring (J).
  template <class AnyHistory>
  auto stored_energy(const AnyHistory& h) const -> decltype(h.spring * h.spring) {
    using T = decltype(h.spring * h.spring);
    return T(0.5 * this->tangential_stiffness) * h.spring * h.spring;
  }

 protected:
  // Sets the normal part of the output. Returns the force that limits friction (N).
  template <class T, class AnyContact, class AnyOutput>
  T normal_force(const AnyContact& c, AnyOutput& out) const {
    NormalSpring<T> spring;
    if constexpr (kind == Normal::overlap)
      spring = {T(this->normal_stiffness) * c.overlap, T(this->normal_stiffness),
                T(0.5 * this->normal_stiffness) * c.overlap * c.overlap};
    else
      spring = area_spring(*this, c);
    const T v_n = dot(c.relative_velocity, c.normal);
    const T gamma = scree::fused(T(this->damping_by_root_mass), c.reduced_mass_root, T(this->normal_damping));
    const T predicted =
        scree::prediction_share(T(0.5) * c.step * c.step, spring.stiffness, c.reduced_mass_root);
    const T total = scree::fused(-(c.onset_weight * predicted * gamma), v_n, spring.force);
    out.force = total * c.normal;
    out.elastic_normal = spring.energy;
    out.dissipation_rate_normal = (spring.force - total) * v_n;
    return std::max(total, T(0));
  }

  // Coulomb friction on a spring of elongation D_t with a parallel dashpot:
  //   |k_t D_t| <= μ f_n [M11];  |k_t D_t + γ_t D_t′| <= μ f_n
  // trial: elongation after the step without slip (m); rate: D_t′ (m/s); f_n (N).
  // Stores elongation and state of the spring, and returns k_t D_t + γ_t D_t′ (N).
  template <class T, class AnyHistory, class AnyOutput>
  T slide_or_stick_in_plane(const T& trial, const T& rate, const T& f_n, const T& onset_weight, AnyHistory& h,
                            AnyOutput& out) const {
    const T old = h.spring, limit = T(this->friction) * f_n;
    const T longest = limit * T(this->inverse_tangential_stiffness);
    h.spring = std::max(-longest, std::min(trial, longest));
    h.sliding = trial * trial > longest * longest ? T(1) : T(0);
    const T elastic = T(this->tangential_stiffness) * h.spring;
    const T sum = scree::fused(T(this->tangential_damping) * onset_weight, rate, elastic);
    const T force = std::max(-limit, std::min(sum, limit));
    out.elastic_tangential = T(0.5) * elastic * h.spring;
    out.dissipation_rate_tangential = (force - elastic) * rate;
    out.dissipated_friction =
        std::max(T(0.5 * this->tangential_stiffness) * (old + h.spring) * (trial - h.spring), T(0));
    return force;
  }
};

template <class Parameters, Normal kind>
struct Frictionless : Kernel<Parameters, kind> {
  using Base = Kernel<Parameters, kind>;
  static bool suits(const Parameters& p) { return Normal(p.normal) == kind && !(p.friction > 0); }
  static constexpr bool tangential = false;
  static constexpr std::uint32_t reads = Base::reads;
  template <int D, class T>
  using History = scree::NoHistory<D, T>;

  template <int D, class T>
  void force(const Contact<D, T, reads>& c, History<D, T>&, LawOutput<D, T>& out) const {
    this->template normal_force<T>(c, out);
  }
};

// t = z × n [M10].
template <class T>
Vec<2, T> tangent(const Vec<2, T>& n) {
  return {{-n[1], n[0]}};
}

}  // namespace disc
