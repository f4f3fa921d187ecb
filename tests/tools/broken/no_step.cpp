// A law for which no time step is short enough.

#include <scree/plugin/contact_law.hpp>

namespace {

struct NoStep : scree::ContactLaw {
  static constexpr scree::About about = {"no_step", "has no stable step", "f = 0", "—"};
  void declare(scree::Declaration&) {}
  std::uint32_t closed_forms(const scree_encounter&, scree_closed_form* forms, std::uint32_t) const {
    forms[0] = {"contact_time", "s", "t_c", 1};
    forms[1] = {"restitution", "", "e", 1};
    forms[2] = {"critical_step", "s", "h", 0};
    return 3;
  }
};

struct Kernel : NoStep {
  template <int D, class T>
  using History = scree::NoHistory<D, T>;
  template <int D, class T>
  void force(const scree::Contact<D, T, reads>&, History<D, T>&, scree::LawOutput<D, T>&) const {}
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(NoStep, Kernel)
