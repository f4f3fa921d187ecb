// Discs with a path-independent tangential spring, integrated, after McNamara, García-Rojo, Herrmann (2008),
// [M23]-[M30].

#include "disc.hpp"
#include "spring_rate.hpp"

namespace {

struct Corrected : disc::Law {
  static constexpr scree::About about = {
      "disc_corrected", "discs: linear normal force, path-independent tangential spring, integrated",
      "f_n = k δ, or k A/(4 R*), + γ δ'                  A: overlap area; [M6], section II B\n"
      "D_t' = α v·t − R_a ω_a − R_b ω_b                  α = (R_a + R_b)/|x_a − x_b|, 1 at a wall; [M24], [M25]\n"
      "f_t = −α (k_t D_t + γ_t D_t') t                   the spring limited to μ f_n; torques without α; [M30]\n"
      "slip: |D_t| <= μ f_n/k_t                          [M11]\n"
      "α of the end of each step multiplies the displacement of the step, so that a closed path changes D_t by an\n"
      "amount in proportion to the step. Angular momentum is conserved",
      "McNamara et al. 2008, equations 23 to 30"};
};

template <disc::Normal kind>
struct Kernel : disc::Kernel<Corrected, kind> {
  static constexpr bool writes_couple = true;
  static constexpr std::uint32_t reads = disc::Kernel<Corrected, kind>::reads |
                                         scree::reads_tangential_increment | scree::reads_relative_spin |
                                         scree::reads_radii;

  template <int D, class T>
  using History = disc::SpringHistory<T>;

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>& h,
             scree::LawOutput<D, T, true>& out) const {
    const T f_n = this->template normal_force<T>(c, out);
    const auto t = disc::tangent(c.normal);
    const auto rate = tangential::SpringRate<T>::of(c);
    const T spin = c.relative_spin[0];
    const T trial = h.spring + rate(dot(c.tangential_increment, t), T(c.step * spin));
    const T force = this->slide_or_stick_in_plane(trial, rate(dot(c.relative_velocity, t), spin), f_n,
                                                  c.onset_weight, h, out);
    out.force = scree::fused(T(-(rate.stretch * force)), t, out.force);
    out.couple[0] = -rate.offset * force;
  }
};

using disc::Normal;
template <Normal kind>
using Frictionless = disc::Frictionless<Corrected, kind>;

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(Corrected, Frictionless<Normal::overlap>, Frictionless<Normal::area>,
                         Kernel<Normal::overlap>, Kernel<Normal::area>)
