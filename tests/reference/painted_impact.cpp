#include "painted_impact.hpp"

#include "arc.hpp"
#include "coefficients.hpp"

#include <algorithm>
#include <array>

namespace reference {

namespace {

constexpr double longest_arc = 0.1;  // (rad) from the contact to a point; both are painted anew beyond

// One row of vectors for the integration.
namespace row {
enum Row { x_a, x_b, v_a, v_b, w_a, w_b, point_a, point_b, impulse, dissipated, rows };
}
using Rows = std::array<Vector, row::rows>;

Rows sum(const Rows& y, double h, const Rows& rate) {
  Rows s;
  for (std::size_t i = 0; i < s.size(); ++i) s[i] = y[i] + h * rate[i];
  return s;
}

struct Elongation {
  Vector a, b;  // shares of both bodies; point_b of a wall is the second share itself
  Vector whole() const { return a + b; }
};

class Pair {
 public:
  explicit Pair(const Impact& touching)
      : a_(touching.a),
        wall_(std::holds_alternative<Wall>(touching.other)),
        b_(wall_ ? Body{} : std::get<Body>(touching.other)),
        plane_(wall_ ? direction(std::get<Wall>(touching.other).normal) : Vector{}),
        point_(wall_ ? std::get<Wall>(touching.other).point : Vector{}),
        mass_(wall_ ? a_.mass : a_.mass * b_.mass / (a_.mass + b_.mass)),
        law_(touching.law, mass_, wall_ ? a_.radius : a_.radius * b_.radius / (a_.radius + b_.radius)) {}

  Rows start() const {
    Rows y = {};
    y[row::x_a] = a_.position, y[row::v_a] = a_.velocity, y[row::w_a] = a_.spin;
    y[row::x_b] = wall_ ? point_ : b_.position, y[row::v_b] = b_.velocity, y[row::w_b] = b_.spin;
    const Vector n = normal(y);
    y[row::point_a] = -n;
    if (!wall_) y[row::point_b] = n;
    return y;
  }

  double overlap(const Rows& y) const {
    const Vector apart = y[row::x_a] - y[row::x_b];
    return a_.radius + b_.radius - (wall_ ? dot(apart, plane_) : norm(apart));
  }
  double duration() const { return law_.duration(-dot(a_.velocity - b_.velocity, normal(start()))); }

