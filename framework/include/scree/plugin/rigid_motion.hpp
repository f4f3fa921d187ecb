#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <scree/plugin/boundary.hpp>
#include <scree/plugin/guided_motion.hpp>
#include <scree/plugin/unit_vector.hpp>

namespace scree {

// A rigid motion of the surfaces of a boundary: along a direction, and about an axis through a point that
// moves along. Each part is at rest, prescribed by a function of time, or moved by forces:
//
//   m s" = F·e + P(t) − γ s'      I φ" = T·a + M(t) − γ' φ'
//
// F, T: force and torque of the contacts, about the point; the centre of mass lies on the axis. Prescribed
// increments are exact for the mean of the functions by Simpson's rule. All surfaces of a boundary move as
// one body. Keys of a boundary:
//
//   scree::RigidMotion motion;
//   in declare      motion.declare(d);
//   in prepare      motion.set_area(area);   of a stress, if it is known
//                   if (const std::string p = motion.prepare({axis, dimension, reach}); !p.empty())
//                     return setup.refuse(p.c_str());
//   in describe     motion.describe(layout);
//   in start        motion.start(s, point);   once frames have their places
//   in change       motion.change(before.motion, s);
//   in begin_step   motion.begin(s);
//   in finish_step  motion.finish(s);
//   in linear       motion.linear(s, walls);
//   in rest         motion.rest(displacements, s);
class RigidMotion {
 public:
  void declare(Declaration& d) {
    declare_translation(d);
    declare_rotation(d);
  }

  // What it moves.
  struct Shape {
    std::array<double, 3> axis;  // unit; of motions without a direction
    int dimension;
    double reach = 0;      // (m) from the axis of the spin in which it is touched, at most; under a torque
    bool has_axis = true;  // false: motions need their own direction and axis
  };
  // Unit vector of the translation if the shape has this axis; the axis if its direction is not given.
  std::array<double, 3> direction_with(const std::array<double, 3>& axis) const {
    std::array<double, 3> direction = std::isnan(direction_[0]) ? axis : direction_;
    make_unit(direction);
    return direction;
  }
  const std::optional<std::array<double, 3>>& spin_axis() const { return spin_axis_; }
  const std::optional<std::array<double, 3>>& spin_point() const { return spin_point_; }
  bool has_torque() const { return turn_.press.given(); }
  void set_area(double area) {
    if (!(along_.area > 0)) along_.area = area;
  }

  // Returns the problem and a remedy, or "".
  std::string prepare(const Shape& shape) {
    constexpr GuidedMotion::Names along = {"control", {"fixed", "displacement", "velocity", "force"}, "mass"};
    constexpr GuidedMotion::Names turn = {"spin_control", {"fixed", "angle", "spin", "torque"}, "inertia"};
    const bool turn_chosen = turn_.control >= 0;
    if (shape.dimension == 2 && !std::isnan(direction_[0])) direction_[2] = 0;
    std::string problem = along_.prepare(along);
    if (problem.empty()) problem = turn_.prepare(turn);
    if (!problem.empty()) return problem;
    if (shape.dimension == 2 && along_.moves() && std::isnan(direction_[0]) && shape.axis[2] != 0)
      return "a motion without direction in a 2D scene; give a direction such as [1, 0, 0]";
    if (!shape.has_axis && along_.moves() && std::isnan(direction_[0]))
      return "a motion without direction; give a vector such as [0, 0, 1]";
    if (!shape.has_axis && turn_.moves() && !spin_axis_ && shape.dimension == 3)
      return "a turn without spin_axis; give a vector such as [0, 0, 1]";
    if (std::isnan(direction_[0])) direction_ = shape.axis;
    if (!make_unit(direction_))
      return std::string("direction has length 0; give a vector such as ") +
             (shape.dimension == 2 ? "[0, 1]" : "[0, 0, 1]");
    about_ = spin_axis_.value_or(shape.axis);
    if (shape.dimension == 2) about_ = {0, 0, 1};
    if (!make_unit(about_)) return "spin_axis has length 0; give a vector such as [0, 0, 1]";
    if (spin_point_ && !turn_.moves() && !turn_chosen)
      return "spin_point without spin; give spin = <rad/s>, or leave it out";
    if (turn_.is_pressed() && !std::isfinite(shape.reach))
      return "a torque on a surface without end, which its spin moves; give it a length, or prescribe the spin";
    left_out_ = along_.control == GuidedMotion::absent;
    if (left_out_) turn_.motion.control = WallMotion::fixed;
    const double ease = ease_of_motion(shape.reach);
    light_mass_ = ease > 0 ? 1 / ease : 0;
    if (ease > 0 && !std::isnormal(light_mass_))
      return "its mass or inertia is too small for a contact to move it by a number; give a larger one";
    return "";
  }

