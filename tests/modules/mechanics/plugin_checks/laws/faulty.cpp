// A spring and dashpot with one mistake of choice, each of which a check must find.

#include <cmath>
#include <numbers>
#include <type_traits>

#include <scree/plugin/contact_law.hpp>

namespace {

enum Fault {
  none,
  asymmetric,
  anisotropic,
  creates_energy,
  unbalanced,
  derivative,
  infinite,
  restitution,
  duration,
  sideways
};

struct Faulty : scree::ContactLaw {
  double stiffness = 0, damping = 0, exponent = 1;
  int fault = none;

  static constexpr scree::About about = {"faulty", "a spring and dashpot with a mistake", "f = k δ − γ v_n",
                                         "—"};

  void declare(scree::Declaration& d) {
    d.number("stiffness", stiffness, "N/m", scree::positive, "k").required();
    d.number("damping", damping, "kg/s", scree::non_negative, "γ");
    d.number("exponent", exponent, "", scree::coefficient,
             "divides by 0 where it is 0 and the fault infinite");
    d.choice("fault", fault,
             "none|asymmetric|anisotropic|creates_energy|unbalanced|derivative|infinite|restitution|duration|"
             "sideways",
             "the mistake");
  }
  std::uint32_t closed_forms(const scree_encounter& e, scree_closed_form* forms, std::uint32_t) const {
    const double decay = 0.5 * damping / e.reduced_mass;
    const double time = std::numbers::pi / std::sqrt(stiffness / e.reduced_mass - decay * decay);
    forms[0] = {"contact_time", "s", "t_c", (fault == duration ? 0.5 : 1) * time};
    forms[1] = {"restitution", "", "e", std::exp(-decay * time) - (fault == restitution ? 0.01 : 0)};
    return 2;
  }
};

struct Kernel : Faulty {
  static constexpr std::uint32_t reads =
      scree::reads_normal | scree::reads_overlap | scree::reads_relative_velocity | scree::reads_onset_weight;
  template <int D, class T>
  using History = scree::NoHistory<D, T>;

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>&, scree::LawOutput<D, T>& out) const {
    const T v_n = dot(c.relative_velocity, c.normal), spring = T(stiffness) * c.overlap;
    const T dashpot = T(fault == creates_energy ? -damping : damping) * c.onset_weight * v_n;
    out.force = (spring - dashpot) * c.normal;
    out.elastic_normal = T(fault == unbalanced ? 0.6 : 0.5) * spring * c.overlap;
    out.dissipation_rate_normal = dashpot * v_n;
    if (fault == sideways) out.force += T(-0.1 * damping) * tangential_part(c.relative_velocity, c.normal);
    if (fault == asymmetric) out.force[0] += T(1e-3) * spring;
    if (fault == anisotropic) out.force = (T(1) + T(1e-3) * c.normal[0] * c.normal[0]) * out.force;
    if (fault == infinite) out.force = (T(1) / T(exponent)) * out.force;
    if constexpr (std::is_same_v<T, scree::Dual>)
      if (fault == derivative) out.force = T(1.001) * out.force;
  }
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(Faulty, Kernel)
