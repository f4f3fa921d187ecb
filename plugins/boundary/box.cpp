// Rectangular box of 4 (2D) or 6 (3D) walls, each fixed, moved by a program, or stress-controlled.

#include "box_keys.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <scree/plugin/wall_motion.hpp>

namespace {

using namespace box;
using scree::BoundaryStep;
using scree::WallMotion;

struct Box {
  enum Control { stress, fixed, displacement, velocity, strain_rate, servo, massless, absent };
  static constexpr const char* controls =
      "stress|fixed|displacement|velocity|strain_rate|servo|massless|absent";

  std::optional<std::array<double, 3>> lower_given, upper_given;
  std::array<double, 3> lower = {}, upper = {};
  double gap = 0;
  double mass = 1;
  double viscosity = 0;
  int axis_control[3] = {-1, -1, -1};
  int control[max_walls] = {-1, -1, -1, -1, -1, -1};
  scree::Program all_stress;
  scree::Program axis_stress[3];
  scree::Program wall_stress[max_walls];
  scree::Program strain_rates[3];
  WallMotion motions[max_walls];  // along the inward normals
  scree::LoadControl limits;
  int dimension = 3;
  bool superposes = false, tries = false;
  double masses[max_walls] = {};  // (kg); 0 for walls that forces do not move
  std::uint32_t left_out[max_walls] = {};

  static constexpr scree::About about = {
      "box", "4 or 6 walls, each fixed, moved by a program, or stress-controlled with mass and viscosity",
      "stress: m_w s\" = F·n + p(t) A(t) − γ_w s', and a superposed displacement d(t) is added to s\n"
      "servo: in each step of several displacements within v Δt the one with −F·n nearest to p(t) A(t)\n"
      "massless: F·n + p(t) A(t) = 0 at the end of each step, and |s'| <= v\n"
      "displacement: d(t) − d(0);  velocity: ∫u dt;  strain_rate: L' = −ε'(t) L, opposite walls alike\n"
      "s: inward displacement of the wall, n: inward normal, L: length of the box along n,\n"
      "F: contact force on the wall, A(t): its present area (2D: length × 1 m)",
      "David et al. 2005, section 2; McNamara et al. 2008, equation 1; servo: Lemrich et al. 2017, section II"};

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.vector("lower", lower_given, "m",
             "lower corner; that of the bodies' bounding box minus the gap if not given")
        .at_start_only();
    d.vector("upper", upper_given, "m",
             "upper corner; that of the bodies' bounding box plus the gap if not given")
        .at_start_only();
    d.number("gap", gap, "m", non_negative, "distance from the bodies where a corner is not given")
        .at_start_only();
    d.number("mass", mass, "kg", positive, "m_w of each stress-controlled wall");
    d.number("viscosity", viscosity, "kg/s", non_negative, "γ_w of each stress-controlled wall");
    for (int w = 0; w < max_walls; ++w)
      d.choice(wall_names[w], control[w], controls, "what moves this wall; if not given that of its axis")
          .optional();
    for (int k = 0; k < 3; ++k)
      d.choice(axis_keys[k].control, axis_control[k], controls,
               "what moves both walls of this axis; stress if not given; excludes the keys of single walls")
          .optional();
    d.program("stress", all_stress, "Pa", any_number, "p of every wall, pressing inwards").optional();
    for (int k = 0; k < 3; ++k)
      d.program(axis_keys[k].stress, axis_stress[k], "Pa", any_number,
                "p of both walls of this axis; overrides stress")
          .optional();
    for (int w = 0; w < max_walls; ++w)
      d.program(wall_keys[w].stress, wall_stress[w], "Pa", any_number,
                "p of this wall; overrides that of its axis")
          .optional();
    declare_motion(d);
    declare_load_control(d, limits);
  }

