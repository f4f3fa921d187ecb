// A cylinder, or in 2D a circle.

#include "surface_wall.hpp"

#include <limits>

namespace {

struct Cylinder : SurfaceWall {
  double radius = 0, length = scree::Surface::infinite;

  static constexpr scree::About about = {
      "cylinder",
      "cylinder in 3D, circle in 2D, from inside, from outside or both; it moves and turns as prescribed or by forces",
      "distance ρ from the axis, bodies at ρ < radius (inside) or ρ > radius (outside); open at both ends\n"
      "Hertz contacts: 1/R*² = 1/R (1/R ± 1/radius), the force has an error of 0.02 (R/radius)², inside 0.04 for radius >= 2 R\n"
      "motion along the direction and about spin_axis, each prescribed or by forces:\n"
      "m s\" = F·e + P(t) − γ s', I φ\" = T·a + M(t) − γ' φ'   F, T: of the contacts",
      "Johnson 1985, eq. 4.26"};

  void declare(scree::Declaration& d) {
    d.vector("point", point, "m", "on the axis; with length the middle").required().at_start_only();
    d.vector("axis", axis, "", "along the cylinder; need not be a unit vector; in 2D z").at_start_only();
    d.number("radius", radius, "m", scree::positive, "of the cylinder").required().at_start_only();
    d.number("length", length, "m", scree::positive, "along the axis; infinite without it")
        .optional()
        .at_start_only();
    declare_side_and_motion(d);
  }
  void prepare(const scree::Setup& setup) {
    if (!has_axis(setup)) return;
    const bool flat = setup.dimension() == 2, cut = length < scree::Surface::infinite;
    if (flat && cut) return setup.refuse("length in a 2D scene, whose cylinder is a circle; leave it out");
    const double half = cut ? 0.5 * length : scree::Surface::infinite;
    set(flat ? scree::Surface::ball(radius, -half, half, scree_side(side))
             : scree::Surface::revolved(radius, -half, radius, half, scree_side(side)),
        setup);
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Cylinder)