  // One step: the motion with the points fixed to the bodies, then their slip.
  Rows advanced(const Rows& y, double h) const {
    const Rows k1 = rates(y), k2 = rates(sum(y, 0.5 * h, k1)), k3 = rates(sum(y, 0.5 * h, k2)),
               k4 = rates(sum(y, h, k3));
    Rows next = sum(sum(sum(sum(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
    next[row::point_a] = direction(next[row::point_a]);
    if (!wall_) next[row::point_b] = direction(next[row::point_b]);
    const Vector before = stiffness(y) * elongation(y).whole(), trial = elongation(next).whole();
    slip(next);
    const Vector left = elongation(next).whole();
    next[row::dissipated].z += 0.5 * dot(before + stiffness(next) * left, trial - left);
    paint_far_points_anew(next);
    const Vector kept = elongation(next).whole();
    next[row::dissipated].z += 0.5 * stiffness(next) * (dot(left, left) - dot(kept, kept));
    return next;
  }

  Outcome outcome(const Rows& y, double time) const {
    Outcome result;
    result.touched = true;
    result.contact_time = time;
    result.a = a_;
    result.a.position = y[row::x_a], result.a.velocity = y[row::v_a], result.a.spin = y[row::w_a];
    if (!wall_) {
      Body b = b_;
      b.position = y[row::x_b], b.velocity = y[row::v_b], b.spin = y[row::w_b];
      result.other = b;
    }
    result.tangential_impulse = y[row::impulse];
    const Vector spring = elongation(y).whole();
    result.remaining_elastic = 0.5 * stiffness(y) * dot(spring, spring);
    result.dissipated = {y[row::dissipated].x, y[row::dissipated].y, y[row::dissipated].z,
                         result.remaining_elastic};
    return result;
  }

 private:
  Vector normal(const Rows& y) const { return wall_ ? plane_ : direction(y[row::x_a] - y[row::x_b]); }
  double stiffness(const Rows& y) const { return law_.tangential_stiffness(std::max(overlap(y), 0.0)); }
  Elongation elongation(const Rows& y) const {
    const Vector n = normal(y);
    const Vector a = a_.radius * Arc(-n, y[row::point_a]).vector;
    return {a, wall_ ? y[row::point_b] : -b_.radius * Arc(n, y[row::point_b]).vector};
  }
  void place(Rows& y, const Elongation& e) const {
    const Vector n = normal(y);
    y[row::point_a] = end_of_arc(-n, (1 / a_.radius) * e.a);
    y[row::point_b] = wall_ ? e.b : end_of_arc(n, (-1 / b_.radius) * e.b);
  }

  // Normal force of the law, without that of the spring.
  double law_force(const Rows& y) const {
    const double depth = std::max(overlap(y), 0.0);
    const double force =
        law_.elastic_force(depth) - law_.normal_damping(depth) * dot(y[row::v_a] - y[row::v_b], normal(y));
    return law_.law().tension == Tension::cut ? std::max(force, 0.0) : force;
  }
  double limit(const Rows& y) const { return law_.law().friction * std::max(law_force(y), 0.0); }

  void slip(Rows& y) const {
    const Elongation e = elongation(y);
    const double k = stiffness(y), longest = limit(y), pull = k * norm(e.whole());
    if (pull <= longest) return;
    const Vector half = (0.5 * (1 - longest / pull)) * e.whole();
    place(y, {e.a - half, e.b - half});
  }

  // Half of the spring for each point. Across the direction from one to the other arcs φ have stretched it by
  // the mean of φ/sin φ, which is taken back.
  void paint_far_points_anew(Rows& y) const {
    const Elongation e = elongation(y);
    const double arc_b = wall_ ? 0 : norm(e.b) / b_.radius;
    if (std::max(norm(e.a) / a_.radius, arc_b) <= longest_arc) return;
    const Vector apart = e.a - e.b, along = dot(e.whole(), direction(apart)) * direction(apart);
    const auto stretch = [&](double radius) {
      const double arc = 0.5 * norm(apart) / radius;
      return stretching(std::sin(arc), std::cos(arc)).value;
    };
    const double stretched = 0.5 * (stretch(a_.radius) + (wall_ ? 1 : stretch(b_.radius)));
    const Vector half = 0.5 * (along + (1 / stretched) * (e.whole() - along));
    place(y, {half, half});
  }

  // ξ' while both points are at the contact.
  Vector spring_velocity(const Rows& y) const {
    const Vector n = normal(y), moving = y[row::v_a] - y[row::v_b], along = moving - dot(moving, n) * n;
    const double lever = wall_ ? 1 : (a_.radius + b_.radius) / norm(y[row::x_a] - y[row::x_b]);
    return lever * along - cross(a_.radius * y[row::w_a] + b_.radius * y[row::w_b], n);
  }

  Rows rates(Rows y) const {
    slip(y);
    const Vector n = normal(y), spring = elongation(y).whole(), drift = spring_velocity(y);
    const double depth = std::max(overlap(y), 0.0), k = law_.tangential_stiffness(depth);
    const Vector wanted = k * spring + law_.tangential_damping(depth) * drift;
    const double longest = limit(y), size = norm(wanted);
    const Vector dashpot = std::min(1.0, size > 0 ? longest / size : 1.0) * wanted - k * spring;

    Rows rate = {};
    const double push =
        law_force(y) +
        (law_.hertz() ? 0.5 * law_.tangential_stiffness_slope(depth) * dot(spring, spring) : 0);
    const Vector across = tangential_force(y, k * spring, dashpot), force = push * n + across;
    const double speed = dot(y[row::v_a] - y[row::v_b], n);
    rate[row::x_a] = y[row::v_a], rate[row::v_a] = (1 / a_.mass) * force;
    if (!wall_) rate[row::x_b] = y[row::v_b], rate[row::v_b] = (-1 / b_.mass) * force;
    put_turning(rate, y, k * spring, dashpot);
    rate[row::impulse] = across;
    rate[row::dissipated] = {(law_.elastic_force(depth) - law_force(y)) * speed, dot(dashpot, drift), 0};
    return rate;
  }

  // −∂V/∂x_a, V: energy of the spring; and the dashpot, as a tension between points at the contact.
  Vector tangential_force(const Rows& y, const Vector& tension, const Vector& dashpot) const {
    const Vector n = normal(y);
    if (wall_) return -(tension + dashpot);
    const double distance = norm(y[row::x_a] - y[row::x_b]), reach = a_.radius + b_.radius;
    const Vector by_normal = -a_.radius * Arc(-n, y[row::point_a]).gradient_at_begin(tension) -
                             b_.radius * Arc(n, y[row::point_b]).gradient_at_begin(tension);
    return (-1 / distance) * (by_normal - dot(by_normal, n) * n + reach * dashpot);
  }

  // Torques −∂V/∂θ and those of the dashpot; and the points, which turn with the bodies.
  void put_turning(Rows& rate, const Rows& y, const Vector& tension, const Vector& dashpot) const {
    const Vector n = normal(y), &A = y[row::point_a], &B = y[row::point_b];
    const Vector torque_a =
        -a_.radius * cross(A, Arc(-n, A).gradient_at_end(tension)) + a_.radius * cross(n, dashpot);
    rate[row::w_a] = (1 / a_.inertia()) * torque_a;
    rate[row::point_a] = cross(y[row::w_a], A);
    if (wall_) {
      rate[row::point_b] = y[row::v_a] - dot(y[row::v_a], n) * n;
      return;
    }
    const Vector torque_b =
        b_.radius * cross(B, Arc(n, B).gradient_at_end(tension)) + b_.radius * cross(n, dashpot);
    rate[row::w_b] = (1 / b_.inertia()) * torque_b;
    rate[row::point_b] = cross(y[row::w_b], B);
  }

  Body a_;
  bool wall_;
  Body b_;  // of a wall radius 0
  Vector plane_, point_;
  double mass_;
  Coefficients law_;
};

}  // namespace

Outcome integrate_painted(const Impact& touching, int steps) {
  const Pair pair(touching);
  const double h = pair.duration() / steps;
  Rows y = pair.start(), next = pair.advanced(y, h);
  double time = 0;
  for (; pair.overlap(next) > 0; time += h) y = next, next = pair.advanced(y, h);
  double low = 0, high = 1;  // of the last step
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (pair.overlap(pair.advanced(y, middle * h)) > 0 ? low : high) = middle;
  }
  return pair.outcome(pair.advanced(y, high * h), time + high * h);
}

}  // namespace reference
