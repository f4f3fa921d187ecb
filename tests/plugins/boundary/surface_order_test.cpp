#include "meshes.hpp"
#include "wall_support.hpp"

#include <cmath>
#include <functional>

#include <catch2/catch.hpp>

// The order of tangential springs on walls that turn or are curved.

using namespace scree;
using namespace scree::test;

namespace {

constexpr double ball_radius = 0.01, ball_mass = 0.0105, ball_weight = 9.81 * ball_mass, wall_stiffness = 5e4;
const Values law_of_order = {{"normal_stiffness", {wall_stiffness}},
                             {"normal_damping", {3}},
                             {"tangential_stiffness", {2e4}},
                             {"tangential_damping", {3}},
                             {"static_friction", {0.9}}};

// A ball that rests on a wall at x and rolls on it without slip.
struct Rolling {
  const char* name;
  std::function<void(Scene&)> add_wall;
  Vec3 x, velocity, spin, gravity;
  // (s) until points are painted anew, at the end of a step, whose moment is of first order; 0: not in 0.1 s.
  double follows;
};

struct After {
  Vec3 place;
  double residual;
};

After after(const Rolling& c, const std::string& law, double step) {
  Scene sc = scene(3, step, {body(1, ball_radius, ball_mass, c.x, c.velocity, c.spin)}, law_of_order, law);
  c.add_wall(sc);
  add_body_force(sc, "gravity", {{"acceleration", {c.gravity[0], c.gravity[1], c.gravity[2]}}});
  Simulation s(sc);
  const double duration = law == "sphere_path_independent" && c.follows > 0 ? c.follows : 0.1;
  run(s, std::uint64_t(std::llround(duration / step)));
  return {position(s, 0), std::abs(s.energy_residual())};
}

std::vector<Rolling> rolling_balls() {
  constexpr double sunk = ball_radius - ball_weight / wall_stiffness, hollow = 0.05;
  const auto disc = [](Scene& sc) {
    add_boundary(sc, "disc",
                 {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {0.4}}, {"spin", {10}}});
  };
  const auto mesh = [](Scene& sc) {
    add_boundary(sc, "mesh",
                 {{"file", flat_mesh(0.4, 40, 40, 0.2).numbers()}, {"spin", {10}}, {"spin_axis", {0, 0, 1}}});
  };
  const auto cylinder = [](Scene& sc) {
    add_boundary(sc, "cylinder",
                 {{"point", {0, 0, 0}}, {"axis", {0, 1, 0}}, {"radius", {hollow}}, {"spin", {3}}});
  };
  const auto ball = [](Scene& sc) {
    add_boundary(
        sc, "sphere",
        {{"point", {0, 0, -0.03}}, {"radius", {0.03}}, {"velocity", {0.05}}, {"direction", {1, 0, 0}}});
  };
  const Vec3 down = {{0, 0, -9.81}};
  return {
      {"turntable", disc, {{0.03, 0, sunk}}, {{0, 0.1, 0}}, {{20, 0, 0}}, down, 0.004},
      {"turntable of triangles", mesh, {{0.03, 0, sunk}}, {{0, 0.1, 0}}, {{20, 0, 0}}, down, 0.004},
      {"turning cylinder", cylinder, {{0, 0, sunk - hollow}}, {{0.3, 0.1, 0}}, {{-10, 45, 5}}, down, 0.0008},
      {"moving ball", ball, {{0.002, 0, sunk}}, {{0.05, 0.05, 0}}, {{-5, 0, 0}}, down, 0}};
}

}  // namespace

// Springs advance by what the contact points move at the middle of a step, with the normal there and the
// material of the wall that is there then.
TEST_CASE("springs on walls that turn and are curved are of second order", "[surfaces]") {
  for (const std::string law : {"linear_spring_dashpot", "sphere_path_independent"})
    for (const Rolling& c : rolling_balls()) {
      const After coarse = after(c, law, 4e-5), middle = after(c, law, 2e-5), fine = after(c, law, 1e-5);
      const double ratio = norm(coarse.place - middle.place) / norm(middle.place - fine.place);
      INFO(law << ", " << c.name << ": changes with the step " << norm(coarse.place - middle.place) << " and "
               << norm(middle.place - fine.place) << " m, residuals " << coarse.residual << ", "
               << fine.residual);
      CHECK(ratio > 3.5);
      CHECK(fine.residual < 0.15 * coarse.residual + 1e-12);
    }
}