  void prepare(const scree::Setup& setup) {
    dimension = setup.dimension();
    for (std::size_t k = 0; k < std::size_t(dimension); ++k) {
      lower[k] = lower_given ? (*lower_given)[k] : setup.lower(int(k)) - gap;
      upper[k] = upper_given ? (*upper_given)[k] : setup.upper(int(k)) + gap;
      if (!(upper[k] > lower[k]))
        return setup.refuse("upper is not above lower; give both corners, or bodies to be enclosed");
    }
    for (int w = 0; w < walls(); ++w)
      if (!prepare_wall(w, setup)) return;
    for (int w = 0; w < walls(); ++w)
      if (strained(w) && !strained(w ^ 1) && motions[w ^ 1].moves())
        return setup.refuse(
            "a wall has control \"strain_rate\" and the opposite one moves otherwise, so that the strain is "
            "not its own; fix the opposite wall, or give it \"strain_rate\" too");
  }

  void describe(scree::BoundaryLayout& layout) const {
    layout.walls = std::uint32_t(walls());
    layout.state = std::uint32_t((1 + superposes + tries) * walls());
    layout.names = wall_names;
    layout.masses = masses;
    layout.absent = left_out;
    layout.still = true;
    for (int w = 0; w < walls(); ++w) {
      if (pressed(w)) layout.damping_rate = viscosity / mass;
      layout.displacement_speed = std::max(layout.displacement_speed, motions[w].displacement_speed(limits));
      if (motions[w].moves()) layout.still = false;
    }
  }

  const char* start(const BoundaryStep& s) const {
    for (int w = 0; w < walls(); ++w) {
      scree::Wall& wall = s.walls[std::size_t(w)];
      wall = {};
      for (int k = 0; k < dimension; ++k) wall.point[k] = (w % 2 ? upper : lower)[std::size_t(k)];
      wall.normal[w / 2] = sign(w);
    }
    for (int w = 0; w < walls(); ++w) set_speeds(w, s, 0);
    return nullptr;
  }

  void change(const Box& before, double, const BoundaryStep& s) const {
    double free[max_walls];
    for (int w = 0; w < walls(); ++w)
      free[w] = motions[w].free_speed_after(before.motions[w], speed_of(w, s), before.free_speed_of(w, s));
    for (int w = 0; w < walls(); ++w) {
      set_speeds(w, s, free[w]);
      motions[w].add_kinetic(free[w], s.energy);
    }
  }

  void begin_step(const BoundaryStep& s) const {
    // All from the box at the start of the step, before any wall moves.
    WallMotion::Prescribed prescribed[max_walls];
    WallMotion::Forces forces[max_walls];
    for (int w = 0; w < walls(); ++w) {
      prescribed[w] = prescribed_of(w, s, s.step);
      forces[w] = forces_on(w, s, motions[w].seeks_load() ? s.time + s.step : s.time);
    }
    for (int w = 0; w < walls(); ++w) {
      if (!motions[w].moves()) continue;
      const auto motion = motions[w].seeks_load() ? begin_by_load(w, s, prescribed[w], forces[w])
                                                  : motions[w].begin(free_speed_of(w, s), prescribed[w],
                                                                     forces[w], s.step, s.energy);
      s.walls[std::size_t(w)].point[w / 2] += sign(w) * motion.distance;
      set(w, s, motion);
    }
  }

  void finish_step(const BoundaryStep& s) const {
    for (int w = 0; w < walls(); ++w) {
      const WallMotion::Forces forces = forces_on(w, s, s.time + s.step);
      s.state[std::size_t(w)] = forces.press;
      if (!motions[w].moves()) continue;
      const WallMotion::StepMotion begun = {0, sign(w) * s.walls[std::size_t(w)].mid_velocity[w / 2],
                                            speed_of(w, s), 0};
      set(w, s, motions[w].finish(begun, forces, s.time, s.step, s.energy));
    }
  }

