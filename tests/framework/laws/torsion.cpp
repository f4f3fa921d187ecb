// A spring between the orientations of two bodies, for tests: no force, and a couple that turns them to where
// they were at the start of the run.

#include <cmath>

#include <scree/plugin/contact_law.hpp>

namespace {

struct Torsion : scree::ContactLaw {
  double stiffness = 0;

  static constexpr scree::About about = {
      "torsion", "spring between the orientations of two bodies",
      "2D: c = −k (θ_a − θ_b)    3D: c = −2k sin(φ/2) e, rotation of a relative to b by φ about e", "—"};

  void declare(scree::Declaration& d) {
    d.number("stiffness", stiffness, "N m", scree::positive, "k").required();
  }
  std::uint32_t closed_forms(const scree_encounter&, scree_closed_form*, std::uint32_t) const { return 0; }
};

struct Kernel : Torsion {
  static constexpr std::uint32_t reads = scree::reads_overlap | scree::reads_orientations;
  static constexpr bool tangential = true;
  static constexpr bool writes_couple = true;
  template <int D, class T>
  using History = scree::NoHistory<D, T>;

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>&, scree::LawOutput<D, T, true>& out) const {
    if constexpr (D == 2) {
      const T angle = c.orientation_a[0] - c.orientation_b[0];
      out.couple[0] = -T(stiffness) * angle;
      out.elastic_tangential = T(0.5 * stiffness) * angle * angle;
    } else {
      // a b*, b* being the conjugate of b.
      const scree::Vec<3, T> a = {{c.orientation_a[1], c.orientation_a[2], c.orientation_a[3]}},
                             b = {{c.orientation_b[1], c.orientation_b[2], c.orientation_b[3]}};
      const T cosine = c.orientation_a[0] * c.orientation_b[0] + dot(a, b);
      out.couple = T(-2 * stiffness) * (c.orientation_b[0] * a - c.orientation_a[0] * b - cross(a, b));
      out.elastic_tangential = T(4 * stiffness) * (T(1) - cosine);
    }
  }
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(Torsion, Kernel)
