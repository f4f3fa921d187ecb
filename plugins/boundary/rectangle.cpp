// A rectangle, or in 2D a segment of a line.

#include "surface_wall.hpp"

#include <cmath>
#include <limits>

namespace {

struct Rectangle : SurfaceWall {
  std::array<double, 3> along = {std::numeric_limits<double>::quiet_NaN()};
  double length = 0, width = scree::Surface::infinite;

  static constexpr scree::About about = {
      "rectangle",
      "flat rectangle in 3D, segment of a line in 2D; it moves and turns as prescribed or by forces",
      "length along `along`, width across it;   outside: where the normal points\n"
      "motion along the direction and about spin_axis, each prescribed or by forces:\n"
      "m s\" = F·e + P(t) − γ s', I φ\" = T·a + M(t) − γ' φ'   F, T: of the contacts",
      "—"};

  void declare(scree::Declaration& d) {
    d.vector("point", point, "m", "its middle").required().at_start_only();
    d.vector("normal", axis, "", "across it; need not be a unit vector").required().at_start_only();
    d.vector("along", along, "",
             "direction of the length, of which the part in the rectangle counts; in 3D alone")
        .optional()
        .at_start_only();
    d.number("length", length, "m", scree::positive, "from edge to edge").required().at_start_only();
    d.number("width", width, "m", scree::positive, "across the length, in 3D; infinite without it")
        .optional()
        .at_start_only();
    declare_side_and_motion(d);
  }
  void prepare(const scree::Setup& setup) {
    const bool flat = setup.dimension() == 2;
    if (flat) axis[2] = 0;
    if (!scree::make_unit(axis)) return setup.refuse("normal has length 0; give a vector such as [0, 1, 0]");
    const scree::Vec3 n = scree::vector_of(axis);
    if (flat) {
      if (!std::isnan(along[0]) || width < scree::Surface::infinite)
        return setup.refuse("along and width are of 3D scenes; leave them out");
      orientation = scree::Rotation::to_axes({{n[1], -n[0], 0}}, {{0, 0, 1}});
    } else {
      if (std::isnan(along[0])) return setup.refuse("along is missing; give the direction of the length");
      const scree::Vec3 given = scree::vector_of(along);
      scree::Vec3 x = given - dot(given, n) * n;
      if (!(norm(x) > 1e-9 * norm(given)))
        return setup.refuse("along is parallel to the normal; give a direction in the rectangle");
      orientation = scree::Rotation::to_axes(1 / norm(x) * x, n);
    }
    set(scree::Surface::flat(0.5 * length, 0.5 * width, scree_side(side)), setup);
  }
  const char* start(const scree::BoundaryStep& s) const {
    SurfaceWall::start(s);
    s.frames[0].orientation = orientation;
    return nullptr;
  }

 private:
  scree::Rotation orientation;
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Rectangle)
