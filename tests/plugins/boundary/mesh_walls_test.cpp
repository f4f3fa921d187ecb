#include "meshes.hpp"
#include "sanitized.hpp"
#include "wall_support.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/state.hpp>
#include <scree/wall_surfaces.hpp>

// Bodies on triangulated walls, against planes and exact shapes.

using namespace scree;
using namespace scree::test;

namespace {

const Values frictional = {{"normal_stiffness", {1e5}},
                           {"restitution", {0.7}},
                           {"tangential_stiffness", {3e4}},
                           {"static_friction", {0.4}}};
const Values lossless = {{"normal_stiffness", {6e3}},
                         {"normal_damping", {0}},
                         {"tangential_stiffness", {6e3}},
                         {"static_friction", {10}}};

Values mesh_values(const Mesh& mesh, Values more = {}) {
  more.push_back({"file", mesh.numbers()});
  return more;
}

// Spheres that fall on z = 0, slide, spin and roll.
std::vector<Body> thrown_spheres() {
  std::vector<Body> bodies;
  for (std::int64_t k = 0; k < 9; ++k)
    bodies.push_back(
        body(k, 0.01, 0.01, {{0.04 * double(k % 3) - 0.041, 0.04 * double(k / 3) - 0.039, 0.0101}},
             {{0.3 - 0.02 * double(k), 0.05 * double(k) - 0.2, -0.2}}, {{double(k), 20 - 3 * double(k), 5}}));
  return bodies;
}

struct Motion {
  std::vector<Vec3> places, velocities, spins;
};
Motion motion_of(const Simulation& s) {
  Motion m;
  for (std::size_t i = 0; i < s.particles().size(); ++i) {
    const Body b = s.particles().body(i);
    m.places.push_back(b.position), m.velocities.push_back(b.velocity), m.spins.push_back(b.spin);
  }
  return m;
}

// Largest difference, as a part of the largest number of its kind.
double difference(const Motion& one, const Motion& other) {
  double most = 0;
  for (const auto part : {&Motion::places, &Motion::velocities, &Motion::spins}) {
    double largest = 0, apart = 0;
    for (std::size_t i = 0; i < one.places.size(); ++i) {
      largest = std::max(largest, norm((one.*part)[i]));
      apart = std::max(apart, norm((one.*part)[i] - (other.*part)[i]));
    }
    most = std::max(most, apart / largest);
  }
  return most;
}

void add_weight(Scene& s, const Vec3& g = {{0, 0, -9.81}}) {
  add_body_force(s, "gravity", {{"acceleration", {g[0], g[1], g[2]}}});
}

void add_box_of_planes(Scene& s, const Vec3& half) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      std::vector<double> point = {0, 0, 0}, normal = {0, 0, 0};
      point[std::size_t(axis)] = sign * half[axis], normal[std::size_t(axis)] = -sign;
      add_boundary(s, "plane", {{"point", point}, {"normal", normal}},
                   "plane_" + std::to_string(2 * axis + (sign > 0)));
    }
}

}  // namespace

// Round-off of 4000 steps, in which impacts and slip multiply it: 1e-16 × 4000 and a margin of 3.
TEST_CASE("a flat mesh moves bodies as a plane does, whatever its triangles", "[surfaces]") {
  const std::string law = GENERATE("linear_spring_dashpot", "sphere_path_independent");
  CAPTURE(law);
  const auto run_on = [&](const std::function<void(Scene&)>& add_wall) {
    Scene sc = scene(3, 2e-5, thrown_spheres(), frictional, law);
    add_wall(sc);
    add_weight(sc);
    Simulation s(sc);
    run(s, 4000);
    CHECK(s.max_overlap_ratio() > 5e-3);
    return motion_of(s);
  };
  const Motion plane = run_on([](Scene& sc) {
    add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  });
  struct Flat {
    const char* name;
    Mesh mesh;
  };
  Mesh overhanging = flat_mesh(0.5, 3, 2);  // a second layer with other triangles in the same plane
  const Mesh other = flat_mesh(0.45, 5, 7, 0.4);
  for (const auto& t : other.triangles) {
    for (const std::size_t p : t) overhanging.points.push_back(other.points[p]);
    const std::size_t n = overhanging.points.size();
    overhanging.add(n - 3, n - 1, n - 2);
  }
  for (const Flat& flat :
       {Flat{"two triangles", flat_mesh(0.5, 1, 1)}, Flat{"grid", flat_mesh(0.5, 37, 41)},
        Flat{"corners off the lines", flat_mesh(0.5, 20, 20, 0.37)}, Flat{"slivers", flat_mesh(0.5, 5000, 1)},
        Flat{"fine slivers", flat_mesh(0.5, 2, 20000)}, Flat{"two layers", overhanging}}) {
    INFO(flat.name);
    const Motion mesh = run_on([&](Scene& sc) { add_boundary(sc, "mesh", mesh_values(flat.mesh)); });
    CHECK(difference(mesh, plane) < 1.2e-12);
  }
}

