#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <scree/plugin/boundary.hpp>
#include <scree/plugin/program.hpp>
#include <scree/plugin/unit_vector.hpp>
#include <scree/plugin/wall_motion.hpp>

namespace scree {

// A rigid motion of surfaces that functions of time prescribe: a velocity along a direction, and a spin about
// an axis through a point, which moves along. Increments over a step are exact for the mean of the functions
// by Simpson's rule. Keys of a boundary:
//
//   scree::PrescribedMotion motion;
//   in declare      motion.declare(d);
//   in prepare      if (const char* problem = motion.check(axis, setup.dimension())) return setup.refuse(problem);
//   in describe     layout.state = motion.state_width; layout.still = !motion.moves();
//   in start        motion.start(s, point);   once frames have their places
//   in change       motion.change(s);
//   in begin_step   motion.begin(s);
//   in finish_step  motion.finish(s);
class PrescribedMotion {
 public:
  // The point through which the axis of the spin goes, as it is now.
  static constexpr std::uint32_t state_width = 3;

  void declare(Declaration& d) {
    d.program("velocity", velocity_, "m/s", any_number, "along the direction").optional();
    d.vector("direction", direction_, "", "of the velocity; without it the axis, or the normal").optional();
    d.program("spin", spin_, "rad/s", any_number, "about spin_axis, counter-clockwise seen from its end")
        .optional();
    d.vector("spin_axis", spin_axis_, "", "without it the axis, or the normal; in 2D z").optional();
    d.vector("spin_point", spin_point_, "m", "through which spin_axis goes; without it `point`").optional();
  }
  // axis: of the shape. Returns the problem and a remedy, or null.
  const char* check(const std::array<double, 3>& axis, int dimension) {
    if (dimension == 2 && velocity_.given() && std::isnan(direction_[0]) && axis[2] != 0)
      return "velocity without direction in a 2D scene; give a direction such as [1, 0, 0]";
    if (std::isnan(direction_[0])) direction_ = axis;
    if (!make_unit(direction_)) return "direction has length 0; give a vector such as [0, 0, 1]";
    if (dimension == 2) spin_axis_ = {0, 0, 1};
    if (std::isnan(spin_axis_[0])) spin_axis_ = axis;
    if (!make_unit(spin_axis_)) return "spin_axis has length 0; give a vector such as [0, 0, 1]";
    if (spin_point_ && !spin_.given()) return "spin_point without spin; give spin = <rad/s>, or leave it out";
    return nullptr;
  }
  bool moves() const { return velocity_.given() || spin_.given(); }

  // point: through which the axis of the spin goes if the scenario does not say.
  void start(const BoundaryStep& s, const Vec3& point) const {
    const Vec3 through = spin_point_ ? vector_of(*spin_point_) : point;
    for (int k = 0; k < 3; ++k) s.state[std::size_t(k)] = through[k];
    change(s);
  }
  // Sets velocities at the time of the step, before the first step with these parameters.
  void change(const BoundaryStep& s) const {
    for (Frame& frame : s.frames) {
      set_velocities(s, s.time, frame);
      frame.mid_velocity = frame.velocity;
      frame.mid_spin = frame.spin;
    }
  }
  void begin(const BoundaryStep& s) const {
    const Vec3 moved = s.step * mean(velocity_, s) * vector_of(direction_);
    const Vec3 turned = s.step * mean(spin_, s) * vector_of(spin_axis_), through = centre(s);
    const Rotation turn = Rotation::by(turned);
    for (Frame& frame : s.frames) {
      const Vec3 arm = frame.position - through, displacement = moved + turn(arm) - arm;
      frame.mid_velocity = 1 / s.step * displacement;
      frame.mid_spin = 1 / s.step * turned;
      frame.position += displacement;
      frame.orientation = turn * frame.orientation;
    }
    for (int k = 0; k < 3; ++k) s.state[std::size_t(k)] += moved[k];
    for (Frame& frame : s.frames) set_velocities(s, s.time + s.step, frame);
    add_work(s);
  }
  void finish(const BoundaryStep& s) const { add_work(s); }

 private:
  static double at(const Program& program, double time) { return program.given() ? program(time) : 0; }
  static double mean(const Program& program, const BoundaryStep& s) {
    return program.given() ? WallMotion::mean(program, s.time, s.step) : 0;
  }
  static Vec3 centre(const BoundaryStep& s) { return {{s.state[0], s.state[1], s.state[2]}}; }
  void set_velocities(const BoundaryStep& s, double time, Frame& frame) const {
    frame.spin = at(spin_, time) * vector_of(spin_axis_);
    frame.velocity =
        at(velocity_, time) * vector_of(direction_) + cross(frame.spin, frame.position - centre(s));
  }
  // Half of the work of a step, with the loads at its start or end.
  static void add_work(const BoundaryStep& s) {
    for (std::size_t k = 0; k < s.frames.size(); ++k) {
      const double power = dot(s.frame_loads[k].force, s.frames[k].mid_velocity) +
                           dot(s.frame_loads[k].torque, s.frames[k].mid_spin);
      s.energy.work -= 0.5 * s.step * power;
    }
  }

  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
  Program velocity_, spin_;
  std::array<double, 3> direction_ = {not_given}, spin_axis_ = {not_given};
  std::optional<std::array<double, 3>> spin_point_;
};

}  // namespace scree
