#include "packings.hpp"
#include "surface_beds.hpp"

#include <cmath>
#include <memory>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/plugin/program.hpp>
#include <scree/response/linear_system.hpp>

using namespace scree;
using namespace scree::response;
using scree::test::Matrix;
using scree::test::Values;

namespace {

const Values spring_values = {{"normal_stiffness", {1000}},
                              {"normal_damping", {0}},
                              {"tangential_stiffness", {600}},
                              {"static_friction", {50}}};
const Values disc_values = {{"normal_stiffness", {1000}},
                            {"normal_damping", {0}},
                            {"tangential_stiffness", {600}},
                            {"tangential_damping", {0}},
                            {"friction", {50}}};
const Values smooth_values = {{"normal_stiffness", {1000}}, {"normal_damping", {0}}};

// history: 0: displacement, 1: rescaled, 2: potential.
Values hertz(double history) {
  return {{"youngs_modulus", {1000}},
          {"poissons_ratio", {0.25}},
          {"restitution", {1}},
          {"friction", {50}},
          {"history", {history}}};
}

// All bodies are linearised.
LinearSystem system_of(const Simulation& simulation) { return assemble(simulation, {.fewest_contacts = 1}); }

// Largest difference between K and the differences of the kernel's forces, over the largest entry of K.
double error_of_stiffness(const Scene& scene) {
  const State state = test::strained(scene);
  const Simulation simulation(scene, state);
  const LinearSystem system = system_of(simulation);
  const Matrix expected = test::stiffness_by_differences(scene, state, system.freedom);
  return (Matrix(system.stiffness) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

double asymmetry(const Matrix& m) {
  return (m - m.transpose()).cwiseAbs().maxCoeff() / m.cwiseAbs().maxCoeff();
}

}  // namespace

// The error of differences of fourth order with steps of 2e-4 radii in overlaps above 0.04 radii is about
// (5e-3)^4 = 6e-10 for forces with fractional powers of the overlap, and round-off 1e-16/2e-4 = 5e-13.
TEST_CASE("the stiffness matrix is the derivative of the forces of the kernel", "[response]") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    CHECK(error_of_stiffness(test::heap(dimension, smooth_values)) < 1e-8);
    CHECK(error_of_stiffness(test::heap(dimension, spring_values)) < 1e-8);
  }
  for (const double history : {0, 2})
    CHECK(error_of_stiffness(test::heap(3, hertz(history), "hertz_mindlin")) < 1e-8);
  for (const std::string law : {"disc_cundall_strack", "disc_angular"}) {
    CAPTURE(law);
    CHECK(error_of_stiffness(test::heap(2, disc_values, law)) < 1e-8);
  }
  CHECK(error_of_stiffness(test::heap(3, spring_values, "sphere_path_independent")) < 1e-8);
}

// As above. Bodies meet one surface each, on faces, edges and corners.
TEST_CASE("the stiffness matrix of bodies on surfaces is the derivative of the forces of the kernel",
          "[response][surfaces]") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    const Scene springs = test::surface_beds(dimension, spring_values, "linear_spring_dashpot");
    CHECK(Simulation(springs).contact_list().size() == springs.bodies.size());
    CHECK(error_of_stiffness(springs) < 1e-8);
  }
  for (const double history : {0, 2})
    CHECK(error_of_stiffness(test::surface_beds(3, hertz(history), "hertz_mindlin")) < 1e-8);
  CHECK(error_of_stiffness(test::surface_beds(3, spring_values, "sphere_path_independent")) < 1e-8);
  const double leaves = 0.3;  // the period, as it is strained
  CHECK(error_of_stiffness(test::periodic_trough(spring_values, "sphere_path_independent", leaves)) < 1e-8);
}

// Central differences have the mean of both stiffnesses, up to the difference of their second derivatives:
// with the step h = 2e-4 over overlaps above 0.04, h/δ = 5e-3 of what differs.
TEST_CASE("where loading and unloading differ, the stiffness is their mean and the contacts are counted",
          "[response]") {
  const Scene rescaled = test::heap(3, hertz(1), "hertz_mindlin");
  CHECK(error_of_stiffness(rescaled) < 1e-3);
  CHECK(system_of(Simulation(rescaled)).one_way_contacts == 0);  // no tangential load
  const LinearSystem system = system_of(Simulation(rescaled, test::strained(rescaled)));
  CHECK(system.one_way_contacts > 0);
  CHECK(one_way_warning(system.one_way_contacts).find("; set history = \"potential\"") != std::string::npos);
  for (const double history : {0, 2}) {
    const Scene scene = test::heap(3, hertz(history), "hertz_mindlin");
    CHECK(system_of(Simulation(scene, test::strained(scene))).one_way_contacts == 0);
  }
}

