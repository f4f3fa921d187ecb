#include "assembly/turn_terms.hpp"

#include "surface_beds.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/branching.hpp>
#include <scree/response/linear_system.hpp>
#include <scree/wall_surfaces.hpp>

// Walls that forces move and torques turn.

using namespace scree;
using namespace scree::response;
using scree::test::Matrix;
using scree::test::Values;

namespace {

const Values damped_bed_values = {{"normal_stiffness", {1000}},
                                  {"normal_damping", {3}},
                                  {"tangential_stiffness", {600}},
                                  {"tangential_damping", {2}},
                                  {"static_friction", {50}}};
const Values bed_values = {{"normal_stiffness", {1000}},
                           {"normal_damping", {0}},
                           {"tangential_stiffness", {600}},
                           {"static_friction", {50}}};
const Values hertz_bed_values = {{"youngs_modulus", {1000}},
                                 {"poissons_ratio", {0.25}},
                                 {"restitution", {1}},
                                 {"friction", {50}},
                                 {"history", {2}}};

const Vec3 bed_direction = {{0.6, 0.8, 0}}, centre_from_bed = {{0.3, -0.2, 0}};
Vec3 bed_axis(int dimension) { return dimension == 2 ? Vec3{{0, 0, 1}} : Vec3{{2.0 / 3, 1.0 / 3, 2.0 / 3}}; }
Vec3 bed_centre(std::size_t bed) { return Vec3{{20 * double(bed), 0, 0}} + centre_from_bed; }
constexpr double bed_inertia = 2e9;

std::vector<double> components_of(const Vec3& v) { return {v[0], v[1], v[2]}; }

// Beds that forces and torques move, as good as not at all, since they are heavy.
Scene turning_beds(int dimension, const Values& law, const std::string& plugin = "linear_spring_dashpot") {
  Scene s = test::surface_beds(dimension, law, plugin);
  for (std::size_t b = 0; b < s.boundaries.size(); ++b) {
    Parameters& p = s.boundaries[b].parameters;
    p.set("direction", components_of(bed_direction));
    if (dimension == 3) p.set("spin_axis", components_of(bed_axis(3)));
    p.set("spin_point", components_of(bed_centre(b)));
    p.set("force", std::vector<double>{0, 0}), p.set("mass", std::vector<double>{1e9});
    p.set("torque", std::vector<double>{0, 0}), p.set("inertia", std::vector<double>{bed_inertia});
    p.set("spin_viscosity", std::vector<double>{1.7});
    if (dimension == 3 && p.find("length") && !p.find("end_radius") && p.find("radius"))
      p.set("length", std::vector<double>{10});
  }
  return s;
}

// Bodies, then beds, whose loads are along their direction and about their axis.
Eigen::VectorXd loads_with_beds(const Simulation& s, const DegreesOfFreedom& freedom) {
  const Particles& p = s.particles();
  Eigen::VectorXd all(freedom.size());
  test::each_motion(freedom, [&](Eigen::Index row, std::size_t i, int k) {
    const int D = freedom.dimension();
    all[row] = k < D ? p.force()[k][i] : p.torque()[p.spin_axes().first + k - D][i];
  });
  for (std::size_t b = 0; b < freedom.walls(); ++b) {
    const scree_frame& frame = s.surfaces().frames[b];
    const Vec3 force = vector_of(s.surfaces().loads[b].force),
               torque = vector_of(s.surfaces().loads[b].torque);
    // The centre moves with the bed.
    const Vec3 place = {{20 * double(b), 0, 0}};
    const Vec3 moved = frame.spin[2] != 0 ? Vec3{} : vector_of(frame.position) - place;
    const Vec3 arm = vector_of(frame.position) - (bed_centre(b) + moved);
    all[freedom.wall(b)] = dot(bed_direction, force);
    all[freedom.turn(b)] = dot(bed_axis(freedom.dimension()), torque + cross(arm, force));
  }
  return all;
}

// A bed moves along its direction and turns as prescribed.
void move_bed(Simulation& s, std::size_t bed, double speed, double spin) {
  const Scene::Boundary& entry = s.scene().boundaries[bed];
  Parameters p = entry.parameters;
  p.set("control", std::vector<double>{2}), p.set("velocity", std::vector<double>{0, speed});
  p.set("spin_control", std::vector<double>{2}), p.set("spin", std::vector<double>{0, spin});
  s.reconfigure_boundary(entry.name, p);
  s.apply_reconfiguration();
}

// Columns of the beds, by a function of a bed and its rates.
template <class Column>
void each_bed_motion(const DegreesOfFreedom& freedom, const Column& column) {
  for (std::size_t b = 0; b < freedom.walls(); ++b) {
    column(freedom.wall(b), b, 1.0, 0.0);
    column(freedom.turn(b), b, 0.0, 1.0);
  }
}

Matrix bed_stiffness_by_differences(const Scene& scene, const State& state, const DegreesOfFreedom& freedom) {
  const double length = 2e-4;
  Matrix all(freedom.size(), freedom.size());
  const auto fill = [&](Eigen::Index column, const auto& after) {
    all.col(column) = -(8 * (after(1) - after(-1)) - (after(2) - after(-2))) / (12 * length);
  };
  test::each_motion(freedom, [&](Eigen::Index column, std::size_t i, int k) {
    fill(column, [&](double steps) -> Eigen::VectorXd {
      Simulation moved(test::with_motion(scene, state, i, k, steps * length / scene.step), state,
                       Branching());
      moved.step();
      return loads_with_beds(moved, freedom);
    });
  });
  each_bed_motion(freedom, [&](Eigen::Index column, std::size_t bed, double speed, double spin) {
    fill(column, [&](double steps) -> Eigen::VectorXd {
      const double rate = steps * length / scene.step;
      Simulation moved(scene, state);
      move_bed(moved, bed, speed * rate, spin * rate);
      moved.step();
      return loads_with_beds(moved, freedom);
    });
  });
  return all;
}

double error_of_turning_beds(const Scene& scene) {
  const State state = test::strained(scene);
  const Simulation simulation(scene, state);
  const LinearSystem system = assemble(simulation, {.fewest_contacts = 1});
  REQUIRE(system.freedom.turn(0) != DegreesOfFreedom::none);
  const Matrix expected = bed_stiffness_by_differences(scene, state, system.freedom);
  return (Matrix(system.stiffness) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

}  // namespace

// The tolerance is that of assemble_test.cpp: differences of fourth order.
TEST_CASE("walls that torques turn have the stiffness that the kernel has", "[response][surfaces]") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    CHECK(error_of_turning_beds(turning_beds(dimension, bed_values)) < 1e-8);
  }
  CHECK(error_of_turning_beds(turning_beds(3, hertz_bed_values, "hertz_mindlin")) < 1e-8);
  CHECK(error_of_turning_beds(turning_beds(3, bed_values, "sphere_path_independent")) < 1e-8);
}

