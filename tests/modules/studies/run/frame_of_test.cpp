#include "scenes.hpp"

#include <catch2/catch.hpp>

#include <scree/run/frame_of.hpp>

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
