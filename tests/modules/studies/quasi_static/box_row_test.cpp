#include "box_row.hpp"

#include "scenes.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/wall_surfaces.hpp>

using namespace scree::quasi_static;

namespace {

scree_plane wall(int axis, double side, double at) {
  scree_plane plane{};
  plane.point[axis] = at, plane.normal[axis] = side;
  return plane;
}

scree_load load(int axis, double force) {
  scree_load of_wall{};
  of_wall.force[axis] = force;
  return of_wall;
}

// A box of 2 m x 4 m with these forces of the bodies on its walls (N).
Sample box() {
  Sample sample;
  sample.time = 1.5;
  sample.planes = {wall(0, 1, -1), wall(0, -1, 1), wall(1, 1, 0), wall(1, -1, 4)};
  sample.loads = {load(0, -8), load(0, 12), load(1, -3), load(1, 5)};
  sample.absent = {0, 0, 0, 0};
  sample.contacts = 7, sample.sliding = 2;
  return sample;
}

}  // namespace

TEST_CASE("a row has lengths, stresses and strains of a box") {
  CHECK(BoxRow::lengths(2, box()) == std::vector<double>{2, 4});
  const BoxRow row({2.5, 5});
  CHECK(
      row.head() ==
      "time [s],length_x [m],length_y [m],stress_xx [Pa],stress_yy [Pa],strain_xx,strain_yy,contacts,sliding,dynamic\n");
  // Stresses: the mean force on both walls over the length of the wall (of a disc 1 m thick). Strains:
  // shorter by a fifth.
  CHECK(row.line(box()) == "1.5,2,4,2.5,2,0.19999999999999996,0.19999999999999996,7,2,0\n");
  CHECK(row.charted(box()).value == 0);
  Sample moving = box();
  moving.planes[3] = wall(1, -1, 4.5);
  moving.dynamic = true;
  // L_y/L_y0 − L_x/L_x0
  CHECK(row.charted(moving).value == Approx(0.9 - 0.8));
  CHECK(row.line(moving).ends_with(",1\n"));
}

TEST_CASE("along an axis with one wall or none a row has no columns, and without a box no stress") {
  Sample sample = box();
  sample.planes.pop_back(), sample.loads.pop_back(), sample.absent.pop_back();
  CHECK(BoxRow::lengths(2, sample) == std::vector<double>{2, 0});
  const BoxRow row({2.5, 0});
  CHECK(row.head() == "time [s],length_x [m],strain_xx,contacts,sliding,dynamic\n");
  CHECK(row.line(sample) == "1.5,2,0.19999999999999996,7,2,0\n");
  CHECK(std::isnan(row.charted(sample).value));
}

TEST_CASE("a wall that is absent bears nothing, and another behind it is the end of the box") {
  Sample sample = box();
  sample.absent[0] = 1;
  sample.loads[0] = load(0, 0);
  CHECK(BoxRow({2.5, 5}).line(sample).starts_with("1.5,2,4,3,2,"));
  sample.planes.push_back(wall(0, 1, -2)), sample.loads.push_back(load(0, -8)), sample.absent.push_back(0);
  CHECK(BoxRow::lengths(2, sample) == std::vector<double>{3, 4});
  CHECK(BoxRow({2.5, 5}).line(sample).starts_with("1.5,3,4,2.5,"));
}

// A lid that moves along its direction, and one that does not.
TEST_CASE("a row has the displacement and the force of a surface that forces move", "[surfaces]") {
  using namespace scree;
  Scene scene = test::scene(3, 1e-3, {test::body(0, 1, 1, {})},
                            {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
  test::add_boundary(scene, "disc", {{"point", {0, 0, -2}}, {"normal", {0, 0, 1}}, {"radius", {1}}}, "floor");
  test::add_boundary(scene, "disc",
                     {{"point", {0, 0, 2}},
                      {"normal", {0, 0, -1}},
                      {"radius", {1}},
                      {"direction", {0, 0.6, -0.8}},
                      {"force", {1}},
                      {"mass", {1}}},
                     "lid");
  const Simulation simulation(scene);
  Sample sample;
  sample.frames = simulation.surfaces().frames;
  sample.surface_loads.resize(2);
  SurfaceColumns columns(simulation);
  columns.begin(sample);
  const BoxRow row({0, 0, 0}, columns);
  CHECK(row.head() == "time [s],displacement_lid [m],force_lid [N],contacts,sliding,dynamic\n");
  CHECK(row.charted_surface() == "lid");
  sample.frames[1].position[1] += 0.3, sample.frames[1].position[2] -= 0.4;
  sample.surface_loads[1].force[2] = 5;  // of the bodies, which the lid presses downwards
  CHECK(row.charted(sample).value == Approx(0.5));
  CHECK(row.charted(sample).force == Approx(4));
}
