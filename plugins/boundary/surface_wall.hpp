#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <scree/plugin/rigid_motion.hpp>

// What boundaries of one surface have in common: where it is, on which side bodies are, and how it moves.
struct SurfaceWall {
  std::array<double, 3> point = {}, axis = {0, 0, 1};
  int side = 0;  // in the order of scree_side
  scree::RigidMotion motion;
  scree::Surface surface = {};

  void declare_side_and_motion(scree::Declaration& d) {
    d.choice("side", side, "both|outside|inside", "where bodies are").at_start_only();
    motion.declare(d);
  }
  // Makes the axis a unit vector, in 2D z; otherwise refuses.
  bool has_axis(const scree::Setup& setup) {
    if (setup.dimension() == 2) axis = {0, 0, 1};
    if (scree::make_unit(axis)) return true;
    setup.refuse("its axis or normal has length 0; give a vector such as [0, 0, 1]");
    return false;
  }
  // Sets the surface, and prepares its motion.
  void set(const scree::Surface& shape, const scree::Setup& setup) {
    surface = shape;
    motion.set_area(projected_area(setup.dimension()));
    const double farthest = motion.has_torque() ? reach(setup.dimension()) : 0;
    const std::string problem =
        motion.prepare({axis, setup.dimension(), farthest, surface.shape != SCREE_MESH});
    if (!problem.empty()) setup.refuse(problem.c_str());
  }

  void describe(scree::BoundaryLayout& layout) const {
    layout.surfaces = {&surface, 1};
    motion.describe(layout);
  }
  const char* start(const scree::BoundaryStep& s) const {
    const scree::Vec3 place = scree::vector_of(point);
    s.frames[0] = {.position = place,
                   .orientation = scree::Rotation::from_z_to(scree::vector_of(axis)),
                   .velocity = {},
                   .spin = {},
                   .mid_velocity = {},
                   .mid_spin = {}};
    motion.start(s, place);
    return nullptr;
  }
  void begin_step(const scree::BoundaryStep& s) const { motion.begin(s); }
  void finish_step(const scree::BoundaryStep& s) const { motion.finish(s); }
  void change(const SurfaceWall& before, double, const scree::BoundaryStep& s) const {
    motion.change(before.motion, s);
  }
  void linear(const scree::BoundaryStep& s, scree::LinearWalls& walls) const { motion.linear(s, walls); }
  void rest(std::span<const scree::Vec3> displacements, const scree::BoundaryStep& s) const {
    motion.rest(displacements, s);
  }

 private:
  // Seen along the direction of the motion (m², in 2D m × 1 m); 0 if it is not known.
  double projected_area(int dimension) const {
    const double along = std::abs(dot(scree::vector_of(axis), scree::vector_of(motion.direction_with(axis))));
    const auto& [a, b, c, e] = surface.size;
    double area = 0;
    if (surface.shape == SCREE_FLAT) area = dimension == 2 ? 2 * a * along : 4 * a * b * along;
    if (surface.shape == SCREE_REVOLVED && b == e) area = std::numbers::pi * std::abs(a * a - c * c) * along;
    if (surface.shape == SCREE_BALL && b <= -a && c >= a)
      area = dimension == 2 ? 2 * a : std::numbers::pi * a * a;
    return std::isfinite(area) ? area : 0;
  }
  // Largest distance (m) of a point of it from the axis about which it turns.
  double reach(int dimension) const {
    const scree::Vec3 own = scree::vector_of(axis),
                      apart = motion.spin_point()
                                  ? scree::vector_of(*motion.spin_point()) - scree::vector_of(point)
                                  : scree::Vec3{};
    const scree::Vec3 turn = scree::vector_of(motion.spin_axis().value_or(axis));
    const double off = norm(cross(own, apart));
    const bool about_own = !(norm(cross(own, turn)) > 1e-9 * norm(turn)) && !(off > 1e-9 * norm(apart));
    const auto& [a, b, c, e] = surface.size;
    if (surface.shape == SCREE_REVOLVED && about_own) return std::max(a, c);
    if (surface.shape == SCREE_REVOLVED) return std::max(std::hypot(a, b), std::hypot(c, e)) + norm(apart);
    if (surface.shape == SCREE_FLAT) return (dimension == 2 ? a : std::hypot(a, b)) + norm(apart);
    return (surface.shape == SCREE_BALL ? a : reach_of_mesh()) + norm(apart);
  }
  // The host refuses numbers that are no mesh after this.
  double reach_of_mesh() const {
    const scree_surface& mesh = surface;
    const double points = mesh.mesh_size > 0 ? mesh.mesh[0] : 0;
    double reach = 0;
    for (std::uint64_t at = 1; at + 3 <= mesh.mesh_size && double(at) < 1 + 3 * points; at += 3)
      reach = std::max(reach, mesh.size[0] * std::hypot(mesh.mesh[at], mesh.mesh[at + 1], mesh.mesh[at + 2]));
    return reach;
  }
};
