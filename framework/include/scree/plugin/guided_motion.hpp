#pragma once

#include <string>

#include <scree/plugin/boundary.hpp>
#include <scree/plugin/program.hpp>
#include <scree/plugin/wall_motion.hpp>

namespace scree {

// One degree of freedom of a rigid surface, a distance or an angle: at rest, prescribed, or moved by forces
// or torques. Units and names are given for a distance; an angle has rad, N m, kg m² and so on.
struct GuidedMotion {
  // In the order of the choices of `control`, from which a distance has all, an angle the first four.
  enum Control { fixed, displaced, at_velocity, pressed, under_stress, absent };

  int control = -1;
  WallMotion motion;
  Program press;       // P (N)
  Program stress;      // (Pa)
  double area = 0;     // (m²) on which the stress acts
  double inertia = 0;  // (kg) 0: not given

  // Names of the keys, for messages.
  struct Names {
    const char *control, *choices[4], *inertia;  // of choices "fixed" and the keys of the other controls
  };

  bool moves() const { return motion.moves(); }
  bool is_pressed() const { return motion.control == WallMotion::pressed; }

  // Decides what moves it. Returns the problem and a remedy, or "".
  std::string prepare(const Names& names) {
    const bool chosen = control >= 0;
    const bool given[] = {false, motion.displacement.given(), motion.velocity.given(), press.given(),
                          stress.given()};
    int present = 0;
    for (int k = displaced; k <= under_stress; ++k) present += given[k];
    const int last = given[under_stress] ? under_stress : given[pressed] ? pressed : at_velocity;
    if (!chosen && present > 1)
      return std::string("more than one motion is given without ") + names.control + "; say which, such as " +
             names.control + " = \"" + (last == under_stress ? "stress" : names.choices[last]) + '"';
    if (!chosen && inertia > 0 && !given[pressed] && !given[under_stress])
      return std::string(names.inertia) + " is given without " + names.choices[pressed] + "; give " +
             names.choices[pressed] + " = 0 if bodies alone move the surface, or leave it out";
    for (int k = fixed; k <= under_stress && control < 0; ++k)
      if (given[k] || present == 0) control = k;
    if (control != fixed && control != absent && !given[control])
      return std::string(names.control) + " says what is not given; give " +
             (control == under_stress ? "stress" : names.choices[control]);
    if (!chosen && motion.superposed.given() && control < pressed)
      return "a motion is superposed on none by forces; leave it out, or give force, stress or torque";
    if ((control == pressed || control == under_stress) && !(inertia > 0))
      return std::string(names.inertia) + " is missing; give it above 0, since forces move the surface";
    if (control == under_stress && !(area > 0))
      return "stress on a surface whose projected area is not known or 0; give area = <m^2>, or force = <N>";
    constexpr WallMotion::Control kinds[] = {WallMotion::fixed,       WallMotion::displaced,
                                             WallMotion::at_velocity, WallMotion::pressed,
                                             WallMotion::pressed,     WallMotion::fixed};
    motion.control = kinds[control];
    motion.mass = is_pressed() ? inertia : 1;
    return "";
  }

  // Pressing force (N) at a time (s).
  double pressing_force(double time) const {
    if (!is_pressed()) return 0;
    return control == under_stress ? stress(time) * area : press(time);
  }
  double damping_rate() const { return is_pressed() ? motion.viscosity / inertia : 0; }

  // What is kept from call to call.
  struct State {
    double mid_speed, speed, free_speed;  // (m/s)
  };
  // Distance (m) in a step of this duration (s) from a time (s), with the load of the contacts (N).
  double begin(State& state, double load, double time, double step, BoundaryEnergy& energy) const {
    const WallMotion::StepMotion now = motion.begin(state.free_speed, motion.prescribed(time, step),
                                                    {load, pressing_force(time)}, step, energy);
    state = {now.mid_speed, now.speed, now.free_speed};
    return now.distance;
  }
  void finish(State& state, double load, double time, double step, BoundaryEnergy& energy) const {
    const WallMotion::StepMotion now = motion.finish({0, state.mid_speed, state.speed, state.free_speed},
                                                     {load, pressing_force(time + step)}, time, step, energy);
    state = {now.mid_speed, now.speed, now.free_speed};
  }
  // With new parameters, after others, with which the speed was `state`.
  void change(State& state, const GuidedMotion& before, double time, BoundaryEnergy& energy) const {
    const double free = motion.free_speed_after(before.motion, state.speed, state.free_speed);
    const double speed = free + motion.prescribed(time, 0).speed;
    state = {speed, speed, free};
    motion.add_kinetic(free, energy);
  }
};

}  // namespace scree
