// Discs with a tangential spring between painted points, after McNamara, García-Rojo, Herrmann (2008),
// [M18]-[M22].

#include "disc.hpp"
#include "spring_rate.hpp"

#include <scree/plugin/polar_angle.hpp>

namespace {

struct Angular : disc::Law {
  static constexpr scree::About about = {
      "disc_angular", "discs: linear normal force, tangential spring between painted points, from angles",
      "f_n = k δ, or k A/(4 R*), + γ δ'                  A: overlap area; [M6], section II B\n"
      "s_a = R_a (Θ − θ_a),  s_b = R_b (Θ − θ_b)         position of the contact on each rim; Θ: direction of the\n"
      "                                                  normal, θ: orientations; at a wall s_b = (x_a − x_w)·t\n"
      "D_t = (s_a − A) + (s_b − B)                       A, B: painted at first touch; [M19]\n"
      "D_roll = ((s_a − A) − (s_b − B))/2                rolling distance, as history column; [M20]\n"
      "f_t = −α (k_t D_t + γ_t D_t') t                   the spring limited to μ f_n; torques without α; [M30]\n"
      "slip: |D_t| <= μ f_n/k_t                          moves A and B alike; [M11]\n"
      "The spring's force is the gradient of ½ k_t D_t², a function of the present configuration and the painted\n"
      "points: closed paths without slip change nothing. Angular momentum is conserved",
      "McNamara et al. 2008, equations 18 to 22 and 30"};
};

template <disc::Normal kind>
struct Kernel : disc::Kernel<Angular, kind> {
  static constexpr bool writes_couple = true;
  static constexpr std::uint32_t reads =
      disc::Kernel<Angular, kind>::reads | scree::reads_tangential_increment | scree::reads_relative_spin |
      scree::reads_radii | scree::reads_orientations | scree::reads_separation;

  template <int D, class T>
  struct History {
    T painted_a, painted_b;  // (m) A, B
    T angle;                 // (rad) Θ in [−π, π]
    T turns;                 // 2π turns + angle has no jumps
    T spring;                // D_t (m)
    T rolling;               // D_roll (m)
    T sliding;               // 1 while the contact slides
    T touched;               // 1 after the first touch
    static constexpr int sliding_column = 6;
    static constexpr std::array<const char*, 8> names = {"painted_a", "painted_b", "angle",   "turns",
                                                         "spring",    "rolling",   "sliding", "touched"};
  };

  template <int D, class T>
  void force(const scree::Contact<D, T, reads>& c, History<D, T>& h,
             scree::LawOutput<D, T, true>& out) const {
    const T f_n = this->template normal_force<T>(c, out);
    const auto t = disc::tangent(c.normal);
    const auto rate = tangential::SpringRate<T>::of(c);
    const T increment = dot(c.tangential_increment, t);
    const scree::Vec<2, T> rim = rims(c, t, h);
    paint(rim, increment, h);
    const T arc_a = rim[0] - h.painted_a, arc_b = rim[1] - h.painted_b, trial = arc_a + arc_b;
    const T force = this->slide_or_stick_in_plane(
        trial, rate(dot(c.relative_velocity, t), c.relative_spin[0]), f_n, c.onset_weight, h, out);
    const T slip = T(0.5) * (trial - h.spring);
    h.painted_a += slip;
    h.painted_b += slip;
    h.rolling = T(0.5) * (arc_a - arc_b);
    out.force = scree::fused(T(-(rate.stretch * force)), t, out.force);
    out.couple[0] = -rate.offset * force;
  }

 private:
  // s_a, s_b (m). Θ crosses ±π at most once a step.
  template <int D, class T>
  scree::Vec<2, T> rims(const scree::Contact<D, T, reads>& c, const scree::Vec<2, T>& t,
                        History<D, T>& h) const {
    constexpr double pi = std::numbers::pi;
    const T angle = scree::polar_angle(c.normal), change = angle - h.angle;
    const T crossed = change > T(pi) ? T(-1) : change < T(-pi) ? T(1) : T(0);
    h.turns = h.touched > T(0) ? h.turns + crossed : T(0);
    h.angle = angle;
    const T direction = scree::fused(T(2 * pi), h.turns, angle);
    const bool wall = c.radius_b == T(0);
    return {{c.radius_a * (direction - c.orientation_a[0]),
             wall ? dot(c.separation, t) : T(c.radius_b * (direction - c.orientation_b[0]))}};
  }

  // At first touch the spring is as long as the pair moved while touching.
  template <class T, class AnyHistory>
  void paint(const scree::Vec<2, T>& rim, const T& increment, AnyHistory& h) const {
    const bool touched = h.touched > T(0);
    h.painted_a = touched ? h.painted_a : rim[0] - T(0.5) * increment;
    h.painted_b = touched ? h.painted_b : rim[1] - T(0.5) * increment;
    h.touched = T(1);
  }
};

using disc::Normal;
template <Normal kind>
using Frictionless = disc::Frictionless<Angular, kind>;

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(Angular, Frictionless<Normal::overlap>, Frictionless<Normal::area>,
                         Kernel<Normal::overlap>, Kernel<Normal::area>)
