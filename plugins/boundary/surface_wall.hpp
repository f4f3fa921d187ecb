#pragma once

#include <array>

#include <scree/plugin/prescribed_motion.hpp>

// What boundaries of one surface have in common: where it is, on which side bodies are, and how it moves.
struct SurfaceWall {
  std::array<double, 3> point = {}, axis = {0, 0, 1};
  int side = 0;  // in the order of scree_side
  scree::PrescribedMotion motion;
  scree::Surface surface = {};

  void declare_side_and_motion(scree::Declaration& d) {
    d.choice("side", side, "both|outside|inside", "where bodies are").at_start_only();
    motion.declare(d);
  }
  // Makes the axis a unit vector, and checks the motion. Returns the problem and a remedy, or null.
  const char* check(const scree::Setup& setup) {
    if (setup.dimension() == 2) axis = {0, 0, 1};
    if (!scree::make_unit(axis)) return "its axis or normal has length 0; give a vector such as [0, 0, 1]";
    return motion.check(axis, setup.dimension());
  }

  void describe(scree::BoundaryLayout& layout) const {
    layout.surfaces = {&surface, 1};
    layout.state = scree::PrescribedMotion::state_width;
    layout.still = !motion.moves();
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
  void change(const SurfaceWall&, double, const scree::BoundaryStep& s) const { motion.change(s); }
};
