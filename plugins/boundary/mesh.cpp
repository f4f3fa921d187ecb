// A triangulated surface of any shape.

#include "surface_wall.hpp"

namespace {

struct Mesh : SurfaceWall {
  scree_value triangles = {};
  double scale = 1, smooth_angle = 0.35;

  static constexpr scree::About about = {
      "mesh",
      "surface of any shape from a file with triangles, from both sides, inside or outside; it moves and turns",
      "a body touches it where its distance has a minimum: of two spots that the centre sees within smooth_angle the\n"
      "nearer counts, so that flat and smooth parts are touched once, sharp hollow edges twice; springs follow their spots\n"
      "normal from the spot to the centre;   Hertz contacts: R* = R, as on a plane\n"
      "motion along the direction and about spin_axis, each prescribed or by forces:\n"
      "m s\" = F·e + P(t) − γ s', I φ\" = T·a + M(t) − γ' φ'   F, T: of the contacts",
      "—"};

  void declare(scree::Declaration& d) {
    d.mesh("file", triangles, "STL, OBJ, PLY or VTP; relative to the scenario").required().at_start_only();
    d.number("scale", scale, "", scree::positive, "factor of its coordinates, such as 0.001 for mm")
        .at_start_only();
    d.vector("translation", point, "m", "added to the scaled coordinates; its spin is about this point")
        .at_start_only();
    d.number("smooth_angle", smooth_angle, "rad", {.minimum = 0, .maximum = 1},
             "triangles that bend by less are one smooth surface; 0.35 is 20 degrees")
        .at_start_only();
    declare_side_and_motion(d);
  }
  void prepare(const scree::Setup& setup) {
    if (setup.dimension() == 2)
      return setup.refuse(
          "a 2D scene has no meshes; choose rectangle, which is a segment there, for each edge");
    if (!has_axis(setup)) return;
    set(scree::Surface::mesh(triangles, scale, smooth_angle, scree_side(side)), setup);
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Mesh)