  // p A falls as walls of other axes move inwards.
  void linear(const BoundaryStep& s, scree::LinearWalls& linear) const {
    for (int w = 0; w < walls(); ++w) {
      linear.walls[std::size_t(w)] = motions[w].linear(s.walls[std::size_t(w)].normal, prescribed_of(w, s, 0),
                                                       forces_on(w, s, s.time).press);
      for (int other = 0; other < walls(); ++other)
        if (other / 2 != w / 2)
          linear.stiffness(std::size_t(w), std::size_t(other)) =
              forces_on(w, s, s.time).press / length(other / 2, s);
    }
  }

  void rest(std::span<const scree::Vec3>, const BoundaryStep& s) const {
    for (int w = 0; w < walls(); ++w) {
      s.state[std::size_t(w)] = forces_on(w, s, s.time).press;
      set(w, s, {});
    }
  }

 private:
  void declare_motion(scree::Declaration& d) {
    using scree::any_number;
    for (int k = 0; k < 3; ++k)
      d.program(
           axis_keys[k].strain_rate, strain_rates[k], "1/s", any_number,
           "ε' of walls with control \"strain_rate\": logarithmic, above 0 in compression; opposite walls "
           "share it")
          .optional();
    for (int w = 0; w < max_walls; ++w)
      d.program(wall_keys[w].displacement, motions[w].displacement, "m", any_number,
                "d inwards, for control \"displacement\", from where the wall is")
          .optional();
    for (int w = 0; w < max_walls; ++w)
      d.program(wall_keys[w].velocity, motions[w].velocity, "m/s", any_number,
                "u inwards, for control \"velocity\"; reached at once, a ramp starts smoothly")
          .optional();
    for (int w = 0; w < max_walls; ++w)
      d.program(wall_keys[w].superposed, motions[w].superposed, "m", any_number,
                "d inwards, added to the motion under control \"stress\", from where the wall is")
          .optional();
  }

  // Control and program of a wall. Returns whether they fit.
  bool prepare_wall(int w, const scree::Setup& setup) {
    static constexpr int motion_of[] = {WallMotion::pressed,     WallMotion::fixed,    WallMotion::displaced,
                                        WallMotion::at_velocity, WallMotion::strained, WallMotion::servo,
                                        WallMotion::massless,    WallMotion::fixed};
    WallMotion& motion = motions[w];
    const int of_axis = axis_control[w / 2], chosen = std::max({control[w], of_axis, int(stress)});
    motion.control = motion_of[chosen];
    motion.mass = mass;
    motion.viscosity = viscosity;
    masses[w] = pressed(w) ? mass : 0;
    left_out[w] = chosen == absent;
    superposes = superposes || motion.superposes();
    tries = tries || motion.seeks_load();
    if (!wall_stress[w].given())
      wall_stress[w] = axis_stress[w / 2].given() ? axis_stress[w / 2] : all_stress;

    char line[256] = "";
    const auto need = [&](bool given, const char* quantity, const char* key, const char* unit) {
      if (!given)
        std::snprintf(line, sizeof(line), "wall %s has no %s; give %s = <%s>", wall_names[w], quantity, key,
                      unit);
    };
    if (control[w] >= 0 && of_axis >= 0)
      std::snprintf(line, sizeof(line), "%s and %s both say what moves a wall; keep one of them",
                    wall_names[w], axis_keys[w / 2].control);
    if (motion.seeks_load()) need(limits.speed_limit > 0, "speed limit", "speed_limit", "m/s");
    if (motion.moved_by_forces() && !wall_stress[w].given())
      std::snprintf(line, sizeof(line),
                    "a stress-controlled wall has no stress; give stress = <Pa>, or set %s to \"fixed\"",
                    wall_names[w]);
    if (chosen == displacement)
      need(motion.displacement.given(), "displacement", wall_keys[w].displacement, "m");
    if (chosen == velocity) need(motion.velocity.given(), "velocity", wall_keys[w].velocity, "m/s");
    if (chosen == strain_rate)
      need(strain_rates[w / 2].given(), "strain rate", axis_keys[w / 2].strain_rate, "1/s");
    if (*line) setup.refuse(line);
    return !*line;
  }

