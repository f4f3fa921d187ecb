#include "equilibrium/static_configuration.hpp"

#include "scenes.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::response;

namespace {

// Two discs above a floor, periodic along x with the period 10; the second crosses the face in ten steps.
Scene crossing() {
  Scene scene = test::scene(2, 1e-3,
                            {test::body(0, 1, 1, {{2, 1.5, 0}}, {}, {}, 2),
                             test::body(1, 1, 1, {{9.9, 4, 0}}, {{200, 0, 0}}, {}, 2)},
                            {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
  test::add_boundary(scene, "periodic", {{"axes", {0}}, {"lower", {0, 0, 0}}, {"upper", {10, 9, 9}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0.2, 0}}, {"normal", {0, 1, 0}}});
  return scene;
}

}  // namespace

TEST_CASE("a motion has the displacements and turns of bodies, and walls along their directions",
          "[response]") {
  const DegreesOfFreedom freedom(3, 3, {true, true}, {true, true}, {false, true});
  WallEquations walls;
  walls.walls.resize(2);
  walls.walls[1].direction[1] = -1;
  Eigen::VectorXd q(freedom.size());
  for (Eigen::Index k = 0; k < q.size(); ++k) q[k] = double(k) + 1;
  const StaticMotion motion(q, freedom, walls);
  CHECK(motion.displacement == std::vector<Vec3>{{{1, 2, 3}}, {{7, 8, 9}}, {}, {{0, -13, 0}}});
  CHECK(motion.rotation == std::vector<Vec3>{{{4, 5, 6}}, {{10, 11, 12}}, {}, {}});
  // In two dimensions bodies turn about z.
  const StaticMotion plane(Eigen::Vector3d(1, 2, 3), DegreesOfFreedom(2, 1, {true}, {true}), {});
  CHECK(plane.displacement == std::vector<Vec3>{{{1, 2, 0}}});
  CHECK(plane.rotation == std::vector<Vec3>{{{0, 0, 3}}});
}

TEST_CASE("a configuration goes on across periodic faces, and is moved body by body", "[response]") {
  Simulation simulation(crossing());
  test::run(simulation, 10);
  StaticConfiguration at(simulation);
  REQUIRE(at.position.size() == 3);
  CHECK(at.position[1][0] == Approx(11.9));  // 9.9 m and ten steps of 0.2 m
  const Vec3 floor = at.position[2];
  CHECK(floor[1] == Approx(0.2));
  const DegreesOfFreedom freedom(2, 0, {true, true}, {false, false}, {true});
  WallEquations walls;
  walls.walls.resize(1);
  walls.walls[0].direction[1] = 1;
  Eigen::VectorXd q(5);
  q << 0.1, 0.2, 0.3, 0.4, 0.5;
  at.move(StaticMotion(q, freedom, walls));
  CHECK(at.position[0][0] == Approx(2.1));
  CHECK(at.position[1][1] == Approx(4.4));
  const std::vector<scree_plane> planes = at.planes(simulation);
  CHECK(planes[0].point[1] == Approx(0.7));
  for (const double v : planes[0].velocity) CHECK(v == 0);
}
