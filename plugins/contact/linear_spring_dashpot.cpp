// Linear spring and dashpot with a tangential spring, Coulomb sliding and stick/slip memory, after
// David, García-Rojo, Herrmann, Luding, "Hysteresis and creep in powders and grains" (2005), [D1]-[D4].

#include <cmath>

#include <scree/contact_law.hpp>
#include <scree/restitution.hpp>
#include <scree/rolling.hpp>
#include <scree/stability.hpp>

namespace {

using scree::Contact;
using scree::Response;
using scree::Vec;

constexpr double pi = 3.14159265358979323846;

struct LinearSpringDashpot : scree::ContactLaw {
  double normal_stiffness = 0;
  double normal_damping = 0;
  double restitution = 0;  // 0: normal_damping was given
  int tension = 0;         // scree::Tension
  double tangential_stiffness = 0;
  double tangential_damping = 0;
  double static_friction = 0;
  double dynamic_friction = -1;  // below 0: the same as static
  double rolling_friction = 0;
  double damping_ratio = 0;
  double damping_by_root_mass = 0;          // γ/√m* = 2ζ √k
  double inverse_tangential_stiffness = 0;  // 1/k_t

  static constexpr scree::About about = {
      "linear_spring_dashpot",
      "linear spring and dashpot, tangential spring with static and dynamic friction",
      "f_n = k δ + γ δ'                                  normal force\n"
      "ξ <- ξ + v_t Δt (mid-step normal), ξ <- ξ − n (n·ξ)   spring carried along, then turned into the "
      "plane\n"
      "f_0 = −k_t ξ − γ_t v_t                            test force\n"
      "stick: |f_0| <= μ f_n, f_t = f_0                  μ = μ_s while sticking, μ_d while sliding\n"
      "slip:  f_t = μ_d f_n f_0/|f_0|, ξ = −(f_t + γ_t v_t)/k_t\n"
      "T = −μ_r k δ R* Δω/|Δω|  rolling; smaller where it would turn the motion round within a step\n"
      "arms of the torque: R − δ/2 (angular momentum is conserved)",
      "David et al. 2005, equations 1 to 4"};

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.number("normal_stiffness", normal_stiffness, "N/m", positive, "k, stiffness of the normal spring")
        .required();
    d.number("normal_damping", normal_damping, "kg/s", non_negative, "γ, the same for all masses")
        .or_else("restitution");
    d.number("restitution", restitution, "", positive_coefficient,
             "r, reached for every mass: γ = 2ζ√(k m*), ζ from r and tension")
        .or_else("normal_damping");
    d.choice("tension", tension, "allowed|cut",
             "whether the dashpot may pull at the end of a contact; both reach the restitution asked for");
    d.number("tangential_stiffness", tangential_stiffness, "N/m", non_negative,
             "k_t of the tangential spring");
    d.number("tangential_damping", tangential_damping, "kg/s", non_negative, "γ_t of the tangential dashpot");
    d.number("static_friction", static_friction, "", non_negative,
             "μ_s; 0 leaves out all that friction needs");
    d.number("dynamic_friction", dynamic_friction, "", non_negative,
             "μ_d <= μ_s, the same as static if absent")
        .optional();
    d.number("rolling_friction", rolling_friction, "", non_negative, "μ_r; 0 leaves rolling resistance out");
  }

  void prepare(const scree::Setup& setup) {
    if (dynamic_friction < 0) dynamic_friction = static_friction;
    if (dynamic_friction > static_friction)
      return setup.refuse("dynamic_friction is above static_friction; give at most the static value");
    if (static_friction > 0 && tangential_stiffness <= 0)
      return setup.refuse("friction needs tangential_stiffness above 0");
    if (restitution > 0) damping_ratio = scree::damping_ratio_of(restitution, scree::Tension(tension));
    damping_by_root_mass = 2 * damping_ratio * std::sqrt(normal_stiffness);
    if (tangential_stiffness > 0) inverse_tangential_stiffness = 1 / tangential_stiffness;
  }

  std::size_t kernel() const {
    return (rolling_friction > 0 ? 4 : 0) + (static_friction > 0 ? 2 : 0) + (restitution > 0 ? 1 : 0);
  }

