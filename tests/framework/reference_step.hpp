#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <scree/particles.hpp>
#include <scree/plugin/abi.h>

// A slow, independent implementation of one step, written from the documentation of the linear law and of the
// integrator: one contact after the other, always in three dimensions (a disc moves in z = 0 and turns about
// z), contact points and their velocities by rigid-body motion. It shares nothing with the kernel but Vec3.

namespace scree::test {

struct ReferenceLaw {
  double k = 0, gamma = 0, k_t = 0, gamma_t = 0, static_friction = 0, dynamic_friction = 0;
  bool tension_cut = false;
};

struct ReferenceContact {
  std::size_t a = 0;
  int b = -1;       // < 0: the plane below
  Vec3 shift = {};  // shift from b to its image that touches a
  Vec3 plane_point = {}, plane_normal = {};
  Vec3 spring = {};
  bool sliding = false;
  double slip = 0;    // of the last step, while sliding (m)
  double margin = 0;  // static limit over k_t less the spring, while sticking (m)
  Vec3 force = {};    // on a
};

class ReferenceStep {
 public:
  ReferenceStep(std::vector<Body> bodies, std::vector<ReferenceContact> contacts, const ReferenceLaw& law)
      : now(bodies), mid(bodies), contacts_(std::move(contacts)), law_(law) {
    evaluate(0);
  }