// Forces are linear in small velocities: round-off 1e-16 of the forces, which are 1e4 times as large as the
// differences. The first evaluation of a run has a step of 0, from which a Hertzian dashpot with the step of
// 1e-9 s differs by ½ h² k/m* = 1e-15.
TEST_CASE("the damping matrix is the derivative of the forces with velocities and spins", "[response]") {
  const Values damped = {{"normal_stiffness", {1000}},
                         {"normal_damping", {3}},
                         {"tangential_stiffness", {600}},
                         {"tangential_damping", {2}},
                         {"static_friction", {50}}};
  const Values hertz_damped = {
      {"youngs_modulus", {1000}}, {"poissons_ratio", {0.25}}, {"restitution", {0.5}}, {"friction", {50}}};
  std::vector<Scene> scenes = {test::heap(2, damped), test::heap(3, damped),
                               test::heap(3, hertz_damped, "hertz_mindlin", 1)};
  for (Scene& scene : scenes) {
    CAPTURE(scene.dimension, scene.laws[0].name);
    scene.step = 1e-9;
    test::add_body_force(scene, "background_damping", {{"translational", {0.7}}, {"rotational", {0.4}}});
    const Simulation start(scene);
    const State state = start.state();
    const LinearSystem system = system_of(start);
    const Matrix expected = test::damping_by_differences(scene, state, system.freedom);
    const double error = (Matrix(system.damping) - expected).cwiseAbs().maxCoeff();
    CHECK(error < 1e-10 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("rolling resistance damps relative spins at rest", "[response]") {
  Values law = spring_values;
  const Scene without = test::heap(2, law, "linear_spring_dashpot", 1);
  law.push_back({"rolling_friction", {0.1}});
  const Scene with = test::heap(2, law, "linear_spring_dashpot", 1);
  const LinearSystem system = system_of(Simulation(with));
  const Matrix rolling = Matrix(system.damping) - Matrix(system_of(Simulation(without)).damping);
  // 1/16 of the relative spin is removed in a step: 0.4 m* R*²/(16 h), between discs 0 and 1.
  const double radius = 1 * 1.04 / 2.04, expected = 0.4 * 0.5 * radius * radius / (16 * with.step);
  const Eigen::Index a = system.freedom.rotation(0, 0), b = system.freedom.rotation(1, 0);
  CHECK(rolling(a, b) == Approx(-expected).epsilon(1e-14));
  CHECK(rolling(a, a) > expected);  // the floor and disc 2 too
}

// The sums of at most a dozen terms are exact to round-off.
TEST_CASE("packings that move with their walls feel no force", "[response]") {
  for (const int dimension : {2, 3}) {
    const Simulation simulation(test::heap(dimension, spring_values));
    const LinearSystem system = system_of(simulation);
    for (int k = 0; k < dimension; ++k) {
      Eigen::VectorXd motion = Eigen::VectorXd::Zero(system.freedom.size());
      for (std::size_t i = 0; i < system.freedom.bodies(); ++i) motion[system.freedom.translation(i, k)] = 1;
      const Eigen::VectorXd of_walls = system.wall_stiffness * Eigen::VectorXd::Unit(dimension, k);
      REQUIRE(of_walls.norm() > 1);
      CHECK((system.stiffness * motion + of_walls).norm() < 1e-13 * of_walls.norm());
    }
  }
}

TEST_CASE("a rotation of all bodies turns their forces", "[response]") {
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    Scene scene = test::heap(dimension, dimension == 2 ? spring_values : smooth_values);
    scene.boundaries.clear();
    const State state = test::strained(scene);
    const Simulation simulation(scene, state);
    const LinearSystem system = system_of(simulation);
    const DegreesOfFreedom& freedom = system.freedom;
    const Eigen::VectorXd force = test::loads(simulation, freedom);
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(freedom.size()), turned = motion;
    const auto turn = [&](std::size_t i, double x, double y, Eigen::VectorXd& to) {
      to[freedom.translation(i, 0)] = -y;
      to[freedom.translation(i, 1)] = x;
    };
    for (std::size_t i = 0; i < freedom.bodies(); ++i) {
      const Vec3 x = test::position(simulation, i);
      turn(i, x[0], x[1], motion);
      if (dimension == 2) motion[freedom.rotation(i, 0)] = 1;
      turn(i, force[freedom.translation(i, 0)], force[freedom.translation(i, 1)], turned);
    }
    REQUIRE(turned.norm() > 1);
    // Round-off of forces that nearly cancel, each k times a displacement of some radii.
    CHECK((system.stiffness * motion + turned).norm() < 1e-12 * turned.norm());
  }
}

TEST_CASE("a stiffness matrix is symmetric where the forces have a potential", "[response]") {
  for (const int dimension : {2, 3}) {
    // Springs without load have the potential ½ k ξ²; with one the torque of a contact depends on its path.
    CHECK(asymmetry(Matrix(system_of(Simulation(test::heap(dimension, spring_values))).stiffness)) < 1e-14);
    CHECK(asymmetry(Matrix(system_of(Simulation(test::heap(dimension, smooth_values))).stiffness)) < 1e-14);
  }
  const Scene scene = test::heap(3, spring_values);
  CHECK(asymmetry(Matrix(system_of(Simulation(scene, test::strained(scene))).stiffness)) > 1e-4);
}

TEST_CASE("bodies with too few contacts, and those that they held, are left out", "[response]") {
  // Two discs in a row on the right wall of a square of four, and a free one.
  Scene scene = test::heap(2, spring_values);
  scene.bodies.push_back(test::body(4, 1, test::heavy, {{-1.2, 3.9, 0}}, {}, {}, 2));  // touches nothing
  scene.bodies.push_back(test::body(5, 1, test::heavy, {{4.7, 2.9, 0}}, {}, {}, 2));   // touches disc 3
  scene.bodies.push_back(test::body(6, 1, test::heavy, {{6.6, 2.9, 0}}, {}, {}, 2));   // touches disc 5
  const LinearSystem system = assemble(Simulation(scene));
  CHECK(system.rattlers == std::vector<std::uint32_t>{4, 5, 6});
  CHECK(system.freedom.size() == 4 * 3);
  CHECK(system.freedom.translation(5, 0) == DegreesOfFreedom::none);
  // Without friction D + 1 contacts are needed, which no disc of the heap has when the free ones are gone.
  CHECK_THROWS_WITH(assemble(Simulation(test::heap(2, smooth_values))),
                    Catch::Contains("no body is held") && Catch::Contains("; compress the packing"));
}

namespace {

constexpr double slider_stiffness = 1000, slider_friction = 0.5, slider_damping = 3;

// A disc that has moved by 0.2 to the right on a floor, with k_t ξ = 0.2 k_t above μ k δ = 0.05 k. Inward
// speed with damping adds the share `more` to the normal force, so that the spring is longer by this share
// than the limit at rest.
std::unique_ptr<Simulation> slider(const std::string& plugin = "linear_spring_dashpot",
                                   const std::string& friction = "static_friction", double more = 0) {
  const double speed = 1, step = 1e-3;
  Scene scene = test::heap(2,
                           {{"normal_stiffness", {slider_stiffness}},
                            {"normal_damping", {more * slider_stiffness * 0.1 / speed}},
                            {"tangential_stiffness", {slider_stiffness}},
                            {"tangential_damping", {slider_damping}},
                            {friction, {slider_friction}}},
                           plugin);
  const double inwards = more > 0 ? speed : 0;
  scene.bodies = {test::body(0, 1, test::heavy, {{0, 0.9 + inwards * step, 0}}, {{200, -inwards, 0}}, {}, 2)};
  auto sliding = std::make_unique<Simulation>(scene);
  sliding->step();
  return sliding;
}

}  // namespace

TEST_CASE("contacts at the limit of friction stick where they are to", "[response]") {
  const struct {
    std::string law, friction;
    double arm;  // at which a rotation moves the spring: to the contact point, or of painted points
  } cases[] = {{"linear_spring_dashpot", "static_friction", 0.95}, {"disc_angular", "friction", 1}};
  const double more = GENERATE(0.0, 0.3);
  for (const auto& [law, friction, arm] : cases) {
    CAPTURE(law, more);
    const LinearSystem system =
        assemble(*slider(law, friction, more), {.fewest_contacts = 1, .at_limit = AtLimit::stick});
    const Matrix stiffness(system.stiffness), damping(system.damping);
    const double k = slider_stiffness, tolerance = 1e-8 * k;
    CHECK(system.sliding_contacts == 1);
    CHECK(std::abs(stiffness(0, 0) - k) < tolerance);
    CHECK(std::abs(stiffness(0, 1)) < tolerance);
    CHECK(std::abs(stiffness(0, 2) - arm * k) < tolerance);
    CHECK(std::abs(damping(0, 0) - slider_damping) < 1e-8 * slider_damping);
  }
}

TEST_CASE("a contact that slides does so in a scene that begins from its state", "[response]") {
  const auto sliding = slider();
  Scene scene = sliding->scene();
  scene.step *= 0.5;  // so that forces are evaluated anew
  const Simulation begun(scene, sliding->state(), Branching{});
  const AssemblyOptions options = {.fewest_contacts = 1, .at_limit = AtLimit::slide};
  const LinearSystem before = assemble(*sliding, options), after = assemble(begun, options);
  CHECK(after.sliding_contacts == 1);
  // Round-off of a spring at the limit.
  CHECK((Matrix(after.stiffness) - Matrix(before.stiffness)).cwiseAbs().maxCoeff() < 1e-9 * slider_stiffness);
}

// With springs at rest the laws of [M18] to [M22] and of [M23] to [M30] move them alike.
TEST_CASE("a law that integrates spins has their stiffness, and no dashpot of them", "[response]") {
  const Values springs = {{"normal_stiffness", {1e4}},
                          {"normal_damping", {0}},
                          {"tangential_stiffness", {1e3}},
                          {"tangential_damping", {0}},
                          {"friction", {0.5}}};
  const auto system_of = [&](const std::string& law) {
    Scene scene = test::heap(2, springs, law);
    return assemble(Simulation(scene), {.fewest_contacts = 1});
  };
  const LinearSystem corrected = system_of("disc_corrected"), angular = system_of("disc_angular");
  // Round-off of forces of overlaps of a tenth of the radius.
  CHECK((Matrix(corrected.stiffness) - Matrix(angular.stiffness)).cwiseAbs().maxCoeff() < 1e-9 * 1e4);
  CHECK(Matrix(corrected.damping).cwiseAbs().maxCoeff() < 1e-9 * 1e4);
}

TEST_CASE("a contact that slides goes on sliding", "[response]") {
  const double k = slider_stiffness, friction = slider_friction;
  const LinearSystem system = system_of(*slider());
  // Nor does its dashpot resist along the slip.
  CHECK(std::abs(Matrix(system.damping)(0, 0)) < 1e-8 * slider_damping);
  const Matrix stiffness(system.stiffness);
  // f_x = −μ k (1 − y), f_y = k (1 − y), torque y' f_x with the arm y' = (1 + y)/2. Slip is prolonged by 1e-9
  // of the overlap, and round-off is smaller.
  const double force = friction * k * 0.1, tolerance = 1e-8 * k;
  CHECK(std::abs(stiffness(0, 0)) < tolerance);
  CHECK(std::abs(stiffness(0, 1) + friction * k) < tolerance);
  CHECK(std::abs(stiffness(0, 2)) < tolerance);
  CHECK(std::abs(stiffness(1, 1) - k) < tolerance);
  CHECK(std::abs(stiffness(2, 1) - (0.5 * force - 0.95 * friction * k)) < tolerance);
  CHECK(std::abs(stiffness(2, 2)) < tolerance);
}

namespace {

// A compressed row of five spheres of mass 1 and radius 1 between two of the same size, which are fixed, or
// between walls.
Scene row_between(bool fixed_spheres) {
  constexpr double d = 2 - 1e-3;
  std::vector<Body> bodies;
  for (int i = fixed_spheres ? 0 : 1; i <= (fixed_spheres ? 6 : 5); ++i) {
    bodies.push_back(test::body(i, 1, 1, {{i * d, 0, 0}}));
    bodies.back().fixed = i == 0 || i == 6;
  }
  Scene scene = test::scene(3, 1e-3, std::move(bodies),
                            {{"normal_stiffness", {1000}},
                             {"normal_damping", {3}},
                             {"tangential_stiffness", {600}},
                             {"static_friction", {50}}});
  if (fixed_spheres) return scene;
  test::add_boundary(scene, "plane", {{"point", {0.5 * d, 0, 0}}, {"normal", {1, 0, 0}}}, "low");
  test::add_boundary(scene, "plane", {{"point", {5.5 * d, 0, 0}}, {"normal", {-1, 0, 0}}}, "high");
  return scene;
}

// The eigenvalues of K along x over the mass, in ascending order.
Eigen::VectorXd squares_along_x(const LinearSystem& system, std::size_t first) {
  Matrix along(5, 5);
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t k = 0; k < 5; ++k)
      along(Eigen::Index(i), Eigen::Index(k)) = Matrix(system.stiffness)(
          system.freedom.translation(first + i, 0), system.freedom.translation(first + k, 0));
  return Eigen::SelfAdjointEigenSolver<Matrix>(along).eigenvalues();
}

}  // namespace

// ω_j = 2 √(k/m) sin(j π/(2 (n + 1))) of a chain of n that is clamped at both ends. Round-off.
TEST_CASE("a row between two fixed spheres has the frequencies of a clamped chain, as one between walls",
          "[response]") {
  const LinearSystem by_spheres = assemble(Simulation(row_between(true)), {.fewest_contacts = 1}),
                     by_walls = assemble(Simulation(row_between(false)), {.fewest_contacts = 1});
  CHECK(by_spheres.freedom.size() == 5 * 6);
  CHECK(by_spheres.freedom.bodies() == 7);
  for (const std::size_t end : {0, 6}) {
    CHECK_FALSE(by_spheres.freedom.moves(end));
    CHECK(by_spheres.freedom.translation(end, 0) == DegreesOfFreedom::none);
    CHECK(by_spheres.freedom.rotation(end, 0) == DegreesOfFreedom::none);
  }
  CHECK(by_spheres.rattlers.empty());
  const Eigen::VectorXd squares = squares_along_x(by_spheres, 1);
  for (int j = 1; j <= 5; ++j)
    CHECK(squares[j - 1] ==
          Approx(std::pow(2 * std::sqrt(1000.0) * std::sin(j * 3.14159265358979 / 12), 2)).epsilon(1e-10));
  CHECK((squares - squares_along_x(by_walls, 0)).norm() < 1e-9);
  CHECK((by_spheres.mass - by_walls.mass).norm() == 0);
  // Between walls the normal does not turn with the spheres at the ends: they differ across x, by the
  // compression of 1 N.
  CHECK((Matrix(by_spheres.damping) - Matrix(by_walls.damping)).norm() < 1e-9);
  CHECK((Matrix(by_spheres.stiffness) - Matrix(by_walls.stiffness)).norm() < 3);
}

// Four discs on two that are fixed in place of a floor: K is the derivative of the forces on the others.
TEST_CASE("the stiffness of bodies on fixed ones is the derivative of the forces of the kernel",
          "[response]") {
  for (const int dimension : {2, 3}) {
    Scene scene = test::heap(dimension, spring_values);
    const State state = test::strained(scene);
    scene.bodies = present_bodies(state);
    scene.bodies[0].fixed = scene.bodies[1].fixed = true;
    const State with_fixed = Simulation(scene, state, Branching()).state();
    const Simulation simulation(scene, with_fixed);
    const LinearSystem system = system_of(simulation);
    CHECK(system.freedom.size() == (dimension == 2 ? 2 * 3 : 3 * 6));
    // Of the same bodies where all move, without the rows and columns of the two.
    Scene free = scene;
    for (Body& body : free.bodies) body.fixed = false;
    const LinearSystem all = system_of(Simulation(free, state, Branching()));
    const Eigen::Index first = all.freedom.translation(2, 0), size = system.freedom.size();
    REQUIRE(all.freedom.size() == first + size);
    CHECK((Matrix(system.stiffness) - Matrix(all.stiffness).bottomRightCorner(size, size)).norm() <
          1e-12 * Matrix(all.stiffness).norm());
    CHECK((Matrix(system.damping) - Matrix(all.damping).bottomRightCorner(size, size)).norm() == 0);
  }
}

TEST_CASE("a body without contacts is a rattler unless it is fixed, and fixed bodies alone have no response",
          "[response]") {
  Scene scene = row_between(true);
  scene.bodies.push_back(test::body(7, 1, 1, {{0, 9, 0}}));
  scene.bodies.push_back(test::body(8, 1, 1, {{9, 9, 0}}));
  scene.bodies[7].fixed = true;
  CHECK(system_of(Simulation(scene)).rattlers == std::vector<std::uint32_t>{8});
  for (Body& body : scene.bodies) body.fixed = true;
  CHECK_THROWS_WITH(system_of(Simulation(scene)), Catch::Contains("no body is held"));
}

// γ = 2 ζ √(k m), with the mass of the body and ζ = −ln e/√(π² + ln² e). The error of a short step, 1e-12.
TEST_CASE("a wall on a fixed body has the stiffness and the dashpot of the contact", "[response]") {
  const double stiffness = 1000, mass = 2, decay = -std::log(0.5);
  Scene scene = test::scene(2, 1e-4, {test::body(1, 1, mass, {{0, 0, 0}}, {}, {}, 2)},
                            {{"normal_stiffness", {stiffness}}, {"restitution", {0.5}}});
  scene.bodies[0].fixed = true;
  test::add_boundary(scene, "plane",
                     {{"point", {0, 0.9, 0}},
                      {"normal", {0, -1, 0}},
                      {"direction", {0, -1, 0}},
                      {"control", {4}},  // force
                      {"force", {0, 1}},
                      {"mass", {5}},
                      {"viscosity", {0}}});
  const LinearSystem system = system_of(Simulation(scene));
  REQUIRE(system.freedom.size() == 1);
  CHECK(system.stiffness.coeff(0, 0) == Approx(stiffness));
  CHECK(system.damping.coeff(0, 0) ==
        Approx(2 * decay / std::hypot(3.14159265358979, decay) * std::sqrt(stiffness * mass)));
  CHECK(system.mass[0] == 5);
}

// Components that are held have no rows and columns; K and C of the others are those of bodies that all move.
TEST_CASE("the motions of a row whose spheres are held across it are those along it", "[response]") {
  Scene scene = row_between(true);
  const LinearSystem all = assemble(Simulation(scene), {.fewest_contacts = 1});
  for (std::size_t i = 1; i <= 5; ++i) scene.bodies[i].held = freedom::all & ~1;
  scene.bodies[3].held = freedom::all & ~(1 | 1 << 5);
  const LinearSystem held = assemble(Simulation(scene), {});
  REQUIRE(held.freedom.size() == 6);
  CHECK(held.rattlers.empty());
  CHECK(held.freedom.translation(3, 1) == DegreesOfFreedom::none);
  CHECK(held.freedom.rotation(3, 2) == held.freedom.translation(3, 0) + 1);
  CHECK((squares_along_x(held, 1) - squares_along_x(all, 1)).norm() == 0);
  CHECK((Matrix(held.stiffness)(3, 3)) ==
        Matrix(all.stiffness)(all.freedom.rotation(3, 2), all.freedom.rotation(3, 2)));
  CHECK(held.mass[3] == scene.bodies[3].inertia);
  CHECK(held.mass[4] == 1);
}

TEST_CASE("linear response refuses groups that move bodies, or load them as a function of time",
          "[response]") {
  const auto refused = [](const auto& change) {
    Scene scene = row_between(true);
    scene.groups.emplace_back().name = "g";
    scene.groups[0].bodies = {0};
    change(scene);
    const Simulation simulation(scene);
    try {
      assemble(simulation, {.fewest_contacts = 1});
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::vector<double> sine = {Program::sine, 0, 1, 1, 0};
  CHECK(refused([](Scene& s) { s.groups[0].load[0] = {Program::constant, 1}; }).empty());
  CHECK_THAT(refused([&](Scene& s) { s.groups[0].velocity[0] = sine; }),
             Catch::Contains("group 'g' moves its bodies"));
  CHECK_THAT(refused([&](Scene& s) { s.groups[0].load[0] = sine; }), Catch::Contains("give it a number"));
  CHECK_THAT(refused([](Scene& s) { s.bodies[0].velocity[1] = 1; }),
             Catch::Contains("particle 0 is fixed and moves"));
}
