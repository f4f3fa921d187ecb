// A contact law with a mistake that the compiler must refuse: one for each macro SCREE_<CASE>, none with
// SCREE_NOTHING. tests/framework/CMakeLists.txt lists the complaints.

#include <scree/plugin/contact_law.hpp>

namespace {

struct Law : scree::ContactLaw {
  double stiffness = 1;
  static constexpr scree::About about = {"law", "a spring", "f = k δ", "—"};
  void declare(scree::Declaration& d) { d.number("stiffness", stiffness, "N/m", scree::positive, "k"); }
  std::uint32_t closed_forms(const scree_encounter&, scree_closed_form*, std::uint32_t) const { return 0; }
};

struct Kernel : Law {
#ifdef SCREE_SPIN_WITHOUT_TANGENTIAL
  static constexpr std::uint32_t reads =
      scree::reads_normal | scree::reads_overlap | scree::reads_relative_spin;
#endif
#ifdef SCREE_KERNEL_WITH_DATA
  double scale = 1;
#endif
  template <int D, class T>
  struct History {
    T largest_overlap;
#ifdef SCREE_HISTORY_OF_INTEGERS
    long count;
#endif
#ifdef SCREE_MISSING_NAME
    T second;
#endif
    static constexpr std::array<const char*, 1> names = {"largest_overlap"};
  };

#ifdef SCREE_WRONG_SIGNATURE
  template <int D, class T>
  void force(const scree::Contact<D, T, 0>&, History<D, T>&, scree::LawOutput<D, T>&) const {}
#else
  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>& h, scree::LawOutput<D, T>& out) const {
    h.largest_overlap = std::max(h.largest_overlap, c.overlap);
    out.force = T(stiffness) * c.overlap * c.normal;
#ifdef SCREE_UNDECLARED_INPUT
    out.force = out.force - c.relative_velocity;
#endif
#ifdef SCREE_UNDECLARED_COUPLE
    out.couple[0] = T(1);
#endif
  }
#endif
};

struct Other : Kernel {};

}  // namespace

#ifdef SCREE_KERNELS_WITHOUT_SUITS
SCREE_CONTACT_LAW_PLUGIN(Law, Kernel, Other)
#else
SCREE_CONTACT_LAW_PLUGIN(Law, Kernel)
#endif