  void step(double h) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      mid[i].velocity = now[i].velocity + (h / 2 / now[i].mass) * force[i];
      mid[i].spin = now[i].spin + (h / 2 / now[i].inertia) * torque[i];
      now[i].velocity += (h / now[i].mass) * force[i];
      now[i].spin += (h / now[i].inertia) * torque[i];
      mid[i].position = now[i].position + (h / 2) * mid[i].velocity;
      now[i].position += h * mid[i].velocity;
    }
    evaluate(h);
    for (std::size_t i = 0; i < now.size(); ++i) {
      now[i].velocity = mid[i].velocity + (h / 2 / now[i].mass) * force[i];
      now[i].spin = mid[i].spin + (h / 2 / now[i].inertia) * torque[i];
    }
  }

  std::vector<Body> now, mid;
  std::vector<Vec3> force, torque;
  const std::vector<ReferenceContact>& contacts() const { return contacts_; }

 private:
  struct ContactGeometry {
    double overlap;
    Vec3 normal, arm_a, arm_b;  // from the centres to the contact point
    Vec3 velocity;              // of a's contact point relative to b's
  };

  ContactGeometry geometry_of(const std::vector<Body>& bodies, const ReferenceContact& c) const {
    const Body& a = bodies[c.a];
    ContactGeometry m = {};
    if (c.b < 0) {
      m.normal = c.plane_normal;
      m.overlap = a.radius - dot(a.position - c.plane_point, c.plane_normal);
    } else {
      const Vec3 d = a.position - (bodies[std::size_t(c.b)].position + c.shift);
      m.normal = (1 / norm(d)) * d;
      m.overlap = a.radius + bodies[std::size_t(c.b)].radius - norm(d);
    }
    m.arm_a = -(a.radius - m.overlap / 2) * m.normal;
    m.velocity = a.velocity + cross(a.spin, m.arm_a);
    if (c.b >= 0) {
      const Body& b = bodies[std::size_t(c.b)];
      m.arm_b = (b.radius - m.overlap / 2) * m.normal;
      m.velocity -= b.velocity + cross(b.spin, m.arm_b);
    }
    return m;
  }

  static Vec3 in_plane(const Vec3& v, const Vec3& n) { return cross(n, cross(v, n)); }

  Vec3 force_of(ReferenceContact& c, const ContactGeometry& m, double h) const {
    if (m.overlap <= 0) {
      c.spring = {};
      c.sliding = false;
      c.slip = c.margin = 0;
      return {};
    }
    // Onset weight of a dashpot over the first two steps: 3s/2, then 2 − s/2, then 1; and likewise at the
    // end, unless tension is cut.
    const double closing = -dot(m.velocity, m.normal), travel = std::abs(closing) * h;
    const double s = m.overlap < 2 * travel ? m.overlap / travel : 2;
    const double share = law_.tension_cut && closing < 0 ? 1 : s < 1 ? 1.5 * s : 2 - 0.5 * s;
    double normal_force = law_.k * m.overlap + share * law_.gamma * closing;
    const double pressing = std::max(normal_force, 0.0);
    if (law_.tension_cut) normal_force = pressing;
    if (law_.static_friction == 0) return normal_force * m.normal;

    const ContactGeometry halfway = geometry_of(mid, c);
    const double touched = m.overlap < closing * h ? m.overlap / (closing * h) : 1;
    const Vec3 moved = (h * touched) * in_plane(halfway.velocity, halfway.normal);
    const Vec3 spring = in_plane(c.spring + moved, m.normal);
    const Vec3 dashpot = (share * law_.gamma_t) * in_plane(m.velocity, m.normal);
    const Vec3 v_t = in_plane(m.velocity, m.normal);
    if (law_.dynamic_friction < law_.static_friction)
      return normal_force * m.normal +
             falling(c, in_plane(c.spring, m.normal), spring, dashpot, v_t, pressing, h);
    return normal_force * m.normal + slipped(c, spring, law_.static_friction * pressing,
                                             law_.static_friction * pressing, dashpot, v_t, h);
  }

  static Vec3 limited(const Vec3& f, double limit) { return norm(f) > limit ? (limit / norm(f)) * f : f; }

  // The spring slips where it is beyond `holding`, to `limit`. Returns the tangential force.
  Vec3 slipped(ReferenceContact& c, const Vec3& spring, double holding, double limit, const Vec3& dashpot,
               const Vec3& v_t, double h) const {
    c.sliding = law_.k_t * norm(spring) > holding;
    c.spring = spring;
    if (!c.sliding) return -limited(law_.k_t * spring + dashpot, holding);
    // The spring turns towards the slip direction within the step.
    const double excess = std::pow(norm(spring) * law_.k_t / limit, 2);
    const Vec3 towards = spring + (0.25 * h * (excess - 1)) * v_t;
    c.spring = (limit / law_.k_t / norm(towards)) * towards;
    const Vec3 whole = towards + (0.5 * (1 + excess) / law_.k_t) * dashpot;
    const double size = limit / norm(towards) * norm(whole);
    return -(std::min(size, limit) / norm(whole)) * whole;
  }

  // Where slip begins, at a moment within the step, the spring falls to the dynamic limit, and the force of
  // this step makes up for the moment; where slip ends, for that at which the limit of the sum rises to the
  // static one.
  Vec3 falling(ReferenceContact& c, const Vec3& before, const Vec3& trial, const Vec3& dashpot,
               const Vec3& v_t, double pressing, double h) const {
    const double k = law_.k_t, still = law_.static_friction * pressing,
                 moving = law_.dynamic_friction * pressing;
    const double share = law_.dynamic_friction / law_.static_friction, old = norm(before);
    const double beyond = norm(trial) - still / k;
    const bool slid = c.sliding, begins = !slid && beyond > 0;
    const double theta = begins ? c.margin / (c.margin + beyond) : 0;
    const double first = k * (old + c.margin), then = first + theta * (still - first);
    const Vec3 met = before + theta * (trial - before);
    const Vec3 along = begins && norm(met) > 0 ? (1 / norm(met)) * met : Vec3{};
    const Vec3 fallen = trial - ((1 - share) * then / k) * along;
    Vec3 tangential = slipped(c, fallen, slid || begins ? moving : still, moving, dashpot, v_t, h);
    const double slip = norm(fallen) - moving / k;
    if (!c.sliding) {
      const Vec3 whole = k * c.spring + dashpot;
      const double late = slid && h > 0 ? slip / (slip - c.slip) : 0;
      tangential = -limited(whole, still) - late * (limited(whole, still) - limited(whole, moving));
    }
    if (begins && h > 0)
      tangential +=
          (0.5 - theta) * (limited(then * along + dashpot, then) -
                           limited(share * then * along + dashpot, c.sliding ? share * then : then));
    c.slip = slip;
    c.margin = c.sliding ? 0 : still / k - norm(c.spring);
    return tangential;
  }

  void evaluate(double h) {
    force.assign(now.size(), {});
    torque.assign(now.size(), {});
    for (ReferenceContact& c : contacts_) {
      const ContactGeometry m = geometry_of(now, c);
      c.force = force_of(c, m, h);
      force[c.a] += c.force;
      torque[c.a] += cross(m.arm_a, c.force);
      if (c.b < 0) continue;
      force[std::size_t(c.b)] -= c.force;
      torque[std::size_t(c.b)] -= cross(m.arm_b, c.force);
    }
  }

  std::vector<ReferenceContact> contacts_;
  ReferenceLaw law_;
};

}  // namespace scree::test