  std::uint32_t closed_forms(const scree_encounter& e, scree_closed_form* forms,
                             std::uint32_t capacity) const {
    const double m = e.reduced_mass, k = normal_stiffness, omega_0 = std::sqrt(k / m);
    const double zeta = restitution > 0 ? damping_ratio : normal_damping / (2 * std::sqrt(k * m));
    const double r = scree::restitution_of(zeta, scree::Tension(tension));
    // t_c = −ln r / η holds in both conventions: the motion decays as exp(−ηt) until the contact ends.
    const double contact_time =
        zeta > 0 ? (r > 0 ? -std::log(r) / (zeta * omega_0) : scree::infinity) : pi / omega_0;
    const double light = static_friction > 0 ? scree::tangential_lightness / m : 0;
    const double critical_step = scree::critical_step(
        {k / m, 2 * zeta * omega_0}, {light * tangential_stiffness, light * tangential_damping}, e.network);
    const scree_closed_form all[] = {
        {"contact_time", "s", "t_c = π/ω, ω² = k/m* − η², η = γ/2m* (tension cut: until f_n = 0)",
         contact_time},
        {"restitution", "", "r = exp(−η t_c)", r},
        {"critical_step", "s",
         "2/(√(k/m* + (γ/m*)²) + γ/m*), longest stable step of velocity Verlet for this pair; the\n"
         "                        same with 7/2 k_t, 7/2 γ_t if that is shorter",
         critical_step},
        {"damping_ratio", "", "ζ = γ/(2√(k m*))", zeta}};
    std::uint32_t n = 0;
    for (; n < std::min<std::size_t>(capacity, std::size(all)); ++n) forms[n] = all[n];
    return n;
  }
};

template <bool frictional, bool by_restitution, bool rolling = false>
struct Kernel : LinearSpringDashpot {
  static constexpr std::uint32_t reads =
      scree::reads_normal | scree::reads_overlap | scree::reads_relative_velocity |
      scree::reads_onset_weight | (frictional ? scree::reads_tangential_increment : 0u) |
      (by_restitution ? scree::reads_reduced_mass_root : 0u) |
      (rolling ? scree::reads_relative_spin | scree::reads_reduced_mass_root | scree::reads_effective_radius
               : 0u);
  static constexpr bool tangential = frictional || rolling;
  static constexpr bool writes_couple = rolling;

  template <int D, class T>
  struct Friction {
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
  using History = std::conditional_t<frictional, Friction<D, T>, scree::NoHistory<D, T>>;

  template <int D, class T>
  T stored_energy(const Friction<D, T>& h) const {
    return T(0.5 * tangential_stiffness) * dot(h.spring, h.spring);
  }

  template <int D, class T>
  void force(const Contact<D, T>& c, History<D, T>& h, Response<D, T>& out) const {
    const T v_n = dot(c.relative_velocity, c.normal);
    T gamma = T(normal_damping);
    if constexpr (by_restitution) gamma = T(damping_by_root_mass) * c.reduced_mass_root;

    // [D1], δ' = −v_n
    const T spring_force = T(normal_stiffness) * c.overlap;
    const T pushing_or_pulling = scree::fused(-(c.onset_weight * gamma), v_n, spring_force);
    const T pushing = std::max(pushing_or_pulling, T(0));
    const T f_n = scree::Tension(tension) == scree::Tension::cut ? pushing : pushing_or_pulling;
    out.force = f_n * c.normal;
    out.elastic_normal = T(0.5) * spring_force * c.overlap;
    out.dissipated_normal = (spring_force - f_n) * v_n;
    if constexpr (frictional) slide_or_stick(c, pushing, h, out);
    if constexpr (rolling) scree::resist_rolling(c, spring_force, rolling_friction, out);
  }

 private:
  template <int D, class T>
  void slide_or_stick(const Contact<D, T>& c, const T& f_n, Friction<D, T>& h, Response<D, T>& out) const {
    const T k_t = T(tangential_stiffness);
    const Vec<D, T> v_t = tangential_part(c.relative_velocity, c.normal);
    const Vec<D, T> dashpot = (c.onset_weight * T(tangential_damping)) * v_t;

    // The old spring, moved by this step's displacement and turned into the present tangent plane.
    const Vec<D, T> old = h.spring;
    const Vec<D, T> xi = tangential_part(old + c.tangential_increment, c.normal);
    const Vec<D, T> f_0 = fused(-k_t, xi, -dashpot);  // [D3]
    const T square = dot(f_0, f_0);
    const T limit = (h.sliding > T(0) ? T(dynamic_friction) : T(static_friction)) * f_n;
    const bool slides = square > limit * limit;

    const Vec<D, T> f_t = (slides ? T(dynamic_friction) * f_n * scree::inverse_sqrt(square) : T(1)) * f_0;
    const T inverse_k_t = T(inverse_tangential_stiffness);
    for (int k = 0; k < D; ++k) h.spring[k] = slides ? -(f_t[k] + dashpot[k]) * inverse_k_t : xi[k];  // [D4]
    h.sliding = slides ? T(1) : T(0);

    out.force += f_t;
    out.elastic_tangential = stored_energy(h);
    out.dissipated_tangential = dot(dashpot, v_t);
    // The work of the mean of the old and the new spring's force on what slipped: what the bodies lose,
    // exactly.
    out.dissipated_friction = T(0.5) * k_t * dot(old + h.spring, xi - h.spring);
  }
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(LinearSpringDashpot, Kernel<false, false>, Kernel<false, true>, Kernel<true, false>,
                         Kernel<true, true>, Kernel<false, false, true>, Kernel<false, true, true>,
                         Kernel<true, false, true>, Kernel<true, true, true>)
