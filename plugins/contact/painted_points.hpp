// Tangential spring between a point painted on each of two touching spheres, or on a sphere and a plane or
// surface: its elongation as a function of the present configuration, its generalised forces, and how slip
// moves the points.

#pragma once

#include "spring_rate.hpp"
#include "surface_arc.hpp"

#include <algorithm>

#include <scree/plugin/contact.hpp>
#include <scree/plugin/great_circle.hpp>

namespace tangential {

template <int N, class T>
scree::Vec<N, T> choose(bool condition, const scree::Vec<N, T>& yes, const scree::Vec<N, T>& no) {
  scree::Vec<N, T> chosen;
  for (int k = 0; k < N; ++k) chosen[k] = condition ? yes[k] : no[k];
  return chosen;
}

// Shares of both bodies in the elongation ξ = a + b (m), vectors in the tangent plane.
template <class T>
struct Shares {
  scree::Vec<3, T> a;  // R_a log_C(A), C: direction of the contact from a
  // −R_b log_{−C}(B); of a plane the tangential displacement of a since it was painted; of a surface the arc
  // from B to its nearest point c
  scree::Vec<3, T> b;
  T bend;  // of that arc, see SurfaceArc; else 0
};

// Force on a, the opposite on b, and couple on a in addition to arm × force, the opposite on b.
template <class T>
struct SpringLoads {
  scree::Vec<3, T> force, couple;  // (N), (N m)
};

// History of the points, 0 before the first touch.
template <class T>
struct Points {
  scree::Vec<3, T> a;  // unit vector in the frame of the body
  // likewise; of a plane x_a − x_w when it was painted (m); of a surface B in its frame (m)
  scree::Vec<3, T> b;
};

// The pair in its present configuration. AnyContact reads the normal, the overlap, relative velocity and
// spin, orientations, separation and radii.
template <class T, class AnyContact>
class PaintedPair {
 public:
  // Arc from the contact to a painted point (rad) beyond which both are painted anew: a compromise between
  // closed paths, on which spheres under cyclic loads turn by 0.003 to 0.01 rad, and twist while they roll,
  // which stretches the spring in proportion to the arcs. Less than scree::longest_arc by what a pair may
  // turn in a step.
  static constexpr double arc_limit = 0.1;

  explicit PaintedPair(const AnyContact& c)
      : rate_(SpringRate<T>::of(c)),
        c_(c),
        surface_(c.normal_change, T(1e-9) * c.radius_a),
        wall_(c.at_surface || c.radius_b == T(0)),
        inverse_radius_a_(T(1) / c.radius_a),
        inverse_radius_b_(wall_ ? T(0) : T(1) / c.radius_b) {}

  static bool painted(const Points<T>& points) { return dot(points.a, points.a) > T(0.5); }

  // ξ′ (m/s) of points at the contact.
  scree::Vec<3, T> rate_at_contact() const {
    const auto along = tangential_part(c_.relative_velocity, c_.normal);
    const auto rate = rate_(along, c_.relative_spin, c_.normal);
    return c_.at_surface ? fused(c_.overlap, surface_.turn(centre_velocity(along)), rate) : rate;
  }

  // Of painted points.
  Shares<T> shares(const Points<T>& points) const {
    using scree::arc_between, scree::rotated;
    const auto arc_a = arc_between(-c_.normal, rotated(c_.orientation_a, points.a));
    if (c_.at_surface) {
      const auto b = surface_.between(nearest_point() - rotated(c_.orientation_b, points.b), c_.normal);
      return {c_.radius_a * arc_a, b.arc, b.bend};
    }
    const auto along_wall = tangential_part(c_.separation - points.b, c_.normal);
    const auto arc_b = arc_between(c_.normal, rotated(c_.orientation_b, points.b));
    return {c_.radius_a * arc_a, choose(wall_, along_wall, -c_.radius_b * arc_b), T(0)};
  }

