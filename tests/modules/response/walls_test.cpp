#include "packings.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include <scree/response/frequency_response.hpp>
#include <scree/response/linear_system.hpp>
#include <scree/response/modes.hpp>

using namespace scree;
using namespace scree::response;
using scree::test::Matrix;
using scree::test::Values;
using Complex = std::complex<double>;

namespace {

constexpr const char* wall_names[] = {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};
enum { box_stress, box_fixed };
enum { plane_displacement = 1, plane_force = 4 };

// Stresses of about a tenth of the stiffness of a contact over its radius, different along each axis.
Values box_of(int dimension) {
  return {{"lower", {-1.86, -1.85, -1.88}},
          {"upper", {1.87, 1.89, 1.86}},
          {"mass", {test::heavy}},
          {"stress_x", {0, 130}},
          {"stress_y", {0, 90}},
          {"stress_z", {0, dimension == 3 ? 110.0 : 0}}};
}

// Heavy bodies in a box of heavy walls under stress, all of them pressed together.
Scene boxed(int dimension, const Values& law, const std::string& plugin = "linear_spring_dashpot") {
  std::vector<Body> bodies;
  for (int n = 0; n < (1 << dimension); ++n) {
    Vec3 x = {};
    for (int k = 0; k < dimension; ++k) x[k] = ((n >> k & 1) ? 0.94 : -0.94) + 0.01 * std::sin(n + 2.0 * k);
    bodies.push_back(test::body(n, 1 + 0.01 * std::cos(2.0 * n), test::heavy, x, {}, {}, dimension));
  }
  Scene scene = test::scene(dimension, 1e-3, std::move(bodies), law, plugin);
  test::add_boundary(scene, "box", box_of(dimension));
  return scene;
}

// Forces on all degrees of freedom after wall w has moved inwards by a distance (m) in a step from the state.
Eigen::VectorXd loads_after(const Scene& scene, const State& state, const DegreesOfFreedom& freedom,
                            std::size_t w, double distance) {
  Simulation moved(scene, state);
  Values moving = box_of(scene.dimension);
  moving.push_back({std::string("superposed_") + wall_names[w], {3, 0, distance, scene.step}});
  moved.reconfigure_boundary("box", test::parameters("box", SCREE_BOUNDARY, moving));
  moved.apply_reconfiguration();
  moved.step();
  return test::loads(moved, freedom);
}

// Largest difference between K and the differences of the kernel's forces, over the largest entry of K.
double error_of_stiffness(const Scene& scene) {
  const State state = test::strained(scene);
  const LinearSystem system = assemble(Simulation(scene, state), {.fewest_contacts = 1});
  REQUIRE(system.freedom.walls() == std::size_t(2 * scene.dimension));
  Matrix expected = test::stiffness_by_differences(scene, state, system.freedom);
  const double length = 2e-4;
  for (std::size_t w = 0; w < system.freedom.walls(); ++w) {
    const auto after = [&](double steps) {
      return loads_after(scene, state, system.freedom, w, steps * length);
    };
    expected.col(system.freedom.wall(w)) =
        -(8 * (after(1) - after(-1)) - (after(2) - after(-2))) / (12 * length);
  }
  return (Matrix(system.stiffness) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

constexpr double pi = std::numbers::pi;
constexpr double k = 1000, damping_constant = 2, mass = 0.3, overlap = 1e-3;
constexpr int beads = 20;

struct Lid {
  double mass, viscosity;
};
// A lid that absorbs waves, so that a run becomes steady.
constexpr Lid absorbing = {0.2, 15};

// Beads in a row along x between a wall on the left, with the given motion, and a lid under a force on the right.
Scene column(const Lid& lid, double step, const Values& left = {}, const Values& right = {}) {
  std::vector<Body> bodies;
  for (int n = 0; n < beads; ++n)
    bodies.push_back(test::body(n, 1, mass, {{1 - overlap + (2 - overlap) * n, 0, 0}}, {}, {}, 2));
  Scene scene = test::scene(2, step, std::move(bodies),
                            {{"normal_stiffness", {k}}, {"normal_damping", {damping_constant}}});
  Values wall = {{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}};
  wall.insert(wall.end(), left.begin(), left.end());
  test::add_boundary(scene, "plane", wall, "wall");
  Values pressed = {{"point", {(2 - overlap) * beads - overlap, 0, 0}},
                    {"normal", {-1, 0, 0}},
                    {"control", {plane_force}},
                    {"force", {0, k * overlap}},
                    {"mass", {lid.mass}},
                    {"viscosity", {lid.viscosity}}};
  pressed.insert(pressed.end(), right.begin(), right.end());
  test::add_boundary(scene, "plane", pressed, "lid");
  return scene;
}

LinearSystem column_system(const Lid& lid) {
  return assemble(Simulation(column(lid, 1e-4)), {.fewest_contacts = 1});
}

using Row = std::array<Complex, beads + 2>;  // displacements along x of wall, beads and lid

// u_n = a zⁿ + b z⁻ⁿ, z = e^(iκ), 4 (k + iωγ) sin²(κ/2) = m ω², with the wall at u_0 and
// (iωγ_l − ω²m_l)(u_(N+1) − d) = (k + iωγ)(u_N − u_(N+1)).
Row exact_column(const Lid& lid, double omega, const Complex& u_0, const Complex& d) {
  const Complex spring(k, omega * damping_constant);
  const Complex inertia = Complex(-omega * omega * lid.mass, omega * lid.viscosity);
  const Complex kappa = 2.0 * std::asin(0.5 * omega * std::sqrt(mass / spring));
  const auto wave = [&](int n) { return std::exp(Complex(0, 1) * kappa * double(n)); };
  const auto at_lid = [&](int sign) {
    return (inertia + spring) * wave(sign * (beads + 1)) - spring * wave(sign * beads);
  };
  const Complex a = (inertia * d - u_0 * at_lid(-1)) / (at_lid(1) - at_lid(-1));
  Row u;
  for (int n = 0; n <= beads + 1; ++n) u[std::size_t(n)] = a * wave(n) + (u_0 - a) * wave(-n);
  return u;
}

// The same from the linear system.
Row column_of(const LinearSystem& system, const HarmonicResponse& response, const Complex& u_0) {
  Row u;
  u.front() = u_0;
  for (std::size_t n = 1; n <= beads; ++n) u[n] = response.amplitude[system.freedom.translation(n - 1, 0)];
  u.back() = -response.amplitude[system.freedom.wall(1)];  // its normal points to −x
  return u;
}

double largest(const Row& u) {
  double most = 0;
  for (const Complex& x : u) most = std::max(most, std::abs(x));
  return most;
}
double difference(const Row& a, const Row& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(a[n] - b[n]));
  return most / largest(b);
}

constexpr double frequency_hz = 5;

// Amplitudes over the last of some periods of a run in which a sine of `amplitude` moves a wall.
Row column_of_run(const Scene& scene, double amplitude) {
  const int per_period = int(std::lround(1 / (frequency_hz * scene.step)));
  Simulation s(scene);
  const auto positions = [&] {
    std::array<double, beads + 2> x;
    x.front() = s.planes()[0].point[0];
    for (std::size_t n = 1; n <= beads; ++n) x[n] = test::position(s, n - 1)[0];
    x.back() = s.planes()[1].point[0];
    return x;
  };
  const auto before = positions();
  s.run(std::uint64_t(20 * per_period), [] { return true; });
  Row sum = {};
  for (int step = 0; step < per_period; ++step) {
    s.step();
    const Complex turn = std::exp(Complex(0, -2 * pi * frequency_hz * s.time()));
    const auto x = positions();
    // Of sin ωt = Im e^(iωt).
    for (std::size_t n = 0; n < x.size(); ++n)
      sum[n] += Complex(0, 2) * (x[n] - before[n]) * turn / (amplitude * per_period);
  }
  return sum;
}

}  // namespace

// As in stiffness_test.cpp: differences of fourth order with steps of 2e-4 radii.
TEST_CASE("the stiffness of walls under stress is the derivative of loads and pressing forces",
          "[response]") {
  const Values smooth = {{"normal_stiffness", {1000}}, {"normal_damping", {0}}};
  const Values springs = {{"normal_stiffness", {1000}},
                          {"normal_damping", {0}},
                          {"tangential_stiffness", {600}},
                          {"static_friction", {50}}};
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    CHECK(error_of_stiffness(boxed(dimension, smooth)) < 1e-8);
    CHECK(error_of_stiffness(boxed(dimension, springs)) < 1e-8);
  }
  const Values hertz = {{"youngs_modulus", {1000}},
                        {"poissons_ratio", {0.25}},
                        {"restitution", {1}},
                        {"friction", {50}},
                        {"history", {2}}};  // potential
  CHECK(error_of_stiffness(boxed(3, hertz, "hertz_mindlin")) < 1e-8);
}

