// A flat disc, whole or with a round hole.

#include "surface_wall.hpp"

namespace {

struct Disc : SurfaceWall {
  double radius = 0, hole = 0;

  static constexpr scree::About about = {
      "disc", "flat disc, whole or with a round hole; it moves and turns as prescribed",
      "hole <= ρ <= radius in the plane through point;   outside: where the normal points\n"
      "moves by ∫velocity dt along the direction, turns by ∫spin dt about spin_axis",
      "—"};

  void declare(scree::Declaration& d) {
    d.vector("point", point, "m", "its centre").required().at_start_only();
    d.vector("normal", axis, "", "across the disc; need not be a unit vector").required().at_start_only();
    d.number("radius", radius, "m", scree::positive, "of the disc").required().at_start_only();
    d.number("hole", hole, "m", scree::non_negative, "radius of the hole").at_start_only();
    declare_side_and_motion(d);
  }
  void prepare(const scree::Setup& setup) {
    if (setup.dimension() == 2)
      return setup.refuse("a 2D scene has no discs as walls; choose rectangle, which is a segment there");
    if (const char* const problem = check(setup)) return setup.refuse(problem);
    if (!(hole < radius)) return setup.refuse("hole is not below radius; give a smaller one");
    surface = scree::Surface::revolved(radius, 0, hole, 0, scree_side(side));
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Disc)
