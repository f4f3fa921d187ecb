// One infinite plane, fixed, moved by a program, or under a stress or force.

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/plugin/unit_vector.hpp>
#include <scree/plugin/wall_motion.hpp>

namespace {

struct Plane {
  enum Control { fixed, displacement, velocity, stress, force, servo, massless, absent };
  // Layout of the state: the load of the last step (N), which the hash of the state covers; s' if a motion is
  // superposed under stress or force, or the stiffness of the contacts (N/m) if displacements are tried.
  enum State { load, free_speed = 3, stiffness = 3, state_width };

  std::array<double, 3> point = {};
  std::array<double, 3> normal = {};
  std::array<double, 3> direction = {std::numeric_limits<double>::quiet_NaN()};  // NaN: not given
  int control = -1;
  double area = 0;  // (m²)
  double mass = 0;  // (kg) 0 unless forces move the plane
  std::uint32_t left_out = 0;
  scree::Program pressing_stress, pressing_force;
  scree::WallMotion motion;
  scree::LoadControl limits;

  static constexpr scree::About about = {
      "plane", "infinite plane, fixed, with prescribed motion, or under constant stress or force",
      "x_w(t) = point + e (s + d)   e: direction of motion\n"
      "control displacement or velocity: d(t) − d(0) or ∫u dt, s = 0\n"
      "control stress or force: m s\" = F·e + P(t) − γ s', P = p(t) A or the force, d: superposed displacement\n"
      "control servo: in each step of several displacements within v Δt the one with −F·e nearest to P\n"
      "control massless: F·e + P = 0 at the end of each step, and |s'| <= v\n"
      "F: contact force on the plane",
      "servo: Lemrich et al. 2017, section II"};

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.vector("point", point, "m", "any point of the plane").required().at_start_only();
    d.vector("normal", normal, "", "normal pointing to the bodies; need not be a unit vector")
        .required()
        .at_start_only();
    d.vector("direction", direction, "", "direction of motion; the normal if not given").optional();
    d.program("displacement", motion.displacement, "m", any_number,
              "d(t) along the direction; fixed if neither this nor control is given")
        .optional();
    d.choice(
         "control", control, "fixed|displacement|velocity|stress|force|servo|massless|absent",
         "what moves the plane; if not given the displacement, if there is one; absent: it keeps its place and nothing touches it")
        .optional();
    d.program("velocity", motion.velocity, "m/s", any_number,
              "u(t) along the direction, for control = \"velocity\"; reached at once, a ramp starts smoothly")
        .optional();
    d.program("stress", pressing_stress, "Pa", any_number,
              "p on the area, along the direction, for control = \"stress\", \"servo\" or \"massless\"")
        .optional();
    d.number("area", area, "m^2", positive, "A on which the stress acts (2D: length × 1 m)").optional();
    d.program("force", pressing_force, "N", any_number,
              "P along the direction, for control = \"force\", or \"servo\" or \"massless\" without stress")
        .optional();
    d.number("mass", motion.mass, "kg", positive, "m under stress or force");
    d.number("viscosity", motion.viscosity, "kg/s", non_negative, "γ under stress or force");
    d.program("superposed", motion.superposed, "m", any_number,
              "d(t) added to the motion under stress or force, from where the plane is")
        .optional();
    declare_load_control(d, limits);
  }

  void prepare(const scree::Setup& setup) {
    using scree::WallMotion;
    if (!scree::make_unit(normal))
      return setup.refuse("normal has length 0; give a vector such as [0, 0, 1]");
    if (std::isnan(direction[0])) direction = normal;
    if (!scree::make_unit(direction))
      return setup.refuse("direction has length 0; give a vector such as [0, 0, 1], or leave it out");
    const bool moved_otherwise = motion.velocity.given() || pressing_stress.given() ||
                                 pressing_force.given() || motion.superposed.given();
    if (control < 0 && !motion.displacement.given() && moved_otherwise)
      return setup.refuse(
          "what moves the plane is given without control; give control = \"velocity\", \"stress\" or "
          "\"force\"");
    // One of them would be ignored; with control it may wait for its stage.
    if (control < 0 && moved_otherwise)
      return setup.refuse(
          "displacement and another motion are given without control; give control = \"displacement\", \"velocity\", "
          "\"stress\" or \"force\", or leave one of them out");
    if (control < 0) control = motion.displacement.given() ? displacement : fixed;
    if (control == displacement && !motion.displacement.given())
      return setup.refuse("control = \"displacement\" without displacement; give displacement = <m>");
    if (control == velocity && !motion.velocity.given())
      return setup.refuse("control = \"velocity\" without velocity; give velocity = <m/s>");
    if (control == stress && !(pressing_stress.given() && area > 0))
      return setup.refuse("control = \"stress\" without stress and area; give stress = <Pa>, area = <m^2>");
    if (control == force && !pressing_force.given())
      return setup.refuse("control = \"force\" without force; give force = <N>");
    const bool tries = control == servo || control == massless;
    if (tries && pressing_stress.given() == pressing_force.given())
      return setup.refuse(
          "control = \"servo\" or \"massless\" needs either stress or force; give stress = <Pa>, area = <m^2>, or "
          "force = <N>");
    if (tries && pressing_stress.given() && !(area > 0))
      return setup.refuse("stress without area; give area = <m^2>");
    if (tries && !(limits.speed_limit > 0))
      return setup.refuse(
          "control = \"servo\" or \"massless\" without speed_limit; give speed_limit = <m/s>");
    left_out = control == absent;
    motion.control = control == fixed || left_out ? WallMotion::fixed
                     : control == displacement    ? WallMotion::displaced
                     : control == velocity        ? WallMotion::at_velocity
                     : control == servo           ? WallMotion::servo
                     : control == massless        ? WallMotion::massless
                                                  : WallMotion::pressed;
    mass = motion.control == WallMotion::pressed ? motion.mass : 0;
  }