  bool moves() const { return along_.moves() || turn_.moves(); }
  void describe(BoundaryLayout& layout) const {
    layout.state = state_width;
    layout.still = !moves();
    layout.surface_mass = light_mass_;
    layout.surfaces_absent = left_out_;
    layout.damping_rate = std::max(along_.damping_rate(), turn_.damping_rate());
  }

  // point: through which the axis of the spin goes if the scenario does not say.
  void start(const BoundaryStep& s, const Vec3& point) const {
    const Vec3 through = spin_point_ ? vector_of(*spin_point_) : point;
    std::copy_n(through.component, 3, s.state.begin());
    change(*this, s);
  }
  // Sets velocities at the time of the step, before the first step with these parameters.
  void change(const RigidMotion& before, const BoundaryStep& s) const {
    GuidedMotion::State along = state_of(s, first_along), turn = state_of(s, first_turn);
    scale(dot(vector_of(before.direction_), vector_of(direction_)), along);
    scale(dot(vector_of(before.about_), vector_of(about_)), turn);
    along_.change(along, before.along_, s.time, s.energy);
    turn_.change(turn, before.turn_, s.time, s.energy);
    keep(s, along, turn);
    for (Frame& frame : s.frames) frame.mid_velocity = frame.velocity, frame.mid_spin = frame.spin;
  }
  void begin(const BoundaryStep& s) const {
    GuidedMotion::State along = state_of(s, first_along), turn = state_of(s, first_turn);
    const Vec3 through = centre(s);
    const Loads at = loads(s);
    const Vec3 moved = along_.begin(along, at.force, s.time, s.step, s.energy) * vector_of(direction_);
    const Vec3 turned = turn_.begin(turn, at.torque, s.time, s.step, s.energy) * vector_of(about_);
    const Rotation rotation = Rotation::by(turned);
    for (Frame& frame : s.frames) {
      const Vec3 arm = frame.position - through, displacement = moved + rotation(arm) - arm;
      frame.mid_velocity = 1 / s.step * displacement;
      frame.mid_spin = 1 / s.step * turned;
      frame.position += displacement;
      frame.orientation = rotation * frame.orientation;
    }
    for (int k = 0; k < 3; ++k) s.state[std::size_t(k)] += moved[k];
    keep(s, along, turn);
  }
  void finish(const BoundaryStep& s) const {
    GuidedMotion::State along = state_of(s, first_along), turn = state_of(s, first_turn);
    const Loads at = loads(s);
    along_.finish(along, at.force, s.time, s.step, s.energy);
    turn_.finish(turn, at.torque, s.time, s.step, s.energy);
    keep(s, along, turn);
  }
  // One equation for each surface: there is none if it turns as prescribed, or if forces move several
  // together.
  void linear(const BoundaryStep& s, LinearWalls& all) const {
    const bool together = (along_.is_pressed() || turn_.is_pressed()) && s.frames.size() > 1,
               turning = turn_.motion.prescribed(s.time, 0).speed != 0;
    for (LinearWall& wall : all.walls.subspan(s.walls.size())) {
      wall = along_.motion.linear(vector_of(direction_), along_.motion.prescribed(s.time, 0),
                                  along_.pressing_force(s.time));
      if (turning || together) wall.free = SCREE_NO_EQUATION;
      if (!turn_.is_pressed()) continue;
      wall.turns = 1;
      wall.axis = vector_of(about_), wall.centre = centre(s);
      wall.inertia = turn_.inertia, wall.spin_viscosity = turn_.motion.viscosity;
      wall.pressing_torque = turn_.pressing_force(s.time);
    }
  }
  // All surfaces are displaced alike.
  void rest(std::span<const Vec3> displacements, const BoundaryStep& s) const {
    const Vec3& moved = displacements.back();
    for (int k = 0; k < 3; ++k) s.state[std::size_t(k)] += moved[k];
    keep(s, {}, {});
  }

 private:
  // State: the point through which the axis goes, and three speeds of each part.
  static constexpr std::uint32_t first_along = 3, first_turn = 6, state_width = 9;
  struct Loads {
    double force, torque;
  };

