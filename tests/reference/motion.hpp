#pragma once

#include "coefficients.hpp"

#include <array>
#include <cstddef>

namespace reference {

// What the motion is made of, as one row of numbers for the integration; see the constants below.
using State = std::array<double, 32>;

namespace at {
inline constexpr std::size_t time = 0, overlap = 1;  // since first touch
// Displacements since first touch: the overlap is a difference of positions that would lose its digits.
inline constexpr std::size_t displacement_a = 2, displacement_b = 5;
inline constexpr std::size_t velocity_a = 8, velocity_b = 11, spin_a = 14, spin_b = 17;
// Its stretch while it sticks; its direction while it slides, where the Coulomb limit tells its stretch.
inline constexpr std::size_t spring = 20;
inline constexpr std::size_t normal_impulse = 23, tangential_impulse = 24;
inline constexpr std::size_t normal = 27, tangential = 28, friction = 29, release = 30, created = 31;
}  // namespace at

inline Vector get(const State& state, std::size_t i) { return {state[i], state[i + 1], state[i + 2]}; }
inline void put(State& state, std::size_t i, const Vector& v) {
  state[i] = v.x;
  state[i + 1] = v.y;
  state[i + 2] = v.z;
}

// relaxed: sliding so far that the direction follows the velocity, which holds under a low Coulomb limit;
// open: without Coulomb limit.
enum class Grip { stick, slide, relaxed, open };

// Which of the smooth branches of the law holds. Each continues smoothly beyond its end, so that a trial step
// may pass it.
struct Branch {
  bool pushing = true;   // the normal force of the law is positive
  bool growing = true;   // the overlap grows
  bool clipped = false;  // spring and dashpot together exceed the Coulomb limit (SlipRule::spring)
  Grip grip = Grip::stick;
};

// All that follows from a state, on a branch.
struct Instant {
  Vector normal, normal_rate;
  double distance = 0;  // of the centres; of a wall infinite
  double arm_a = 0, arm_b = 0;
  double overlap = 0;
  double normal_velocity = 0;
  Vector centre_velocity;      // of a relative to b
  Vector tangential_velocity;  // at the contact point
  Vector tangential_acceleration;

  double elastic_force = 0;
  double law_force = 0;     // the normal force of the law, which may be negative
  double cut_force = 0;     // that without the tension that the law cuts off
  double normal_force = 0;  // the whole, with the push of the spring (History::potential)
  double limit = 0;         // Coulomb's
  double limit_rate = 0;
  double stiffness = 0;  // tangential
  double stiffness_rate = 0;
  double damping = 0;       // tangential
  Vector stretch;           // of the spring
  Vector spring_force;      // stiffness times stretch
  Vector tangential_force;  // on a
  Vector slide_direction;
  double slip_speed = 0;  // along the slide direction; not while it sticks
  double let_go = 0;      // rate at which the stretch is let go, over the stretch
};

// The equations of motion of one contact.
class Motion {
 public:
  // The bodies as they touch first, after which times and displacements are counted.
  explicit Motion(const Impact& touching);

  Instant instant(const State& state, const Branch& branch) const;
  State rates(const Instant& instant, const State& state, const Branch& branch) const;
  double kinetic_energy(const State& state) const;
  // Kinetic, elastic, dissipated, minus created.
  double balance(const State& state, const Branch& branch) const;
  // The bodies of a state.
  Body body_a(const State& state) const;
  std::variant<Body, Wall> other(const State& state) const;

  State start() const;  // at first touch, without spring
  const Law& law() const { return coefficients_.law(); }
  // Coulomb's limit over the normal force.
  double friction(Grip grip) const {
    const bool slides = grip == Grip::slide || grip == Grip::relaxed;
    return slides ? law().dynamic_friction.value_or(law().friction) : law().friction;
  }
  // Without friction there is no spring, whatever the rule.
  bool total_rule() const { return law().slip_rule == SlipRule::total && law().friction > 0; }
  const Coefficients& coefficients() const { return coefficients_; }
  double effective_mass() const { return effective_mass_; }
  // Below this the direction equation of sliding is slowed down, to stay finite where the limit is zero.
  void set_lowest_limit(double limit) { lowest_limit_ = limit; }

 private:
  void set_geometry(Instant& now, const State& state) const;
  void set_normal_force(Instant& now, const Branch& branch) const;
  void set_forces(Instant& now, const State& state, const Branch& branch) const;
  Vector relaxed_direction(const Instant& now) const;
  void set_spring(Instant& now, const State& state, const Branch& branch) const;
  void set_tangential_force(Instant& now, const Branch& branch) const;
  void set_accelerations(Instant& now, const State& state, const Branch& branch) const;
  void set_slip(Instant& now, const Branch& branch) const;
  Vector spring_rate(const Instant& now, const State& state, const Branch& branch) const;
  void put_energy_rates(State& rates, const Instant& now, const Branch& branch) const;
  Body a_, b_;
  bool wall_;
  Wall plane_;
  double effective_mass_;
  Coefficients coefficients_;
  double lowest_limit_ = 0;
};

}  // namespace reference