  int walls() const { return 2 * dimension; }
  bool pressed(int w) const { return motions[w].control == WallMotion::pressed; }
  bool strained(int w) const { return motions[w].control == WallMotion::strained; }
  static double sign(int w) { return w % 2 ? -1 : 1; }
  static double length(int axis, const BoundaryStep& s) {
    return s.walls[std::size_t(2 * axis + 1)].point[axis] - s.walls[std::size_t(2 * axis)].point[axis];
  }
  double area(int w, const BoundaryStep& s) const {
    double a = 1;
    for (int k = 0; k < dimension; ++k)
      if (k != w / 2) a *= length(k, s);
    return a;
  }
  WallMotion::Forces forces_on(int w, const BoundaryStep& s, double time) const {
    return {sign(w) * s.loads[std::size_t(w)].force[w / 2],
            motions[w].moved_by_forces() ? wall_stress[w](time) * area(w, s) : 0};
  }

  WallMotion::StepMotion begin_by_load(int w, const BoundaryStep& s, const WallMotion::Prescribed& prescribed,
                                       const WallMotion::Forces& forces) const {
    const scree::Vec3 inwards = s.walls[std::size_t(w)].normal;
    const auto load_after = [&](double x) {
      return dot(inwards, s.load_after(std::size_t(w), x * inwards).force);
    };
    const double mid_speed = dot(inwards, s.walls[std::size_t(w)].mid_velocity);
    return motions[w].begin_by_load(limits, mid_speed, stiffness_of(w, s), prescribed, forces, s.step,
                                    load_after, s.energy);
  }
  // Stiffness of the contacts of a wall that tries displacements: behind the loads of all walls, and behind
  // their free speeds where motions are superposed.
  double& stiffness_of(int w, const BoundaryStep& s) const {
    return s.state[std::size_t((1 + superposes) * walls() + w)];
  }

  WallMotion::Prescribed prescribed_of(int w, const BoundaryStep& s, double step) const {
    if (!strained(w)) return motions[w].prescribed(s.time, step);
    // The exact solution of L' = −ε' L over the step; the wall's share is a half if the opposite one moves
    // too.
    const scree::Program& rate = strain_rates[w / 2];
    const double share = strained(w ^ 1) ? 0.5 : 1;
    const double before = length(w / 2, s);
    const double shortening = -before * std::expm1(-step * WallMotion::mean(rate, s.time, step));
    return {share * shortening, share * rate(s.time + step) * (before - shortening)};
  }

  static double speed_of(int w, const BoundaryStep& s) {
    return sign(w) * s.walls[std::size_t(w)].velocity[w / 2];
  }
  // s' of a wall: where a motion is superposed, behind the loads of all walls.
  double free_speed_of(int w, const BoundaryStep& s) const {
    return motions[w].superposes() ? s.state[std::size_t(walls() + w)] : speed_of(w, s);
  }
  // Speeds before the first step with these parameters.
  void set_speeds(int w, const BoundaryStep& s, double free) const {
    s.state[std::size_t(w)] = forces_on(w, s, s.time).press;
    if (tries) stiffness_of(w, s) = 0;
    if (motions[w].moves()) {
      const double speed = free + prescribed_of(w, s, 0).speed;
      set(w, s, {0, speed, speed, free});
    } else {
      s.walls[std::size_t(w)].velocity[w / 2] = s.walls[std::size_t(w)].mid_velocity[w / 2] = 0;
    }
  }
  void set(int w, const BoundaryStep& s, const WallMotion::StepMotion& motion) const {
    scree::Wall& wall = s.walls[std::size_t(w)];
    wall.mid_velocity[w / 2] = sign(w) * motion.mid_speed;
    wall.velocity[w / 2] = sign(w) * motion.speed;
    if (motions[w].superposes()) s.state[std::size_t(walls() + w)] = motion.free_speed;
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Box)