  // Share of a at first touch, of points that were at the contact when it began, from the displacement
  // `moved` (m) of the contact points since then; the rest is that of b. Of points elsewhere, which roll as
  // far with another twist, ξ would err by the first order of the step. ξ' = R_a u_a + R_b u_b with u = n' −
  // ω × n of either body.
  scree::Vec<3, T> first_share_of_a(const scree::Vec<3, T>& moved) const {
    const auto turn = touching_time() * cross(c_.relative_spin, c_.normal);
    if (c_.at_surface) return c_.radius_a * (surface_.turn(fused(c_.radius_a, turn, moved)) - turn);
    const T part = wall_ ? T(0) : c_.radius_a / (c_.radius_a + c_.radius_b);
    const T lever = wall_ ? c_.radius_a : part * c_.radius_b;
    return fused(-lever, turn, part * moved);
  }

  // ξ' in the tangent plane that turns with the mean spin about the normal, where points fixed to the bodies
  // turn about the contact by ± half the relative spin: rate (m/s) of points at the contact, and what the
  // shares of others add.
  scree::Vec<3, T> stretching(const Shares<T>& s, const scree::Vec<3, T>& at_contact) const {
    return fused(half_twist_rate(), cross(c_.normal, s.a - s.b), at_contact);
  }

  // Share of either point painted anew: half of the spring. Arcs φ have stretched it across them by the mean
  // of φ/sin φ; kept, that would grow at every painting of a pair that rolls straight on. With the difference
  // d of the shares, and x the mean of φ²/6, the part of ξ across d is multiplied by 1 − x − x²/2: less than
  // the stretching, by up to 0.022 φ⁴.
  scree::Vec<3, T> painted_anew(const Shares<T>& s) const {
    const auto spring = s.a + s.b, apart = s.a - s.b;
    const T of_b =
        c_.at_surface ? surface_.gaussian_curvature({s.b, s.bend}) : inverse_radius_b_ * inverse_radius_b_;
    const T curvature = T(1.0 / 48) * scree::fused(inverse_radius_a_, inverse_radius_a_, of_b);
    const T square = dot(apart, apart),
            shortening = curvature * scree::fused(T(0.5) * curvature, square, T(1));
    const auto across = fused(square, spring, -dot(apart, spring) * apart);
    return T(0.5) * fused(-shortening, across, spring);
  }

  // Shares after slip (m), half of it from each, at any time of the step: until its end it turned with the
  // bodies.
  Shares<T> slipped(const Shares<T>& s, const scree::Vec<3, T>& slip) const {
    const auto turned = (T(0.5) * c_.step * half_twist_rate()) * cross(c_.normal, slip);
    return {s.a - T(0.5) * (slip + turned), s.b - T(0.5) * (slip - turned), s.bend};
  }

  // Whether a point is farther from the contact than arc_limit.
  bool is_far(const Shares<T>& s) const {
    const T square_b = c_.at_surface ? T(4) * s.bend : square_arc_b(s);
    return std::max(square_arc_a(s), square_b) > T(arc_limit * arc_limit);
  }

  // The points whose shares are the given ones.
  Points<T> points(const Shares<T>& s) const {
    using scree::end_of_arc, scree::rotated_back;
    const auto on_a = end_of_arc(-c_.normal, inverse_radius_a_ * s.a);
    if (c_.at_surface)
      return {rotated_back(c_.orientation_a, on_a), rotated_back(c_.orientation_b, nearest_point() - s.b)};
    const auto on_b = end_of_arc(c_.normal, -inverse_radius_b_ * s.b);
    return {rotated_back(c_.orientation_a, on_a),
            choose(wall_, c_.separation - s.b, rotated_back(c_.orientation_b, on_b))};
  }

