#include "scenes.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/run/frame_of.hpp>
#include <scree/wall_surfaces.hpp>

using scree::run::next_view;
using scree::run::SceneBox;

namespace {

SceneBox cube(double low, double high) { return {{low, low, low}, {high, high, high}}; }

bool same(const SceneBox& a, const SceneBox& b) { return a.lower == b.lower && a.upper == b.upper; }

}  // namespace

TEST_CASE("pictures keep their view while the scene fills it, and follow it when it does not", "[run]") {
  const SceneBox first = next_view({}, cube(0, 1));
  CHECK(same(first, cube(0, 1)));
  CHECK(same(next_view(first, cube(0.1, 0.95)), first));  // fills 85 %
  // Collapsed: it leaves the view on two sides, which get room, and has sunk.
  const SceneBox heap = {{-0.5, 0, 0}, {1.5, 1, 0.4}};
  const SceneBox wide = next_view(first, heap);
  CHECK(wide.lower[0] == Approx(-0.5 - 0.15 * 2));
  CHECK(wide.upper[0] == Approx(1.5 + 0.15 * 2));
  CHECK(wide.lower[1] == 0);
  CHECK(wide.upper[2] == 0.4);
  const SceneBox wider = {{-0.7, 0, 0}, {1.7, 1, 0.4}};
  CHECK(same(next_view(wide, wider), wide));                      // within the room
  CHECK(same(next_view(first, cube(0.4, 0.8)), cube(0.4, 0.8)));  // compressed to 40 %
}

TEST_CASE("a picture leaves out walls that are absent, and contacts name the walls that are there", "[run]") {
  using namespace scree::test;
  scree::Scene sc =
      scene(3, 1e-3, {body(1, 1, 1, {{0, 0, 0.99}})}, {{"normal_stiffness", {100}}, {"normal_damping", {0}}});
  add_boundary(sc, "plane", {{"point", {0, 0, 0.5}}, {"normal", {0, 0, 1}}, {"control", {7}}}, "gate");
  add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}}, "floor");
  const scree::pictures::Frame frame = scree::run::frame_of(scree::Simulation(sc), "", cube(0, 1));
  REQUIRE(frame.walls.size() == 1);
  CHECK(frame.walls[0].name == "floor");
  CHECK(frame.contact_wall == std::vector<std::int32_t>{0});
}

