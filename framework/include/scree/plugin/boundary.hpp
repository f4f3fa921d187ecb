#pragma once

#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <type_traits>

#include <scree/plugin/abi.h>
#include <scree/plugin/declaration.hpp>
#include <scree/plugin/rotation.hpp>
#include <scree/plugin/vec.hpp>

// How to write a boundary: plugins/README.md. An author's struct has
//
//   static constexpr scree::About about;
//   void declare(scree::Declaration&);
//   void prepare(const scree::Setup&);                    optional: derived values, refusals
//   void describe(scree::BoundaryLayout&) const;          number of walls and state doubles, periodic axes
//   const char* start(const scree::BoundaryStep&) const;  walls and state at the start; null, or the problem
//                                                         and a remedy
//   void begin_step(const scree::BoundaryStep&) const;    walls from t to t + step
//   void finish_step(const scree::BoundaryStep&) const;   velocities and energies at t + step
//   void change(const Author& before, double time_before, const scree::BoundaryStep&) const;
//                                                         optional: velocities after a change of parameters
//   void linear(const scree::BoundaryStep&, scree::LinearWalls&) const;
//                                                         optional: how forces move the walls, for a linear
//                                                         response; without it they are prescribed
//   void rest(std::span<const scree::Vec3> displacements, const scree::BoundaryStep&) const;
//                                                         optional: state where the host has displaced the
//                                                         walls (m) and brought them to rest
//
// A boundary without walls needs only `describe`. When each is called: scree/plugin/abi/boundary.h.
// The motion of one wall, prescribed or under stress: scree/plugin/wall_motion.hpp. Of surfaces:
// scree/plugin/rigid_motion.hpp.

namespace scree {

// One wall: an infinite plane. It is the C struct scree_plane with vectors.
struct Wall {
  Vec3 point;         // (m)
  Vec3 normal;        // unit, pointing to the bodies
  Vec3 velocity;      // (m/s) at the end of the step
  Vec3 mid_velocity;  // (m/s) displacement in the step / step
};

// What all contacts exert on a wall.
struct WallLoad {
  Vec3 force;  // (N)
};

// A surface in its own frame, by its C struct; see abi/surface.h.
struct Surface : scree_surface {
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  // In the plane z = 0, or in 2D on the line y = 0, with half lengths (m) that may be infinite.
  static Surface flat(double along_x, double along_y, scree_side side) {
    return {{SCREE_FLAT, std::uint32_t(side), {along_x, along_y}, nullptr, 0}};
  }
  // The line from (radius, z) to another one (m), turned about z.
  static Surface revolved(double radius, double z, double end_radius, double end_z, scree_side side) {
    return {{SCREE_REVOLVED, std::uint32_t(side), {radius, z, end_radius, end_z}, nullptr, 0}};
  }
  // The part of a sphere, in 2D of a circle, between two heights (m) along z, in 2D along y.
  static Surface ball(double radius, double low, double high, scree_side side) {
    return {{SCREE_BALL, std::uint32_t(side), {radius, low, high}, nullptr, 0}};
  }
  // Triangles, by the value of a parameter Declaration::mesh. smooth_angle: (rad) below which two spots
  // count as one.
  static Surface mesh(const scree_value& triangles, double scale, double smooth_angle, scree_side side) {
    return {{SCREE_MESH, std::uint32_t(side), {scale, smooth_angle}, triangles.data, triangles.count}};
  }
};

// Where the frame of a surface is, and how it moves. It is the C struct scree_frame with vectors.
struct Frame {
  Vec3 position;         // (m) of its origin
  Rotation orientation;  // of its axes
  Vec3 velocity;         // (m/s) of the origin at the end of the step
  Vec3 spin;             // (rad/s) at the end of the step
  Vec3 mid_velocity;     // (m/s) displacement in the step / step
  Vec3 mid_spin;         // (rad/s) rotation vector of the turn in the step / step
};

// What all contacts exert on a surface.
struct FrameLoad {
  Vec3 force;   // (N)
  Vec3 torque;  // (N m) about the origin of its frame
};

// Output of a call, initialised to 0. `kinetic` is the present energy of the walls (J); `work` (J) is done on
// the scene by pressing forces and prescribed motion, and `dissipated` (J) by viscosity, in this call.
using BoundaryEnergy = scree_boundary_energy;

// All walls of the scene, and its extent. In `begin_step` walls of preceding boundaries have already moved.
struct BoundaryScene {
  std::span<const Wall> walls;
  std::span<const WallLoad> loads;
  std::span<const char* const> names;  // "<boundary>.<wall>"
  Vec3 lower, upper;                   // (m) bounding box of the bodies at the start of the run
  bool periodic[3];
  Vec3 domain_lower, domain_upper;  // (m) limits of periodic axes
};

// What the functions of a boundary receive.
struct BoundaryStep {
  int dimension;
  double time;  // (s) at the start of the step, since the parameters were set
  double step;  // (s) negative in the third substep of fourth_order; 0 in `start` and `change`
  std::span<Wall> walls;
  std::span<const WallLoad> loads;  // at the start (begin_step) or the end (finish_step) of the step
  std::span<double> state;          // kept by the host between calls
  BoundaryEnergy& energy;
  const scree_boundary_scene* shared;
  const scree_displaced_loads* displaced_loads;
  std::span<Frame> frames;  // of the surfaces
  std::span<const FrameLoad> frame_loads;

