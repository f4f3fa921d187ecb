// A contact law: linear spring and dashpot. Replace equations, parameters and forces by your own; the guide
// is share/doc/scree/plugins/README.md of scree.

#include <cmath>
#include <numbers>

#include <scree/plugin/contact_law.hpp>

namespace {

// The parameters. Initial values are the defaults.
struct PluginName : scree::ContactLaw {
  double stiffness = 0, damping = 0;

  static constexpr scree::About about = {
      "plugin_name", "linear spring and dashpot",
      "f = k δ − γ v_n    v_n: velocity of a relative to b along the normal",
      "your source, with the number of the equation"};

  void declare(scree::Declaration& d) {
    d.number("stiffness", stiffness, "N/m", scree::positive, "k").required();
    d.number("damping", damping, "kg/s", scree::non_negative, "γ");
  }

  // For the check of the time step, and for `scree describe plugin_name stiffness=5000`.
  std::uint32_t closed_forms(const scree_encounter& pair, scree_closed_form* forms,
                             std::uint32_t capacity) const {
    const double decay = 0.5 * damping / pair.reduced_mass;
    const double frequency = std::sqrt(stiffness / pair.reduced_mass - decay * decay);
    const double time = std::numbers::pi / frequency;
    if (capacity < 2) return 0;
    forms[0] = {"contact_time", "s", "t_c = π/√(k/m* − (γ/2m*)²)", time};
    forms[1] = {"restitution", "", "e = exp(−γ t_c/2m*)", std::exp(-decay * time)};
    return 2;
  }
};

struct PluginNameKernel : PluginName {
  // What `force` reads: anything else does not compile.
  static constexpr std::uint32_t reads =
      scree::reads_normal | scree::reads_overlap | scree::reads_relative_velocity | scree::reads_onset_weight;
  template <int D, class T>
  using History = scree::NoHistory<D, T>;

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>&, scree::LawOutput<D, T>& out) const {
    const T v_n = dot(c.relative_velocity, c.normal);
    const T spring = T(stiffness) * c.overlap;
    // The dashpot jumps at first touch and at parting: with the weight the result is of second order.
    const T dashpot = c.onset_weight * T(damping) * v_n;
    out.force = (spring - dashpot) * c.normal;
    out.elastic_normal = T(0.5) * spring * c.overlap;
    out.dissipation_rate_normal = dashpot * v_n;
  }
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(PluginName, PluginNameKernel)