  void describe(scree::BoundaryLayout& layout) const {
    layout.walls = 1;
    layout.state = motion.superposes() || motion.seeks_load() ? state_width : free_speed;
    layout.masses = &mass;
    layout.absent = &left_out;
    layout.damping_rate = mass > 0 ? motion.viscosity / mass : 0;
    layout.displacement_speed = motion.displacement_speed(limits);
    layout.still = !motion.moves();
  }

  const char* start(const scree::BoundaryStep& s) const {
    s.walls[0] = {.point = vector(point), .normal = vector(normal), .velocity = {}, .mid_velocity = {}};
    set_speeds(s, 0);
    return nullptr;
  }

  void change(const Plane& before, double, const scree::BoundaryStep& s) const {
    const double speed = dot(vector(before.direction), s.walls[0].velocity);
    set_speeds(s, motion.free_speed_after(before.motion, speed, before.free_speed_of(s)));
    motion.add_kinetic(free_speed_of(s), s.energy);
  }

  void begin_step(const scree::BoundaryStep& s) const {
    const auto prescribed = motion.prescribed(s.time, s.step);
    const auto c = motion.seeks_load()
                       ? begin_by_load(prescribed, s)
                       : motion.begin(free_speed_of(s), prescribed, forces(s, s.time), s.step, s.energy);
    s.walls[0].point += c.distance * vector(direction);
    set(s, c);
  }

  void finish_step(const scree::BoundaryStep& s) const {
    const scree::Vec3 e = vector(direction);
    const scree::WallMotion::StepMotion begun = {0, dot(e, s.walls[0].mid_velocity),
                                                 dot(e, s.walls[0].velocity), 0};
    const auto c = motion.finish(begun, forces(s, s.time + s.step), s.time, s.step, s.energy);
    if (mass > 0) set(s, c);
    keep_load(s);
  }

  void linear(const scree::BoundaryStep& s, scree::LinearWalls& linear) const {
    linear.walls[0] = motion.linear(vector(direction), motion.prescribed(s.time, 0), forces(s, s.time).press);
  }

  void rest(std::span<const scree::Vec3>, const scree::BoundaryStep& s) const {
    set(s, {});
    keep_load(s);
  }

 private:
  static scree::Vec3 vector(const std::array<double, 3>& v) { return scree::vector_of(v); }

  scree::WallMotion::StepMotion begin_by_load(const scree::WallMotion::Prescribed& prescribed,
                                              const scree::BoundaryStep& s) const {
    const scree::Vec3 e = vector(direction);
    const auto load_after = [&](double x) { return dot(e, s.load_after(0, x * e).force); };
    return motion.begin_by_load(limits, dot(e, s.walls[0].mid_velocity), s.state[stiffness], prescribed,
                                {dot(e, s.loads[0].force), forces(s, s.time + s.step).press}, s.step,
                                load_after, s.energy);
  }

  scree::WallMotion::Forces forces(const scree::BoundaryStep& s, double time) const {
    const double press = !motion.moved_by_forces()                      ? 0
                         : control == force || !pressing_stress.given() ? pressing_force(time)
                                                                        : pressing_stress(time) * area;
    return {dot(vector(direction), s.loads[0].force), press};
  }
  double free_speed_of(const scree::BoundaryStep& s) const {
    return motion.superposes() ? s.state[free_speed] : dot(vector(direction), s.walls[0].velocity);
  }
  // Speeds at s.time with this s', before the first step with these parameters.
  void set_speeds(const scree::BoundaryStep& s, double free) const {
    if (!motion.moves()) return;
    const double speed = free + motion.prescribed(s.time, 0).speed;
    set(s, {0, speed, speed, free});
    if (motion.seeks_load()) s.state[stiffness] = 0;
  }
  static void keep_load(const scree::BoundaryStep& s) {
    for (int k = 0; k < 3; ++k) s.state[std::size_t(load + k)] = s.loads[0].force[k];
  }
  void set(const scree::BoundaryStep& s, const scree::WallMotion::StepMotion& c) const {
    s.walls[0].mid_velocity = c.mid_speed * vector(direction);
    s.walls[0].velocity = c.speed * vector(direction);
    if (motion.superposes()) s.state[free_speed] = c.free_speed;
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Plane)
