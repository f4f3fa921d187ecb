// A law of somebody else that has no derivatives, or reads orientations.

#include <scree/plugin/contact_law.hpp>

namespace {

struct Aligner : scree::ContactLaw {
  double stiffness = 0;
  int aligns = 0;

  static constexpr scree::About about = {"aligner", "a spring, of which some turn bodies back",
                                         "f = k δ, c = −k (θ_a − θ_b)", "—"};

  void declare(scree::Declaration& d) {
    d.number("stiffness", stiffness, "N/m", scree::positive, "k").required();
    d.choice("aligns", aligns, "no|yes", "whether it turns bodies back");
  }
  std::uint32_t closed_forms(const scree_encounter&, scree_closed_form*, std::uint32_t) const { return 0; }
};

struct Spring : Aligner {
  template <int D, class T>
  using History = scree::NoHistory<D, T>;
  static bool suits(const Aligner& parameters) { return parameters.aligns == 0; }

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>&, scree::Response<D, T>& out) const {
    out.force = T(stiffness) * c.overlap * c.normal;
  }
};

struct AligningSpring : Aligner {
  static constexpr std::uint32_t reads =
      scree::reads_overlap | scree::reads_normal | scree::reads_orientations;
  static constexpr bool tangential = true;
  static constexpr bool writes_couple = true;
  template <int D, class T>
  using History = scree::NoHistory<D, T>;
  static bool suits(const Aligner& parameters) { return parameters.aligns == 1; }

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>&, scree::Response<D, T, true>& out) const {
    out.force = T(stiffness) * c.overlap * c.normal;
    out.couple[0] = -T(stiffness) * (c.orientation_a[0] - c.orientation_b[0]);
  }
};

// As an author who fills the interface by hand may leave it.
int configure(const scree_setup* setup, void* storage, scree_contact_instance* instance) {
  const int failed = scree::detail::configure_law<Aligner, Spring, AligningSpring>(setup, storage, instance);
  if (!failed && static_cast<const Aligner*>(storage)->aligns == 0) instance->differentiate = nullptr;
  return failed;
}

const scree_contact_law interface = {sizeof(scree_contact_law), sizeof(Aligner), 1u << 2 | 1u << 3,
                                     &configure, &scree::detail::closed_forms_of_law<Aligner>};

}  // namespace

SCREE_EXPORT_PLUGIN((scree::manifest_of<Aligner>(SCREE_CONTACT_LAW, interface)))