// Springs that are as long as they can be when bodies leave, from faces, edges and corners: their energy is
// in the balance, as at planes.
TEST_CASE("what springs let go of at a mesh is in the balance", "[surfaces]") {
  const std::string law = GENERATE("linear_spring_dashpot", "sphere_path_independent");
  CAPTURE(law);
  const auto energies = [&](const std::function<void(Scene&)>& add_walls) {
    std::vector<Body> bodies;
    for (std::int64_t k = 0; k < 3; ++k)
      bodies.push_back(body(k, 0.01, 0.01, {{0.02 * double(k) - 0.02, 0, 0}},
                            {{0.9, 0.6 + 0.1 * double(k), -0.7}}, {{5, 30, -20}}));
    Scene sc = scene(3, 1e-5, bodies,
                     {{"normal_stiffness", {1e4}},
                      {"normal_damping", {0}},
                      {"tangential_stiffness", {7e3}},
                      {"static_friction", {1e9}}},
                     law);
    add_walls(sc);
    Simulation s(sc);
    run(s, 20000);
    // Steps of a fiftieth of a contact: 1e-2.
    CHECK(std::abs(s.energy_residual()) < 1e-2);
    return s.energy().dissipated_release;
  };
  const Vec3 half = {{0.05, 0.04, 0.03}};
  const double planes = energies([&](Scene& sc) { add_box_of_planes(sc, half); });
  const double mesh = energies([&](Scene& sc) {
    add_boundary(sc, "mesh", mesh_values(box_mesh(half), {{"side", {2}}}));
  });
  CHECK(planes > 1e-5);
  CHECK(mesh == Approx(planes).epsilon(1e-6));
}

// A spot goes on while it moves by less than 0.35 rad in a step, however small the angle of the rule.
TEST_CASE("springs go on where triangles count each by itself", "[surfaces]") {
  Scene sc = scene(3, 2e-5, {body(1, 0.01, 0.01, {{0.003, 0.001, 0.00999}})}, frictional);
  add_boundary(sc, "mesh", mesh_values(flat_mesh(0.1, 20, 20), {{"smooth_angle", {0}}}));
  add_weight(sc, {{1, 0.5, -9.81}});
  Simulation s(sc);
  run(s, 20000);
  CHECK(std::abs(s.energy_residual()) <
        1e-4);  // springs that were lost would miss all of the work of the slope
}

// The mesh is as long as the period, which a ball passes five times. Places differ by the round-off of the
// period.
TEST_CASE("springs on a mesh go on across periodic faces", "[surfaces]") {
  const std::string law = GENERATE("linear_spring_dashpot", "sphere_path_independent");
  CAPTURE(law);
  const auto rolled = [&](const std::function<void(Scene&)>& add_wall) {
    Scene sc = scene(3, 2e-5, {body(1, 0.01, 0.01, {{0.001, 0.002, 0.00999}}, {{0, 1, 0}}, {{9, 0, 3}})},
                     frictional, law);
    add_boundary(sc, "periodic", {{"axes", {1}}, {"lower", {0, -0.05, 0}}, {"upper", {0, 0.05, 0}}});
    add_wall(sc);
    add_weight(sc);
    sc.skin = 0.002;
    Simulation s(sc);
    run(s, 30000);
    CHECK(s.max_overlap_ratio() < 0.01);
    return motion_of(s);
  };
  const Motion plane = rolled([](Scene& sc) {
    add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  });
  const Motion mesh =
      rolled([](Scene& sc) { add_boundary(sc, "mesh", mesh_values(flat_mesh(0.05, 7, 9, 0.2))); });
  CHECK(difference(mesh, plane) < 1e-10);
}

