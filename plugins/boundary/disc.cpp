// A flat disc, whole or with a round hole.

#include "surface_wall.hpp"

namespace {

struct Disc : SurfaceWall {
  double radius = 0, hole = 0;

  static constexpr scree::About about = {
      "disc", "flat disc, whole or with a round hole; it moves and turns as prescribed or by forces",
      "hole <= ρ <= radius in the plane through point;   outside: where the normal points\n"
      "motion along the direction and about spin_axis, each prescribed or by forces:\n"
      "m s\" = F·e + P(t) − γ s', I φ\" = T·a + M(t) − γ' φ'   F, T: of the contacts",
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
    if (!has_axis(setup)) return;
    if (!(hole < radius)) return setup.refuse("hole is not below radius; give a smaller one");
    set(scree::Surface::revolved(radius, 0, hole, 0, scree_side(side)), setup);
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Disc)