TEST_CASE("the pressing force of a wall follows walls that are driven beside it", "[response]") {
  Scene scene = boxed(2, {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
  Values values = box_of(2);
  values.insert(values.end(), {{"y_low", {box_fixed}}, {"y_high", {box_fixed}}});
  scene.boundaries.clear();
  test::add_boundary(scene, "box", values);
  const LinearSystem system = assemble(Simulation(scene), {.fewest_contacts = 1});
  CHECK(system.freedom.wall(2) == DegreesOfFreedom::none);
  // A wall of length L_y has the force p L_y, and y_high moves outwards; no contact joins the two.
  CHECK(system.wall_stiffness.coeff(system.freedom.wall(0), 2 * 3 + 1) == Approx(-130));
  CHECK(system.wall_stiffness.coeff(system.freedom.wall(0), 2 * 2 + 1) == Approx(130));
  CHECK(system.stiffness.coeff(system.freedom.wall(0), system.freedom.wall(1)) == 0);
}

// Round-off, amplified at most by the quality of the resonances of the chain.
TEST_CASE("a column under a lid with mass and viscosity moves as the discrete chain", "[response]") {
  const double cut_off_hz = std::sqrt(k / mass) / pi;
  for (const Lid& lid : {absorbing, Lid{2, 0.1}, Lid{1e-4, 0}}) {
    const LinearSystem system = column_system(lid);
    REQUIRE(system.freedom.size() == 2 * beads + 1);
    for (const bool superposed : {false, true}) {
      // The lid's direction is −x, and w its displacement along x.
      const Drive drive = {.walls = Eigen::VectorXcd::Unit(4, superposed ? 2 : 0)};
      const Complex u_0 = superposed ? 0 : 1, d = superposed ? 1 : 0;
      for (const double share : {0.03, 0.41, 0.97, 1.3}) {
        CAPTURE(lid.mass, superposed, share);
        const auto responses = solve(system, drive, {share * cut_off_hz});
        const Row exact = exact_column(lid, 2 * pi * share * cut_off_hz, u_0, d);
        CHECK(difference(column_of(system, responses[0], u_0), exact) < 1e-10);
        CHECK(responses[0].residual < 1e-12);
      }
    }
    // Statically the lid gives way.
    const auto still = solve(system, {.walls = Eigen::VectorXcd::Unit(4, 0)}, {0});
    Row all_follow;
    all_follow.fill(1);
    CHECK(difference(column_of(system, still[0], 1), all_follow) < 1e-10);
  }
}

TEST_CASE("a lid without mass keeps its force, and its superposed motion moves nothing", "[response]") {
  LinearSystem system = column_system(absorbing);
  const Eigen::Index lid = system.freedom.wall(1);
  system.mass[lid] = 0;
  system.damping.coeffRef(lid, lid) -= absorbing.viscosity;
  const auto of_others = [&](Eigen::Index row, Eigen::Index, double) { return row != lid; };
  system.wall_damping.prune(of_others);
  system.wall_mass.prune(of_others);
  for (const double frequency : {0.0, 1.0, 11.0}) {
    const auto driven = solve(system, {.walls = Eigen::VectorXcd::Unit(4, 0)}, {frequency});
    if (frequency > 0)
      CHECK(difference(column_of(system, driven[0], 1), exact_column({0, 0}, 2 * pi * frequency, 1, 0)) <
            1e-10);
    CHECK(driven[0].residual < 1e-12);
    CHECK(solve(system, {.walls = Eigen::VectorXcd::Unit(4, 2)}, {frequency})[0].amplitude.norm() < 1e-13);
  }
  // Frequencies of a chain with a fixed and a free end.
  const Modes modes = modes_of(system);
  REQUIRE(modes.square_frequency.size() == 2 * beads);
  const double first = 2 * std::sqrt(k / mass) * std::sin(pi / (2 * (2 * beads + 1)));
  double nearest = 1;
  for (Eigen::Index m = 0; m < modes.square_frequency.size(); ++m) {
    const double off = std::abs(std::sqrt(std::max(0.0, modes.square_frequency[m])) / first - 1);
    if (off >= nearest) continue;
    nearest = off;
    CHECK(modes.shape(lid, m) == Approx(-modes.shape(system.freedom.translation(beads - 1, 0), m)));
  }
  CHECK(nearest < 1e-10);
}

// Velocity Verlet solves the chain with frequencies that are off by (ωh)²/24, at most that of the largest one,
// over some radians of phase along the row; transients have left through the lid.
TEST_CASE("a column under a lid moves in a run as its linear response says", "[response]") {
  const double step = 1e-4, amplitude = 1e-5;
  const double tolerance = std::pow(2 * std::sqrt(k / mass) * step, 2);
  const LinearSystem system = column_system(absorbing);
  const std::vector<double> sine = {1, 0, amplitude, frequency_hz, 0};
  {
    const Scene driven = column(absorbing, step, {{"control", {plane_displacement}}, {"displacement", sine}});
    const auto response = solve(system, {.walls = Eigen::VectorXcd::Unit(4, 0)}, {frequency_hz});
    CHECK(difference(column_of_run(driven, amplitude), column_of(system, response[0], 1)) < tolerance);
  }
  const Scene shaken = column(absorbing, step, {}, {{"superposed", sine}});
  // Along the normal of the lid, −x.
  const auto response = solve(system, {.walls = -Eigen::VectorXcd::Unit(4, 2)}, {frequency_hz});
  CHECK(difference(column_of_run(shaken, amplitude), column_of(system, response[0], 0)) < tolerance);
}

TEST_CASE("a wall under stress that no body touches has no equation", "[response]") {
  Scene scene = column(absorbing, 1e-4);
  scene.boundaries.pop_back();
  test::add_boundary(
      scene, "plane",
      {{"point", {100, 0, 0}}, {"normal", {-1, 0, 0}}, {"control", {plane_force}}, {"force", {0, 1}}}, "lid");
  const LinearSystem system = assemble(Simulation(scene), {.fewest_contacts = 1});
  CHECK(system.freedom.wall(1) == DegreesOfFreedom::none);
  CHECK(system.freedom.size() == 2 * beads);
}