// Of a box: in its corners and along its edges a body touches two or three faces, each with its own spring.
TEST_CASE("a box of triangles is a box of planes", "[surfaces]") {
  const Vec3 half = {{0.05, 0.04, 0.03}};
  std::vector<Body> bodies;
  for (std::int64_t k = 0; k < 8; ++k) {
    const double sign_x = k % 2 ? 1 : -1, sign_y = k % 4 > 1 ? 1 : -1, sign_z = k > 3 ? 1 : -1;
    bodies.push_back(body(k, 0.01, 0.01, {{sign_x * 0.025, sign_y * 0.02, sign_z * 0.015}},
                          {{1.0 - 0.2 * double(k), 0.7, 0.3 * double(k) - 1}}, {{double(k), -4, 9}}));
  }
  const auto run_in = [&](bool mesh, std::size_t n, const Values& law) {
    Scene sc = scene(3, 2e-5, bodies, law);
    if (mesh)
      add_boundary(sc, "mesh", mesh_values(box_mesh(half, n), {{"side", {2}}}));
    else
      add_box_of_planes(sc, half);
    add_weight(sc, {{3, -2, -9}});
    Simulation s(sc);
    run(s, 3000);
    return motion_of(s);
  };
  // Bodies meet: collisions multiply round-off by some 10 each, and there are 3 or so for each of them.
  const Motion planes = run_in(false, 1, frictional);
  CHECK(difference(run_in(true, 1, frictional), planes) < 1e-9);
  CHECK(difference(run_in(true, 4, frictional), planes) < 1e-9);
}

TEST_CASE("a body in a corner of a mesh keeps three springs, in a state too", "[surfaces]") {
  Scene sc =
      scene(3, 2e-5, {body(1, 0.01, 0.01, {{0.0399, 0.0299, -0.0199}}, {{0.1, -0.1, 0.05}})}, frictional);
  add_boundary(sc, "mesh", mesh_values(box_mesh({{0.05, 0.04, 0.03}}, 2), {{"side", {2}}}));
  add_weight(sc, {{20, 12, -15}});
  Simulation s(sc);
  run(s, 30000);
  const ContactList contacts = s.contact_list();
  REQUIRE(contacts.a.size() == 3);
  std::vector<double> squares;
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(contacts.b[c] == 1);
    double most = 0;
    for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(contacts.normal[3 * c + std::size_t(k)]));
    CHECK(most == 1);
    double spring = 0;
    for (std::uint32_t k = 0; k < 3; ++k) spring += std::pow(s.contact_history(contacts.pair[c], k), 2);
    CHECK(spring > 0);
  }
  Simulation again(sc, s.state());
  CHECK(again.state_hash() == s.state_hash());
  run(s, 700), run(again, 700);
  CHECK(again.state_hash() == s.state_hash());
}

// The potential energy of springs is a function of the distance, so that energy is kept over convex edges,
// corners and hollow edges to step error: second order.
TEST_CASE("energy is kept on edges and corners of any sharpness", "[surfaces]") {
  const auto residual = [](const Mesh& mesh, double smooth, double step) {
    std::vector<Body> bodies;
    for (std::int64_t k = 0; k < 16; ++k)
      bodies.push_back(body(k, 0.05, 1, {{0.2 * double(k % 4) - 0.29, 0.2 * double(k / 4) - 0.31, 0.5}},
                            {{0.3 - 0.1 * double(k % 5), 0.1 * double(k % 7) - 0.3, -2}}, {{1, 2, 3}}));
    Scene sc = scene(3, step, bodies, {{"normal_stiffness", {1e6}}, {"normal_damping", {0}}});
    add_boundary(sc, "mesh", mesh_values(mesh, {{"smooth_angle", {smooth}}}));
    Simulation s(sc);
    const double before = s.energy().kinetic_translation;
    double most = 0;
    for (int k = 0; k < int(0.4 / step); ++k) {
      s.step();
      most = std::max(most,
                      std::abs(s.energy().kinetic_translation + s.energy().elastic_normal - before) / before);
    }
    CHECK(s.max_overlap_ratio() > 0.01);
    return most;
  };
  std::mt19937_64 random(7);
  const Mesh hills = hills_mesh(0.6, 12, 0.6, random);
  const double coarse = residual(hills, 0.35, 4e-5), fine = residual(hills, 0.35, 1e-5);
  INFO("largest change of energy, " << coarse << " and " << fine);
  // (ω h)²/4 of the energy of an oscillator, ω² = k/m.
  CHECK(coarse < 1e6 * 4e-5 * 4e-5 / 4);
  CHECK(fine < coarse / 8);
  // Without the angle a spot with an overlap δ ends where its face does, if faces bend by less than √(2δ/R).
  CHECK(residual(hills, 0, 1e-5) > 10 * coarse);
}

