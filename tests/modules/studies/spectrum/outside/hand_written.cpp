// A law of somebody else that has no derivatives.

#include <scree/plugin/contact_law.hpp>

namespace {

struct HandWritten : scree::ContactLaw {
  double stiffness = 0;

  static constexpr scree::About about = {"hand_written", "a spring", "f = k δ", "—"};

  void declare(scree::Declaration& d) {
    d.number("stiffness", stiffness, "N/m", scree::positive, "k").required();
  }
  std::uint32_t closed_forms(const scree_encounter&, scree_closed_form*, std::uint32_t) const { return 0; }
};

struct Spring : HandWritten {
  template <int D, class T>
  using History = scree::NoHistory<D, T>;

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>&, scree::LawOutput<D, T>& out) const {
    out.force = T(stiffness) * c.overlap * c.normal;
  }
};

// As an author who fills the interface by hand may leave it.
int configure(const scree_setup* setup, void* storage, scree_contact_instance* instance) {
  const int failed = scree::detail::configure_law<HandWritten, Spring>(setup, storage, instance);
  if (!failed) instance->differentiate = nullptr;
  return failed;
}

const scree_contact_law interface = {sizeof(scree_contact_law), sizeof(HandWritten), 1u << 2 | 1u << 3,
                                     &configure, &scree::detail::closed_forms_of_law<HandWritten>};

}  // namespace

SCREE_EXPORT_PLUGIN((scree::manifest_of<HandWritten>(SCREE_CONTACT_LAW, interface)))