TEST_CASE("displacements count from t = 0 without jumps at periodic faces, and groups are named", "[run]") {
  using namespace scree::test;
  scree::Scene sc =
      scene(3, 1e-3, {body(1, 0.1, 1, {{0.5, 0.5, 0.5}}, {{3, 0, -1}}), body(2, 0.1, 1, {{0.2, 0.2, 0}})},
            {{"normal_stiffness", {100}}, {"normal_damping", {0}}});
  add_boundary(sc, "periodic", {{"axes", {0}}, {"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}});
  sc.limits.speed = 100;
  sc.selections = {{"first", {0}}, {"both", {0, 1}}};
  scree::Simulation simulation(sc);
  scree::test::run(simulation, 1000);  // 3 m along x, three periods
  const auto frame = [&](const char* color_by) {
    return scree::run::frame_of(simulation, "", cube(0, 1), color_by);
  };
  const scree::pictures::Frame moved = frame("displacement_x");
  REQUIRE(moved.displacement.size() == 6);
  CHECK(moved.displacement[0] == Approx(3));  // at a constant velocity: of round-off
  CHECK(moved.displacement[1] == 0);
  CHECK(moved.displacement[2] == Approx(-1));
  CHECK(moved.displacement[3] == 0);
  CHECK(moved.group.empty());
  const scree::pictures::Frame grouped = frame("group");
  CHECK(grouped.displacement.empty());
  CHECK(grouped.groups == std::vector<std::string>{"first", "both"});
  CHECK(grouped.group == std::vector<std::int32_t>{0, 1});
}

namespace {

double area_of(const scree::pictures::Surface& surface, std::size_t cell) {
  const auto corner = [&](std::size_t k) {
    const double* const at = surface.points.data() + 3 * surface.cells[3 * cell + k];
    return scree::Vec3{{at[0], at[1], at[2]}};
  };
  return 0.5 * norm(cross(corner(1) - corner(0), corner(2) - corner(0)));
}

// Eight spheres that slide in a turning drum, which they leave after some 300 steps.
scree::Scene spheres_in_mantle(scree::Integration integration) {
  using namespace scree::test;
  std::vector<scree::Body> bodies;
  for (int k = 0; k < 8; ++k)
    bodies.push_back(
        body(k, 0.1, 1, {{0.71 * std::cos(0.7 * k), 0.71 * std::sin(0.7 * k), 0.15 * k}}, {{1, 0.3, 0}}));
  scree::Scene sc = scene(3, 1e-4, bodies,
                          {{"normal_stiffness", {1e4}},
                           {"normal_damping", {1}},
                           {"tangential_stiffness", {4e3}},
                           {"static_friction", {0.3}}});
  sc.sliding_work = true;
  sc.integration = integration;
  const scree::test::Values mantle = {
      {"point", {0, 0, 0.5}}, {"axis", {0, 0, 1}}, {"radius", {0.8}}, {"length", {1.5}}, {"spin", {3}}};
  add_boundary(sc, "cylinder", mantle, "mantle");
  return sc;
}

// Σ traction · area (N).
scree::Vec3 force_on(const scree::pictures::Surface& surface) {
  scree::Vec3 force = {};
  for (std::size_t c = 0; c < surface.cells.size() / 3; ++c)
    for (int k = 0; k < 3; ++k) force[k] += area_of(surface, c) * surface.traction[3 * c + std::size_t(k)];
  return force;
}

}  // namespace

TEST_CASE("stresses on the cells of surfaces add up to the loads", "[run]") {
  scree::Simulation simulation(spheres_in_mantle(scree::Integration::velocity_verlet));
  scree::test::run(simulation, 100);
  const scree::pictures::Frame frame = scree::run::frame_of(simulation, "", cube(-1, 1));
  REQUIRE(frame.surfaces.size() == 1);
  const scree::pictures::Surface& surface = frame.surfaces[0];
  const std::size_t cells = surface.cells.size() / 3;
  REQUIRE(surface.normal_stress.size() == cells);
  REQUIRE(surface.traction.size() == 3 * cells);
  double normal = 0, shear = 0, work = 0, expected_normal = 0, expected_shear = 0, expected_work = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    const double area = area_of(surface, c);
    normal += area * surface.normal_stress[c];
    shear += area * surface.shear_stress[c];
    work += area * surface.sliding_work[c];
  }
  // No facet has two contacts: magnitudes add up as forces do.
  for (std::size_t c = 0; c < frame.contact_count(); ++c)
    if (frame.contact_wall[c] == 0)
      expected_normal += frame.contact_normal_force[c], expected_shear += frame.contact_tangential_force[c];
  for (const double energy : simulation.sliding_work(0)) expected_work += energy;
  // Of round-off.
  REQUIRE(expected_normal > 1);
  REQUIRE(expected_shear > 0.1);
  REQUIRE(expected_work > 1e-3);
  CHECK(normal == Approx(expected_normal).epsilon(1e-12));
  CHECK(shear == Approx(expected_shear).epsilon(1e-12));
  CHECK(work == Approx(expected_work).epsilon(1e-12));
  // A body presses on the cells beside it.
  for (std::size_t c = 0; c < cells; ++c) {
    if (surface.normal_stress[c] == 0) continue;
    double nearest = 1;
    for (std::size_t i = 0; i < frame.particle_count(); ++i) {
      const double* const x = frame.position.data() + 3 * i;
      const double* const corner = surface.points.data() + 3 * surface.cells[3 * c];
      nearest = std::min(nearest, std::hypot(x[0] - corner[0], x[1] - corner[1], x[2] - corner[2]));
    }
    CHECK(nearest < 0.1 + 0.1);  // a radius, and the diagonal of a cell of 70 mm
  }
}

TEST_CASE("tractions add up to the loads at each time, also while contacts open", "[run]") {
  // Loads of the second are of mid-step: contacts that have opened since have their share of them.
  const auto integration = GENERATE(scree::Integration::velocity_verlet, scree::Integration::position_verlet);
  scree::Simulation simulation(spheres_in_mantle(integration));
  for (int k = 0; k < 400; ++k) {
    simulation.step();
    const scree::pictures::Frame frame = scree::run::frame_of(simulation, "", cube(-1, 1));
    const scree_frame_load& load = simulation.surfaces().loads[0];
    const scree::Vec3 force = force_on(frame.surfaces.at(0));
    // Round-off of sums of forces below 100 N.
    for (int i = 0; i < 3; ++i) CHECK(force[i] == Approx(load.force[i]).margin(1e-11));
  }
}