// As in assemble_test.cpp: forces are linear in velocities, and round-off is 1e-16 of forces that are 1e4
// times as large as their differences.
TEST_CASE("walls that torques turn have the damping that the kernel has", "[response][surfaces]") {
  const double rate = 1e-3;
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    Scene scene = turning_beds(dimension, damped_bed_values);
    scene.step = 1e-9;
    const Simulation start(scene);
    const State state = start.state();
    const LinearSystem system = assemble(start, {.fewest_contacts = 1});
    Matrix expected(system.freedom.size(), system.freedom.size());
    test::each_motion(system.freedom, [&](Eigen::Index column, std::size_t i, int k) {
      const Simulation more(test::with_motion(scene, state, i, k, rate), state, Branching());
      const Simulation less(test::with_motion(scene, state, i, k, -rate), state, Branching());
      expected.col(column) =
          -(loads_with_beds(more, system.freedom) - loads_with_beds(less, system.freedom)) / (2 * rate);
    });
    each_bed_motion(system.freedom, [&](Eigen::Index column, std::size_t bed, double speed, double spin) {
      Simulation more(scene, state), less(scene, state);
      move_bed(more, bed, speed * rate, spin * rate), move_bed(less, bed, -speed * rate, -spin * rate);
      expected.col(column) =
          -(loads_with_beds(more, system.freedom) - loads_with_beds(less, system.freedom)) / (2 * rate);
    });
    for (std::size_t b = 0; b < system.freedom.walls(); ++b) {
      expected(system.freedom.turn(b), system.freedom.turn(b)) += 1.7;  // the viscosity of the bed
      CHECK(system.mass[system.freedom.turn(b)] == bed_inertia);
    }
    CHECK((Matrix(system.damping) - expected).cwiseAbs().maxCoeff() < 1e-10 * expected.cwiseAbs().maxCoeff());
  }
}

// k = 3 k_n along its axis, 3 k_t r² about it.
TEST_CASE("a disc on three beads rises and turns with the stiffness of their springs",
          "[response][surfaces]") {
  const Simulation simulation(test::disc_on_beads(30, 0));
  const LinearSystem system = assemble(simulation, {.fewest_contacts = 1});
  REQUIRE(system.freedom.size() == 2);
  const Matrix k = system.stiffness;
  const Eigen::Index rise = system.freedom.wall(0), turn = system.freedom.turn(0);
  CHECK(k(rise, rise) == Approx(3 * 1000).epsilon(1e-14));
  CHECK(k(turn, turn) == Approx(3 * 600 * 0.7 * 0.7).epsilon(1e-14));
  CHECK(std::abs(k(rise, turn)) + std::abs(k(turn, rise)) < 1e-14 * k(rise, rise));
}

// A wall that forces move is displaced by q along its direction, and across it by w.
TEST_CASE("bodies that move with beds which torques turn feel no force", "[response][surfaces]") {
  for (const int dimension : {2, 3}) {
    const Scene scene = turning_beds(dimension, bed_values);
    const State state = test::strained(scene);
    const LinearSystem system = assemble(Simulation(scene, state), {.fewest_contacts = 1});
    const DegreesOfFreedom& freedom = system.freedom;
    for (int k = 0; k < dimension; ++k) {
      Eigen::VectorXd motion = Eigen::VectorXd::Zero(freedom.size()),
                      walls = Eigen::VectorXd::Zero(Eigen::Index(freedom.walls()) * dimension);
      for (std::size_t i = 0; i < freedom.bodies(); ++i) motion[freedom.translation(i, k)] = 1;
      for (std::size_t b = 0; b < freedom.walls(); ++b) {
        motion[freedom.wall(b)] = bed_direction[k];
        walls[Eigen::Index(b) * dimension + k] = 1;
      }
      const Eigen::VectorXd of_walls = system.wall_stiffness * walls;
      CHECK((system.stiffness * motion + of_walls).norm() < 1e-13 * system.stiffness.norm());
      CHECK(of_walls.norm() > 1);
    }
  }
}
