#pragma once

#include <scree/plugin/boundary.hpp>
#include <scree/plugin/load_control.hpp>
#include <scree/plugin/program.hpp>

namespace scree {

// Motion of one wall along one direction, such as its normal: x = s + d.
//
//   pressed:  m s" = F + P − γ s',  d: the superposed displacement, if any
//   servo:    each step tries several displacements s and takes the one with −F nearest to P
//   massless: F + P = 0             s' is limited in both
//   others:   s is constant,        d: from a displacement, a velocity or, by the caller, a strain rate
//
// F is the load of the contacts along the direction, P the pressing force. Only increments of d count, so
// that the wall moves on from where it is. Energy: ½ m s'² is kinetic, P s' − F d' the power of work, γ s'²
// is dissipated. Velocity Verlet, implicit in the viscosity; a constant force is exact. Servo and massless
// walls do the work −F x', and their speed at the end of a step is displacement / step: a first-order error
// where contacts are damped.
struct WallMotion {
  // pressed: what users call control = "stress" or "force".
  enum Control { pressed, fixed, displaced, at_velocity, strained, servo, massless };

  int control = fixed;
  double mass = 1;       // m (kg)
  double viscosity = 0;  // γ (kg/s)
  Program displacement;  // (m) if displaced
  Program velocity;      // (m/s) if at_velocity
  Program superposed;    // (m) added to s if forces move the wall

  // d in a step (m), and d' at its end (m/s).
  struct Prescribed {
    double distance = 0;
    double speed = 0;
  };
  // Along the direction (N); press is 0 unless forces move the wall.
  struct Forces {
    double load;
    double press;
  };
  // x and s in a step: distance (m), mean speed, speed at the end, s' at the end (m/s).
  struct StepMotion {
    double distance;
    double mid_speed;
    double speed;
    double free_speed;
  };

  bool moves() const { return control != fixed; }
  // Whether each step seeks the displacement with the wanted load, by `begin_by_load`.
  bool seeks_load() const { return control == servo || control == massless; }
  // Largest speed of the displacements x for which it asks the load (m/s); a superposed motion is assumed to
  // be no faster than the limit of s'.
  double displacement_speed(const LoadControl& limits) const {
    return seeks_load() ? (superposed.given() ? 2 : 1) * limits.speed_limit : 0;
  }
  bool moved_by_forces() const { return control == pressed || seeks_load(); }
  // Whether s' must be kept between steps, because it is not the speed of the wall.
  bool superposes() const { return control == pressed && superposed.given(); }

  // What programs prescribe for the step from `time`; with step 0, the speed at that time. Not for
  // `strained`.
  Prescribed prescribed(double time, double step) const {
    if (control == displaced) return increment(displacement, time, step);
    if (control == at_velocity) return {step * mean(velocity, time, step), velocity(time + step)};
    if (moved_by_forces() && superposed.given()) return increment(superposed, time, step);
    return {};
  }

  // First half of a step, with s' and the forces at its start.
  StepMotion begin(double free_speed, const Prescribed& p, const Forces& forces, double step,
                   BoundaryEnergy& energy) const {
    energy.work -= 0.5 * forces.load * p.distance;
    if (control != pressed) return {p.distance, p.distance / step, p.speed, 0};
    const double change = step * (forces.load + forces.press - viscosity * free_speed) / mass;
    const double mid = free_speed + 0.5 * change, end = free_speed + change;
    energy.work += 0.5 * step * forces.press * mid;
    if (!superposes()) return {step * mid, mid, end, end};
    return {step * mid + p.distance, mid + p.distance / step, end + p.speed, end};
  }

  // First half of a step of a wall that seeks a load. forces: load at the start, pressing force at the end of
  // the step; load(x): load at the end after a displacement x (m); mid_speed: of the last step, stiffness: of
  // the contacts (N/m), kept from one step to the next.
  template <class Load>
  StepMotion begin_by_load(const LoadControl& limits, double mid_speed, double& stiffness,
                           const Prescribed& p, const Forces& forces, double step, const Load& load,
                           BoundaryEnergy& energy) const {
    const auto excess = [&](double s) { return -load(s + p.distance) - forces.press; };
    const double guess = step * mid_speed - p.distance;
    const double s = limits.displacement(excess, guess, step, forces.press, control == servo, stiffness);
    const double distance = s + p.distance;
    energy.work -= 0.5 * forces.load * distance;
    return {distance, distance / step, distance / step, s / step};
  }

  // Second half of the step that began at `time`, with the mean speed from `begin` and the forces at its end.
  // Returns the motion with speeds at the end; `distance` is 0.
  StepMotion finish(const StepMotion& begun, const Forces& forces, double time, double step,
                    BoundaryEnergy& energy) const {
    if (control != pressed) {
      energy.work -= 0.5 * forces.load * step * begun.mid_speed;
      return {0, begun.mid_speed, begun.speed, 0};
    }
    const Prescribed p = prescribed(time, step);
    const double mid = superposes() ? begun.mid_speed - p.distance / step : begun.mid_speed;
    const double end =
        (mid + 0.5 * step * (forces.load + forces.press) / mass) / (1 + 0.5 * step * viscosity / mass);
    energy.work += 0.5 * (step * forces.press * mid - forces.load * p.distance);
    energy.dissipated += viscosity * mid * mid * step;
    add_kinetic(end, energy);
    return {0, begun.mid_speed, superposes() ? end + p.speed : end, end};
  }

  // After a change of parameters: s' stays as before, or, if the wall was not pressed, the wall's speed.
  double free_speed_after(const WallMotion& before, double speed, double free_speed) const {
    if (control != pressed) return 0;
    return before.control == pressed ? free_speed : speed;
  }

  // The equation of small motions along a direction, with what programs prescribe and the pressing force (N)
  // now.
  LinearWall linear(const Vec3& direction, const Prescribed& now, double pressing_force) const {
    if (!moved_by_forces()) return {.direction = direction, .speed = now.speed};
    LinearWall wall = {
        .free = 1, .direction = direction, .pressing_force = pressing_force, .speed = now.speed};
    if (!seeks_load()) wall.mass = mass, wall.viscosity = viscosity;
    return wall;
  }

  void add_kinetic(double free_speed, BoundaryEnergy& energy) const {
    if (control == pressed) energy.kinetic += 0.5 * mass * free_speed * free_speed;
  }

  // Mean of a program over a step by Simpson's rule: exact up to cubic polynomials.
  static double mean(const Program& program, double time, double step) {
    return (program(time) + 4 * program(time + 0.5 * step) + program(time + step)) / 6;
  }

 private:
  static Prescribed increment(const Program& program, double time, double step) {
    return {program(time + step) - program(time), program.rate(time + step)};
  }
};

}  // namespace scree
