// A drum with flat faces about the axis z, in 2D a polygon, which moves and turns.

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <scree/plugin/rigid_motion.hpp>

namespace {

constexpr std::size_t most_faces = 64;

struct PolygonDrum {
  double radius = 0, faces = 24;
  scree::RigidMotion motion;
  std::array<scree::Surface, most_faces> surfaces = {};

  static constexpr scree::About about = {
      "polygon_drum", "drum with flat faces about the axis z",
      "face k touches the circle R at the angle 2π k/N; it is seen from inside", "—"};

  void declare(scree::Declaration& d) {
    d.number("radius", radius, "m", scree::positive, "R of the inscribed circle").required().at_start_only();
    d.number("faces", faces, "", {.minimum = 3, .maximum = double(most_faces)}, "N, rounded down")
        .at_start_only();
    motion.declare(d);
  }
  void prepare(const scree::Setup& setup) {
    const double half = radius * std::tan(std::numbers::pi / std::floor(faces));
    surfaces.fill(scree::Surface::flat(half, scree::Surface::infinite, SCREE_OUTSIDE));
    const double reach = std::hypot(radius, half);
    const std::string problem = motion.prepare({{0, 0, 1}, setup.dimension(), reach});
    if (!problem.empty()) setup.refuse(problem.c_str());
  }
  void describe(scree::BoundaryLayout& layout) const {
    layout.surfaces = {surfaces.data(), std::size_t(faces)};
    motion.describe(layout);
  }

  const char* start(const scree::BoundaryStep& s) const {
    for (std::size_t k = 0; k < s.frames.size(); ++k) {
      const double angle = 2 * std::numbers::pi * double(k) / double(s.frames.size());
      const scree::Vec3 outwards = {{std::cos(angle), std::sin(angle), 0}},
                        along = cross({{0, 0, 1}}, outwards);
      s.frames[k] = {};
      s.frames[k].position = radius * outwards;
      s.frames[k].orientation = s.dimension == 2 ? scree::Rotation::to_axes(along, {{0, 0, 1}})
                                                 : scree::Rotation::to_axes(along, -outwards);
    }
    motion.start(s, {});
    return nullptr;
  }
  void begin_step(const scree::BoundaryStep& s) const { motion.begin(s); }
  void finish_step(const scree::BoundaryStep& s) const { motion.finish(s); }
  void change(const PolygonDrum& before, double, const scree::BoundaryStep& s) const {
    motion.change(before.motion, s);
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(PolygonDrum)