  BoundaryScene scene() const;
  // In `begin_step` with a displacement_speed: the load of a wall at the end of the step after a displacement
  // (m) at constant velocity, where `walls` does not have it yet.
  WallLoad load_after(std::size_t wall, const Vec3& displacement) const;
};

// What a boundary consists of with its present parameters.
struct BoundaryLayout {
  struct Axis {
    double lower, upper;  // (m)
  };
  std::uint32_t walls = 0;                // the same in all stages
  std::uint32_t state = 0;                // number of doubles that the host keeps
  const char* const* names = nullptr;     // of the walls, if they have names
  const double* masses = nullptr;         // (kg) of the walls, a member of the struct; 0: not moved by forces
  const std::uint32_t* absent = nullptr;  // of the walls, a member of the struct; nonzero: exerts no force
  double damping_rate = 0;                // (1/s) at which viscosity slows the lightest wall
  double displacement_speed = 0;          // (m/s) largest speed of displacements for which begin_step asks
                                          // load_after; 0: it does not
  bool still = false;                     // no wall moves, and begin_step and finish_step are not called
  std::optional<Axis> periodic[3] = {};   // the same in all stages
  std::span<const Surface> surfaces = {};      // members of the struct; the same in all stages
  const char* const* surface_names = nullptr;  // of the surfaces, if they have names
  double surface_mass = 0;       // (kg) that the lightest contact with a surface feels; 0: forces move none
  bool surfaces_absent = false;  // exert no forces
};

// Equation of small motions of a wall along one direction, m s" + γ s' + Σ_c k_c x_c = F, x = s + d, with the
// displacement x, its superposed part d and the force F of the contacts (abi/boundary.h).
struct LinearWall {
  std::uint32_t free = 0;      // scree_wall_freedom
  Vec3 direction;              // unit; the normal at first
  double mass = 0;             // m (kg), may be 0
  double viscosity = 0;        // γ (kg/s)
  double pressing_force = 0;   // (N) at the time of the step
  double speed = 0;            // d' (m/s) at that time; of a wall that is not free x'
  std::uint32_t turns = 0;     // nonzero: torques turn it, I φ" + γ' φ' = T; only surfaces
  Vec3 axis = {};              // unit, of the turn
  Vec3 centre = {};            // (m) a point of the axis
  double inertia = 0;          // I (kg m²), may be 0
  double spin_viscosity = 0;   // γ' (N m s)
  double pressing_torque = 0;  // (N m) at the time of the step
};

// Of the planes of a boundary, then of its surfaces; at first they are prescribed, and numbers are 0.
struct LinearWalls {
  std::span<LinearWall> walls;
  std::span<double> stiffnesses;  // (walls, walls)
  // Negative derivative of the pressing force of a free wall with the displacement of any wall (N/m).
  double& stiffness(std::size_t pressed, std::size_t moved) const {
    return stiffnesses[pressed * walls.size() + moved];
  }
};

namespace detail {

// The same bytes as objects of another type with the same layout: memmove creates them, and compiles to
// nothing.
template <class To, class From>
To* same_bytes(From* from, std::size_t count) {
  static_assert(sizeof(To) == sizeof(From) && alignof(To) == alignof(From));
  static_assert(std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  using Plain = std::remove_const_t<From>;
  if (count > 0) std::memmove(const_cast<Plain*>(from), from, count * sizeof(From));
  return std::launder(reinterpret_cast<To*>(const_cast<Plain*>(from)));
}

template <class To, class From>
std::span<To> span_of(From* from, std::size_t count) {
  return {same_bytes<To>(from, count), count};
}

inline BoundaryStep step_of(const scree_boundary_step& s) {
  return {int(s.dimension),
          s.time,
          s.step,
          span_of<Wall>(s.planes, s.plane_count),
          span_of<const WallLoad>(s.loads, s.plane_count),
          {s.state, s.state_width},
          *s.energy,
          s.scene,
          s.displaced_loads,
          span_of<Frame>(s.frames, s.surface_count),
          span_of<const FrameLoad>(s.frame_loads, s.surface_count)};
}

inline void assign(scree_boundary_instance& instance, const BoundaryLayout& layout) {
  instance = {};
  instance.struct_size = sizeof(instance);
  instance.plane_count = layout.walls;
  instance.state_width = layout.state;
  instance.plane_names = layout.names;
  instance.plane_masses = layout.masses;
  instance.plane_absent = layout.absent;
  instance.damping_rate = layout.damping_rate;
  instance.displacement_speed = layout.displacement_speed;
  instance.still = layout.still;
  instance.surface_count = std::uint32_t(layout.surfaces.size());
  instance.surfaces = layout.surfaces.data();
  instance.surface_names = layout.surface_names;
  instance.surface_mass = layout.surface_mass;
  instance.surfaces_absent = layout.surfaces_absent;
  for (int k = 0; k < 3; ++k) {
    if (!layout.periodic[k]) continue;
    instance.periodic[k] = 1;
    instance.lower[k] = layout.periodic[k]->lower;
    instance.upper[k] = layout.periodic[k]->upper;
  }
}

template <class Author>
int configure_boundary(const scree_setup* setup, void* storage, scree_boundary_instance* instance) {
  if (const int failed = configure_author<Author>(setup, storage)) return failed;
  BoundaryLayout layout;
  static_cast<const Author*>(storage)->describe(layout);
  assign(*instance, layout);
  return 0;
}
template <class Author>
int start_boundary(const void* storage, const scree_boundary_step* step, char* message, size_t message_size) {
  if constexpr (requires(const Author& author, const BoundaryStep& s) { author.start(s); }) {
    const char* problem = static_cast<const Author*>(storage)->start(step_of(*step));
    if (problem) std::snprintf(message, message_size, "%s", problem);
    return problem ? 1 : 0;
  }
  return 0;
}
template <class Author>
void begin_boundary_step(const void* storage, const scree_boundary_step* step) {
  if constexpr (requires(const Author& author, const BoundaryStep& s) { author.begin_step(s); })
    static_cast<const Author*>(storage)->begin_step(step_of(*step));
}
template <class Author>
void finish_boundary_step(const void* storage, const scree_boundary_step* step) {
  if constexpr (requires(const Author& author, const BoundaryStep& s) { author.finish_step(s); })
    static_cast<const Author*>(storage)->finish_step(step_of(*step));
}
template <class Author>
void change_boundary(const void* storage, const void* before, double time_before,
                     const scree_boundary_step* step) {
  static_cast<const Author*>(storage)->change(*static_cast<const Author*>(before), time_before,
                                              step_of(*step));
}
template <class Author>
void linearise_boundary(const void* storage, const scree_boundary_step* step,
                        const scree_linear_walls* walls) {
  const std::size_t count = walls->wall_count;
  LinearWalls equations = {span_of<LinearWall>(walls->walls, count), {walls->stiffness, count * count}};
  static_cast<const Author*>(storage)->linear(step_of(*step), equations);
}
template <class Author>
constexpr auto linear_of() {
  if constexpr (requires(const Author& author, const BoundaryStep& s, LinearWalls& w) {
                  author.linear(s, w);
                })
    return &linearise_boundary<Author>;
  else
    return nullptr;
}
template <class Author>
void rest_boundary(const void* storage, const scree_boundary_step* step, const double (*displacements)[3]) {
  const std::size_t walls = step->plane_count + step->surface_count;
  static_cast<const Author*>(storage)->rest(span_of<const Vec3>(displacements, walls), step_of(*step));
}
template <class Author>
constexpr auto rest_of() {
  if constexpr (requires(const Author& author, const BoundaryStep& s) {
                  author.rest(std::span<const Vec3>(), s);
                })
    return &rest_boundary<Author>;
  else
    return nullptr;
}
template <class Author>
constexpr auto change_of() {
  if constexpr (requires(const Author& author, const BoundaryStep& s) { author.change(author, 0.0, s); })
    return &change_boundary<Author>;
  else
    return nullptr;
}

}  // namespace detail

inline BoundaryScene BoundaryStep::scene() const {
  const scree_boundary_scene& s = *shared;
  return {detail::span_of<const Wall>(s.planes, s.plane_count),
          detail::span_of<const WallLoad>(s.loads, s.plane_count),
          {s.plane_names, s.plane_count},
          vector_of(s.lower),
          vector_of(s.upper),
          {s.periodic[0] != 0, s.periodic[1] != 0, s.periodic[2] != 0},
          vector_of(s.domain_lower),
          vector_of(s.domain_upper)};
}

inline WallLoad BoundaryStep::load_after(std::size_t wall, const Vec3& displacement) const {
  scree_load load;
  displaced_loads->load(displaced_loads->host, std::uint32_t(wall), displacement.component, &load);
  return {vector_of(load.force)};
}

}  // namespace scree

#define SCREE_BOUNDARY_PLUGIN(Author)                                                          \
  static const scree_boundary scree_interface = {sizeof(scree_boundary),                       \
                                                 sizeof(Author),                               \
                                                 &scree::detail::configure_boundary<Author>,   \
                                                 &scree::detail::start_boundary<Author>,       \
                                                 &scree::detail::begin_boundary_step<Author>,  \
                                                 &scree::detail::finish_boundary_step<Author>, \
                                                 scree::detail::change_of<Author>(),           \
                                                 scree::detail::linear_of<Author>(),           \
                                                 scree::detail::rest_of<Author>()};            \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Author>(SCREE_BOUNDARY, scree_interface)))
