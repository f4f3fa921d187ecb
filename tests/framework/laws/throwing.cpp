// A law that breaks the interface, for tests: it throws at overlaps above a limit.

#include <stdexcept>

#include <scree/plugin/contact_law.hpp>

namespace {

struct Throwing : scree::ContactLaw {
  double limit = 0;

  static constexpr scree::About about = {"throwing", "throws at overlaps above a limit", "f = 0", "—"};

  void declare(scree::Declaration& d) { d.number("limit", limit, "m", scree::non_negative, "of overlaps"); }
  std::uint32_t closed_forms(const scree_encounter&, scree_closed_form*, std::uint32_t) const { return 0; }
};

struct Kernel : Throwing {
  template <int D, class T>
  using History = scree::NoHistory<D, T>;

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>&, scree::LawOutput<D, T>&) const {
    if (c.overlap > T(limit)) throw std::runtime_error("boo");
  }
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(Throwing, Kernel)
