// Discs with the tangential spring of Cundall and Strack, after McNamara, García-Rojo, Herrmann (2008),
// [M6]-[M11].

#include "disc.hpp"

namespace {

struct CundallStrack : disc::Law {
  static constexpr scree::About about = {
      "disc_cundall_strack", "discs: linear normal force, tangential spring of Cundall and Strack",
      "f_n = k δ, or k A/(4 R*), + γ δ'                  A: overlap area; [M6], section II B\n"
      "D_t' = v·t − R_a ω_a − R_b ω_b                    v: velocity of a minus b, t = z × n; [M7], [M9]\n"
      "f_t = −(k_t D_t + γ_t D_t') t                     limited to μ f_n\n"
      "slip: |D_t| <= μ f_n/k_t                          [M11]\n"
      "arms of the torque: R. Angular momentum changes by δ f_t per time, and a closed path of the pair\n"
      "changes D_t by its area over R_a + R_b: [M17]",
      "McNamara et al. 2008, equations 6 to 11"};
};

template <disc::Normal kind>
struct Kernel : disc::Kernel<CundallStrack, kind> {
  static constexpr scree_arms arms = SCREE_ARM_RADIUS;
  static constexpr std::uint32_t reads =
      disc::Kernel<CundallStrack, kind>::reads | scree::reads_tangential_increment;

  template <int D, class T>
  using History = disc::SpringHistory<T>;

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>& h, scree::LawOutput<D, T>& out) const {
    const T f_n = this->template normal_force<T>(c, out);
    const auto t = disc::tangent(c.normal);
    const T force = this->slide_or_stick_in_plane(T(h.spring + dot(c.tangential_increment, t)),
                                                  dot(c.relative_velocity, t), f_n, c.onset_weight, h, out);
    out.force = scree::fused(T(-force), t, out.force);
  }
};

using disc::Normal;
template <Normal kind>
using Frictionless = disc::Frictionless<CundallStrack, kind>;

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(CundallStrack, Frictionless<Normal::overlap>, Frictionless<Normal::area>,
                         Kernel<Normal::overlap>, Kernel<Normal::area>)