  void declare_translation(Declaration& d) {
    d.choice(
         "control", along_.control, "fixed|displacement|velocity|force|stress|absent",
         "what moves it along the direction; without it the one that is given; absent: it keeps its place "
         "and nothing touches it")
        .optional();
    d.program("velocity", along_.motion.velocity, "m/s", any_number, "along the direction").optional();
    d.program("displacement", along_.motion.displacement, "m", any_number, "d(t), of which increments count")
        .optional();
    d.program("force", along_.press, "N", any_number, "P along the direction; 0: bodies alone move it")
        .optional();
    d.program("stress", along_.stress, "Pa", any_number, "P is the stress on the area").optional();
    d.number("area", along_.area, "m^2", positive,
             "of the stress; without it the projected area of a disc, rectangle or sphere")
        .optional();
    d.number("mass", along_.inertia, "kg", positive, "m under force or stress; gravity does not act on it")
        .optional();
    d.number("viscosity", along_.motion.viscosity, "kg/s", non_negative, "γ under force or stress");
    d.program("superposed", along_.motion.superposed, "m", any_number, "added to the motion by forces")
        .optional();
    d.vector("direction", direction_, "",
             "of the motion; without it the axis, or the normal; required for a mesh")
        .optional();
  }
  void declare_rotation(Declaration& d) {
    d.choice("spin_control", turn_.control, "fixed|angle|spin|torque",
             "what turns it; without it the one that is given")
        .optional();
    d.program("spin", turn_.motion.velocity, "rad/s", any_number,
              "about spin_axis, counter-clockwise seen from its end")
        .optional();
    d.program("angle", turn_.motion.displacement, "rad", any_number, "φ(t), of which increments count")
        .optional();
    d.program("torque", turn_.press, "N m", any_number, "M about spin_axis; 0: bodies alone turn it")
        .optional();
    d.number("inertia", turn_.inertia, "kg m^2", positive, "I about spin_axis, under torque").optional();
    d.number("spin_viscosity", turn_.motion.viscosity, "N m s", non_negative, "γ' under torque");
    d.program("superposed_angle", turn_.motion.superposed, "rad", any_number, "added to the turn by torques")
        .optional();
    d.vector("spin_axis", spin_axis_, "", "without it the axis, or the normal; in 2D z; required for a mesh")
        .optional();
    d.vector("spin_point", spin_point_, "m",
             "through which spin_axis goes; without it `point`, or `translation` of a mesh")
        .optional()
        .at_start_only();
  }

  // 1/m + reach²/I (1/kg): how easily a force moves the surface where a contact moves it most.
  double ease_of_motion(double reach) const {
    return (along_.is_pressed() ? 1 / along_.inertia : 0) +
           (turn_.is_pressed() ? reach * reach / turn_.inertia : 0);
  }
  static Vec3 centre(const BoundaryStep& s) { return {{s.state[0], s.state[1], s.state[2]}}; }
  static GuidedMotion::State state_of(const BoundaryStep& s, std::size_t first) {
    return {s.state[first], s.state[first + 1], s.state[first + 2]};
  }
  static void scale(double factor, GuidedMotion::State& state) {
    state = {factor * state.mid_speed, factor * state.speed, factor * state.free_speed};
  }
  Loads loads(const BoundaryStep& s) const {
    Vec3 force = {}, torque = {};
    for (std::size_t k = 0; k < s.frames.size(); ++k) {
      force += s.frame_loads[k].force;
      torque += s.frame_loads[k].torque + cross(s.frames[k].position - centre(s), s.frame_loads[k].force);
    }
    return {dot(force, vector_of(direction_)), dot(torque, vector_of(about_))};
  }
  // Keeps the parts of the state, and sets velocities.
  void keep(const BoundaryStep& s, const GuidedMotion::State& along, const GuidedMotion::State& turn) const {
    std::size_t at = first_along;
    for (const GuidedMotion::State& part : {along, turn})
      for (const double speed : {part.mid_speed, part.speed, part.free_speed}) s.state[at++] = speed;
    for (Frame& frame : s.frames) {
      frame.spin = turn.speed * vector_of(about_);
      frame.velocity = along.speed * vector_of(direction_) + cross(frame.spin, frame.position - centre(s));
    }
  }

  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
  GuidedMotion along_, turn_;
  std::array<double, 3> direction_ = {not_given}, about_ = {};
  std::optional<std::array<double, 3>> spin_axis_, spin_point_;
  double light_mass_ = 0;
  bool left_out_ = false;
};

}  // namespace scree
