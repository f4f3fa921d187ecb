// A sphere, or in 2D a circle, whole or cut.

#include "surface_wall.hpp"

namespace {

struct Sphere : SurfaceWall {
  double radius = 0, low = -scree::Surface::infinite, high = scree::Surface::infinite;

  static constexpr scree::About about = {
      "sphere",
      "sphere in 3D, circle in 2D, whole or the part between two heights; it moves and turns as prescribed or by forces",
      "the part of the sphere about point with low <= height along the axis <= high;   Hertz contacts: 1/R* = 1/R ± 1/radius\n"
      "motion along the direction and about spin_axis, each prescribed or by forces:\n"
      "m s\" = F·e + P(t) − γ s', I φ\" = T·a + M(t) − γ' φ'   F, T: of the contacts",
      "—"};

  void declare(scree::Declaration& d) {
    d.vector("point", point, "m", "its centre").required().at_start_only();
    d.number("radius", radius, "m", scree::positive, "of the sphere").required().at_start_only();
    d.vector("axis", axis, "", "along which it is cut; need not be a unit vector").at_start_only();
    d.number("low", low, "m", scree::any_number, "height of the lower cut, from the centre along the axis")
        .optional()
        .at_start_only();
    d.number("high", high, "m", scree::any_number, "height of the upper cut").optional().at_start_only();
    declare_side_and_motion(d);
  }
  void prepare(const scree::Setup& setup) {
    const bool flat = setup.dimension() == 2;
    up = flat ? in_plane(axis) : scree::Vec3{};
    if (flat && !(norm(up) > 0)) up = {{0, 1, 0}};
    if (!has_axis(setup)) return;
    if (!(low < high && low < radius && high > -radius))
      return setup.refuse("low and high leave nothing of the sphere; give low < high within the radius");
    set(scree::Surface::ball(radius, low, high, scree_side(side)), setup);
  }
  const char* start(const scree::BoundaryStep& s) const {
    SurfaceWall::start(s);
    if (s.dimension == 2) s.frames[0].orientation = scree::Rotation::to_axes(across(up), {{0, 0, 1}});
    return nullptr;
  }

 private:
  scree::Vec3 up = {};  // in 2D the direction of heights
  static scree::Vec3 in_plane(const std::array<double, 3>& v) {
    const scree::Vec3 flat = {{v[0], v[1], 0}};
    return norm(flat) > 0 ? 1 / norm(flat) * flat : flat;
  }
  static scree::Vec3 across(const scree::Vec3& v) { return {{v[1], -v[0], 0}}; }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Sphere)