namespace {

// A body on a wall, of which a mesh has n parts around and is turned; 0 parts: the exact shape.
struct OnCurvedWall {
  const char* name;
  std::function<void(Scene&, std::size_t parts, double turn)> add_wall;
  Body body;
  double time;  // (s)
};

Vec3 place_after(const OnCurvedWall& c, std::size_t parts, double turn) {
  Scene sc = scene(3, 2e-5, {c.body}, lossless);
  c.add_wall(sc, parts, turn);
  add_weight(sc);
  Simulation s(sc);
  run(s, std::uint64_t(std::llround(c.time / sc.step)));
  // A step in which the normal turns by α at an edge misses up to m g α v h, in all m g s v h/R along a
  // path s: of m g R, s v h/R² = 0.5 m × 1.5 m/s × 2e-5 s/(0.15 m)².
  CHECK(std::abs(s.energy_residual()) < 7e-4);
  return position(s, 0);
}

// Root mean square over places of the edges relative to the path, of the distance and of the height.
struct FromExact {
  double distance, height;
};
FromExact from_exact(const OnCurvedWall& c, std::size_t parts) {
  constexpr int turns = 8;
  const Vec3 exact = place_after(c, 0, 0);
  FromExact square = {0, 0};
  for (int k = 0; k < turns; ++k) {
    const Vec3 apart =
        place_after(c, parts, 2 * std::numbers::pi * (k + 0.37) / (turns * double(parts))) - exact;
    square.distance += dot(apart, apart) / turns, square.height += apart[2] * apart[2] / turns;
  }
  return {std::sqrt(square.distance), std::sqrt(square.height)};
}

const Values at_origin = {{"point", {0, 0, 0}}};

std::vector<OnCurvedWall> curved_walls() {
  constexpr double radius = 0.05, wall = 0.15, low = wall - radius, high = wall + radius;
  const auto cylinder = [](Scene& sc, std::size_t parts, double turn) {
    if (parts > 0)
      return add_boundary(sc, "mesh", mesh_values(lying(cylinder_mesh(wall, 1, parts, 2, turn))));
    add_boundary(sc, "cylinder", {{"point", {0, 0, 0}}, {"axis", {0, 1, 0}}, {"radius", {wall}}});
  };
  const auto ball = [](Scene& sc, std::size_t parts, double turn) {
    if (parts > 0) return add_boundary(sc, "mesh", mesh_values(sphere_mesh(wall, parts / 4, 3 * turn)));
    add_boundary(sc, "sphere", {{"point", {0, 0, 0}}, {"radius", {wall}}});
  };
  const auto cone = [](Scene& sc, std::size_t parts, double turn) {
    if (parts > 0) return add_boundary(sc, "mesh", mesh_values(cone_mesh(0.4, 0.4, parts, 2, turn)));
    add_boundary(sc, "cone",
                 {{"point", {0, 0, 0}},
                  {"axis", {0, 0, 1}},
                  {"radius", {0}},
                  {"end_radius", {0.4}},
                  {"length", {0.4}}});
  };
  return {
      {"in a cylinder", cylinder, body(1, radius, 1, {{low * std::sin(0.9), 0, -low * std::cos(0.9)}}), 0.3},
      {"on a sphere", ball, body(1, radius, 1, {{high * std::sin(0.4), 0.02, high * std::cos(0.4)}}), 0.12},
      {"in a cone", cone, body(1, radius, 1, {{0.2, 0, 0.2 + radius * std::sqrt(2)}}, {{0, 1.4, 0}}), 0.5}};
}

}  // namespace

// The springs are soft enough for a body to meet several edges within a period of its contact; with fewer
// it is thrown from facet to facet. Facets of a sphere tilt a path to its sides too, at random, so that
// the place across it has order 3/2, and the height, which energy determines, has order 2.
TEST_CASE("triangulated walls converge to the exact ones with second order", "[surfaces]") {
  for (OnCurvedWall c : curved_walls()) {
    if (sanitized) {  // which takes minutes for all steps
      c.time /= 50;
      CHECK(std::isfinite(norm(place_after(c, 128, 0.1))));
      continue;
    }
    const FromExact coarse = from_exact(c, 128), fine = from_exact(c, 512);
    const double of_distance = std::log2(coarse.distance / fine.distance) / 2,
                 of_height = std::log2(coarse.height / fine.height) / 2;
    INFO(c.name << ": " << coarse.distance << " m and " << fine.distance << " m, orders " << of_distance
                << " and " << of_height);
    CHECK(of_height > 1.9);
    CHECK(of_distance > (c.name == std::string("on a sphere") ? 1.25 : 1.9));
  }
}
