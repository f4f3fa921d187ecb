#include "motion.hpp"

#include <algorithm>

namespace reference {

namespace {

double effective(double a, double b, bool wall) { return wall ? a : a * b / (a + b); }

const Body& second(const Impact& impact) {
  static const Body none;
  const Body* body = std::get_if<Body>(&impact.other);
  return body ? *body : none;
}

}  // namespace

Motion::Motion(const Impact& touching)
    : a_(touching.a),
      b_(second(touching)),
      wall_(std::holds_alternative<Wall>(touching.other)),
      plane_(wall_ ? std::get<Wall>(touching.other) : Wall{}),
      effective_mass_(effective(a_.mass, b_.mass, wall_)),
      coefficients_(touching.law, effective_mass_, effective(a_.radius, b_.radius, wall_)) {}

State Motion::start() const {
  State state{};
  put(state, at::velocity_a, a_.velocity);
  put(state, at::spin_a, a_.spin);
  if (!wall_) {
    put(state, at::velocity_b, b_.velocity);
    put(state, at::spin_b, b_.spin);
  }
  return state;
}

Body Motion::body_a(const State& state) const {
  Body body = a_;
  body.position = a_.position + get(state, at::displacement_a);
  body.velocity = get(state, at::velocity_a);
  body.spin = get(state, at::spin_a);
  return body;
}

std::variant<Body, Wall> Motion::other(const State& state) const {
  if (wall_) return plane_;
  Body body = b_;
  body.position = b_.position + get(state, at::displacement_b);
  body.velocity = get(state, at::velocity_b);
  body.spin = get(state, at::spin_b);
  return body;
}

double Motion::kinetic_energy(const State& state) const {
  const Vector v_a = get(state, at::velocity_a), w_a = get(state, at::spin_a);
  const double a = a_.mass * dot(v_a, v_a) + a_.inertia() * dot(w_a, w_a);
  if (wall_) return 0.5 * a;
  const Vector v_b = get(state, at::velocity_b), w_b = get(state, at::spin_b);
  return 0.5 * (a + b_.mass * dot(v_b, v_b) + b_.inertia() * dot(w_b, w_b));
}

double Motion::balance(const State& state, const Branch& branch) const {
  const Instant now = instant(state, branch);
  const double elastic = coefficients_.elastic_energy(now.overlap) + 0.5 * dot(now.spring_force, now.stretch);
  return kinetic_energy(state) + elastic + state[at::normal] + state[at::tangential] + state[at::friction] +
         state[at::release] - state[at::created];
}

void Motion::set_geometry(Instant& now, const State& state) const {
  now.overlap = std::max(state[at::overlap], 0.0);
  now.arm_a = a_.radius - 0.5 * now.overlap;
  now.arm_b = wall_ ? 0 : b_.radius - 0.5 * now.overlap;
  now.centre_velocity = get(state, at::velocity_a) - get(state, at::velocity_b);
  if (wall_) {
    now.normal = direction(plane_.normal);
  } else {
    const Vector centres =
        (a_.position - b_.position) + (get(state, at::displacement_a) - get(state, at::displacement_b));
    now.distance = norm(centres);
    now.normal = (1 / now.distance) * centres;
  }
  const Vector& n = now.normal;
  now.normal_velocity = dot(now.centre_velocity, n);
  const Vector sideways = now.centre_velocity - now.normal_velocity * n;
  if (!wall_) now.normal_rate = (1 / now.distance) * sideways;
  const Vector turning = now.arm_a * get(state, at::spin_a) + now.arm_b * get(state, at::spin_b);
  now.tangential_velocity = sideways - cross(turning, n);
}

void Motion::set_normal_force(Instant& now, const Branch& branch) const {
  const double dashpot = -coefficients_.normal_damping(now.overlap) * now.normal_velocity;
  now.elastic_force = coefficients_.elastic_force(now.overlap);
  now.law_force = now.elastic_force + dashpot;
  now.cut_force = branch.pushing || law().tension == Tension::allowed ? now.law_force : 0;
  now.limit = branch.pushing ? friction(branch.grip) * now.law_force : 0;
  if (branch.pushing && std::isinf(law().friction)) now.limit = law().friction;
}

void Motion::set_spring(Instant& now, const State& state, const Branch& branch) const {
  const double overlap_rate = -now.normal_velocity;
  now.stiffness = coefficients_.tangential_stiffness(now.overlap);
  now.stiffness_rate = coefficients_.tangential_stiffness_slope(now.overlap) * overlap_rate;
  now.damping = coefficients_.tangential_damping(now.overlap);
  if (coefficients_.hertz() && law().history == History::rescaled && branch.growing && now.overlap > 0)
    now.let_go = now.stiffness_rate / now.stiffness;
  if (branch.grip == Grip::stick) {
    const Vector stretch = get(state, at::spring);
    now.stretch = stretch - dot(stretch, now.normal) * now.normal;
    now.spring_force = now.stiffness * now.stretch;
    return;
  }
  if (branch.grip == Grip::slide) {
    const Vector along = get(state, at::spring);
    now.slide_direction = direction(along - dot(along, now.normal) * now.normal);
  }
  now.spring_force = now.limit * now.slide_direction;
  if (total_rule()) now.spring_force = now.spring_force - now.damping * now.tangential_velocity;
  if (now.stiffness > 0) now.stretch = (1 / now.stiffness) * now.spring_force;
}

void Motion::set_tangential_force(Instant& now, const Branch& branch) const {
  const Vector whole = now.spring_force + now.damping * now.tangential_velocity;
  now.normal_force = now.cut_force;
  if (branch.grip == Grip::open) return;
  if (total_rule() && branch.grip != Grip::stick)
    now.tangential_force = -(now.limit * now.slide_direction);
  else if (branch.clipped)
    now.tangential_force = -(now.limit * direction(whole));
  else
    now.tangential_force = -whole;
  if (law().history == History::potential && coefficients_.hertz() && now.overlap > 0)
    now.normal_force +=
        0.5 * coefficients_.tangential_stiffness_slope(now.overlap) * dot(now.stretch, now.stretch);
}

void Motion::set_accelerations(Instant& now, const State& state, const Branch& branch) const {
  const Vector& n = now.normal;
  const Vector acceleration = (1 / effective_mass_) * (now.normal_force * n + now.tangential_force);
  const double normal_acceleration = dot(acceleration, n) + dot(now.centre_velocity, now.normal_rate);
  const double damping = coefficients_.normal_damping(now.overlap);
  const double slope = coefficients_.elastic_force_slope(now.overlap) -
                       coefficients_.normal_damping_slope(now.overlap) * now.normal_velocity;
  if (branch.pushing && std::isfinite(now.limit))
    now.limit_rate = friction(branch.grip) * (-slope * now.normal_velocity - damping * normal_acceleration);

  // The derivative of v = w - (arm_a ω_a + arm_b ω_b) × n, in the tangent plane that turns.
  const double arm_rate = 0.5 * now.normal_velocity;
  const Vector torque =
      -cross(n, now.tangential_force);  // for an arm of length one; the same for both bodies
  Vector turning = now.arm_a * get(state, at::spin_a) + now.arm_b * get(state, at::spin_b);
  Vector turning_rate = arm_rate * get(state, at::spin_a) + (now.arm_a * now.arm_a / a_.inertia()) * torque;
  if (!wall_)
    turning_rate =
        turning_rate + arm_rate * get(state, at::spin_b) + (now.arm_b * now.arm_b / b_.inertia()) * torque;
  const Vector rate = acceleration - cross(turning_rate, n) - cross(turning, now.normal_rate);
  now.tangential_acceleration = rate - dot(rate, n) * n - now.normal_velocity * now.normal_rate;
}

// spring: dq/dt of q = C d with ξ' = v_t - σ d - ξ let_go;  total: that of k_t ξ = C d - γ_t v_t.
void Motion::set_slip(Instant& now, const Branch& branch) const {
  if (branch.grip == Grip::open || now.stiffness == 0 || !std::isfinite(now.limit)) return;
  if (branch.grip == Grip::stick)
    now.slide_direction =
        direction(total_rule() ? now.spring_force + now.damping * now.tangential_velocity : now.spring_force);
  const double along = dot(now.tangential_velocity, now.slide_direction);
  const double drift = total_rule() ? now.damping * dot(now.tangential_acceleration, now.slide_direction)
                                    : (now.stiffness_rate / now.stiffness - now.let_go) * now.limit;
  now.slip_speed = along + (drift - now.limit_rate) / now.stiffness;
}

Instant Motion::instant(const State& state, const Branch& branch) const {
  Instant now;
  set_geometry(now, state);
  set_normal_force(now, branch);
  if (branch.grip == Grip::relaxed) {
    now.slide_direction = direction(now.tangential_velocity);
    set_forces(now, state, branch);
    now.slide_direction = relaxed_direction(now);
  }
  set_forces(now, state, branch);
  set_slip(now, branch);
  return now;
}

void Motion::set_forces(Instant& now, const State& state, const Branch& branch) const {
  set_spring(now, state, branch);
  set_tangential_force(now, branch);
  set_accelerations(now, state, branch);
}

// Where the direction follows its pull at once but for a lag of first order: C ḋ = part of k_t v_t
// perpendicular to d.
Vector Motion::relaxed_direction(const Instant& now) const {
  const Vector& v_t = now.tangential_velocity;
  if (total_rule()) return direction(now.stiffness * v_t + now.damping * now.tangential_acceleration);
  const double square = dot(v_t, v_t);
  if (square == 0 || now.stiffness == 0) return now.slide_direction;
  const Vector turning = now.tangential_acceleration - (dot(now.tangential_acceleration, v_t) / square) * v_t;
  return direction(v_t - (now.limit / (now.stiffness * std::sqrt(square))) * turning);
}

// The derivative of the stretch (stick) or of the direction (slide), carried along with the tangent plane.
Vector Motion::spring_rate(const Instant& now, const State& state, const Branch& branch) const {
  const Vector held = get(state, at::spring);
  const Vector carried = -(dot(now.normal_rate, held) * now.normal);
  if (branch.grip == Grip::stick) return now.tangential_velocity - now.let_go * now.stretch + carried;
  if (branch.grip != Grip::slide) return {};
  // C ḋ = part of k_t v_t (total: k_t v_t + γ_t v̇_t) perpendicular to d
  Vector pull = now.stiffness * now.tangential_velocity;
  if (total_rule()) pull = pull + now.damping * now.tangential_acceleration;
  const Vector across = pull - dot(pull, now.slide_direction) * now.slide_direction;
  return (1 / std::max(now.limit, lowest_limit_)) * across + carried;
}

void Motion::put_energy_rates(State& rates, const Instant& now, const Branch& branch) const {
  const Vector& v_t = now.tangential_velocity;
  rates[at::normal] = (now.elastic_force - now.cut_force) * now.normal_velocity;
  rates[at::tangential] = -dot(now.tangential_force + now.spring_force, v_t);
  if (branch.grip == Grip::slide || branch.grip == Grip::relaxed)
    rates[at::friction] = now.slip_speed * dot(now.spring_force, now.slide_direction);
  if (branch.grip == Grip::open && total_rule() && now.stiffness > 0)
    rates[at::friction] =
        dot(now.spring_force, v_t + (now.damping / now.stiffness) * now.tangential_acceleration);
  const double squeeze = 0.5 * now.stiffness_rate * dot(now.stretch, now.stretch);
  if (law().history == History::potential) return;
  if (!branch.growing)
    rates[at::release] = -squeeze;
  else if (law().history == History::rescaled)
    rates[at::release] = squeeze;
  else
    rates[at::created] = squeeze;
}

State Motion::rates(const Instant& now, const State& state, const Branch& branch) const {
  State rates{};
  const Vector force = now.normal_force * now.normal + now.tangential_force;
  const Vector torque = -cross(now.normal, now.tangential_force);
  rates[at::time] = 1;
  rates[at::overlap] = -now.normal_velocity;
  put(rates, at::displacement_a, get(state, at::velocity_a));
  put(rates, at::velocity_a, (1 / a_.mass) * force);
  put(rates, at::spin_a, (now.arm_a / a_.inertia()) * torque);
  if (!wall_) {
    put(rates, at::displacement_b, get(state, at::velocity_b));
    put(rates, at::velocity_b, (-1 / b_.mass) * force);
    put(rates, at::spin_b, (now.arm_b / b_.inertia()) * torque);
  }
  put(rates, at::spring, spring_rate(now, state, branch));
  rates[at::normal_impulse] = now.normal_force;
  put(rates, at::tangential_impulse, now.tangential_force);
  put_energy_rates(rates, now, branch);
  return rates;
}

}  // namespace reference