  // Tension k ξ + f_d of spring and dashpot (N), as loads: −∂/∂q of ½ k ξ², and −f_d in the directions in
  // which a tension acts while both points are at the contact, so that its power is −f_d·ξ′ with ξ′ of
  // SpringRate. With S = R_a + R_b, X: distance of the centres, κ(φ) = (1 − φ cot φ)/φ² of the arcs φ, m_a =
  // (κ_a/R_a) a, m_b = (κ_b/R_b) b, θ = k ξ·(C × a) = −k ξ·(C × b):
  //   force of the spring  = −(S k ξ − θ C × (m_a − m_b))/X
  //   torque on a          = −R_a C × k ξ − θ (m_a + C), likewise on b; less arm_a C × force it is the
  //   couple               = e C × k ξ − θ ((arm_b m_a + arm_a m_b)/X + C),   arms R − δ/2, e of SpringRate
  // Beside a wall 1/X = 0, S/X = 1, arm_a/X = 0, arm_b/X = 1, m_b = 0; beside a surface, whose normal turns
  // by H dx with the centre, so that c moves by J dx, J = 1 − (R_a − δ) H, there is in addition
  //   force                = −H (δ k ξ − θ C × m_a) − J s θ C × b,   s: SurfaceArcs::shear
  SpringLoads<T> loads(const Shares<T>& s, const T& stiffness, const scree::Vec<3, T>& tension) const {
    const auto contact = -c_.normal;
    const auto bend_a = (scree::arc_shear(square_arc_a(s)) * inverse_radius_a_) * s.a;
    const auto bend_b = (scree::arc_shear(square_arc_b(s)) * inverse_radius_b_) * s.b;
    const T twist = stiffness * dot(s.a + s.b, cross(contact, s.a));
    const T share_a = (c_.radius_a - T(0.5) * c_.overlap) * rate_.inverse_distance, share_b = T(1) - share_a;
    const auto across = (twist * rate_.inverse_distance) * cross(contact, bend_a - bend_b);
    const auto bend = fused(share_a, bend_b, fused(share_b, bend_a, contact));
    const SpringLoads<T> loads = {fused(-rate_.stretch, tension, across),
                                  fused(rate_.offset, cross(contact, tension), -twist * bend)};
    if (!c_.at_surface) return loads;
    const auto by_turning = surface_.turn(fused(-twist, cross(contact, bend_a), c_.overlap * tension));
    const auto sheared = (surface_.shear({s.b, s.bend}) * twist) * cross(contact, s.b);
    const auto more = by_turning + fused(c_.overlap - c_.radius_a, surface_.turn(sheared), sheared);
    return {loads.force - more, fused(arm_beside_wall(), cross(contact, more), loads.couple)};
  }

 private:
  // c, from the origin of the frame of the surface (m).
  scree::Vec<3, T> nearest_point() const { return fused(c_.overlap - c_.radius_a, c_.normal, c_.separation); }
  T arm_beside_wall() const { return c_.radius_a - T(0.5) * c_.overlap; }
  // Of a relative to the wall, from the velocity of the contact points (m/s).
  scree::Vec<3, T> centre_velocity(const scree::Vec<3, T>& of_contact) const {
    return fused(arm_beside_wall(), cross(c_.relative_spin, c_.normal), of_contact);
  }
  T half_twist_rate() const { return T(0.5) * dot(c_.relative_spin, c_.normal); }  // (rad/s)
  // Part of the step during which a pair has touched that did not before (s).
  T touching_time() const {
    const T approach = std::max(-dot(c_.relative_velocity, c_.normal), scree::smallest_divisor<T>);
    return std::min(c_.overlap / approach, c_.step);
  }
  T square_arc_a(const Shares<T>& s) const { return inverse_radius_a_ * inverse_radius_a_ * dot(s.a, s.a); }
  T square_arc_b(const Shares<T>& s) const { return inverse_radius_b_ * inverse_radius_b_ * dot(s.b, s.b); }

  const SpringRate<T> rate_;
  const AnyContact& c_;
  const SurfaceArcs<T> surface_;  // if b is one
  bool wall_;
  T inverse_radius_a_, inverse_radius_b_;  // of a wall 0
};

}  // namespace tangential
