// A cone, whole or cut.

#include "surface_wall.hpp"

namespace {

struct Cone : SurfaceWall {
  double radius = 0, end_radius = 0, length = 0;

  static constexpr scree::About about = {
      "cone",
      "cone, whole or cut, from inside, from outside or both; it moves and turns as prescribed or by forces",
      "the line from `radius` at `point` to `end_radius` at point + length axis, turned about the axis; open at both ends\n"
      "outside: away from the axis;   Hertz contacts: 1/R*² = 1/R (1/R ± cos α/ρ), with α half of its angle and ρ the\n"
      "distance of the contact from the axis, with an error of second order in R/ρ\n"
      "motion along the direction and about spin_axis, each prescribed or by forces:\n"
      "m s\" = F·e + P(t) − γ s', I φ\" = T·a + M(t) − γ' φ'   F, T: of the contacts",
      "—"};

  void declare(scree::Declaration& d) {
    d.vector("point", point, "m", "on the axis, at one end").required().at_start_only();
    d.vector("axis", axis, "", "from there to the other end; need not be a unit vector")
        .required()
        .at_start_only();
    d.number("radius", radius, "m", scree::non_negative, "at point").required().at_start_only();
    d.number("end_radius", end_radius, "m", scree::non_negative, "at the other end").at_start_only();
    d.number("length", length, "m", scree::positive, "along the axis").required().at_start_only();
    declare_side_and_motion(d);
  }
  void prepare(const scree::Setup& setup) {
    if (setup.dimension() == 2)
      return setup.refuse("a 2D scene has no cones; choose rectangle, which is a segment there");
    if (!has_axis(setup)) return;
    if (!(radius + end_radius > 0)) return setup.refuse("both radii are 0; give one of them");
    set(scree::Surface::revolved(radius, 0, end_radius, length, scree_side(side)), setup);
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Cone)
