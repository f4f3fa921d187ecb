// A law that ends the program, with the status of success.

#include <cstdlib>

#include <scree/plugin/contact_law.hpp>

namespace {

struct ExitsWhenConfigured : scree::ContactLaw {
  static constexpr scree::About about = {"exits_when_configured", "ends the program", "f = 0", "—"};
  void declare(scree::Declaration&) {}
  void prepare(const scree::Setup&) { std::exit(0); }
  std::uint32_t closed_forms(const scree_encounter&, scree_closed_form*, std::uint32_t) const { return 0; }
};

struct Kernel : ExitsWhenConfigured {
  template <int D, class T>
  using History = scree::NoHistory<D, T>;
  template <int D, class T>
  void force(const scree::Contact<D, T, reads>&, History<D, T>&, scree::LawOutput<D, T>&) const {}
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(ExitsWhenConfigured, Kernel)
