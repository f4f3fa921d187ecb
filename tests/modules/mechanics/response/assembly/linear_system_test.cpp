#include "bead_chain.hpp"
#include "matrices.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/response/found_modes.hpp>
#include <scree/response/frequency_response.hpp>
#include <scree/response/linear_system.hpp>

// A column of beads under a lid that forces move.

using namespace scree;
using namespace scree::response;
using scree::test::bead_count;
using scree::test::bead_damping;
using scree::test::bead_mass;
using scree::test::bead_overlap;
using scree::test::bead_stiffness;
using scree::test::beads_from;
using scree::test::Complex;
using scree::test::Values;
using std::numbers::pi;

namespace {

enum { plane_displacement = 1, plane_force = 4 };

struct Lid {
  double mass, viscosity;
};
// A lid that absorbs waves, so that a run becomes steady.
constexpr Lid absorbing = {0.2, 15};

// Beads in a row along x between a wall on the left, with the given motion, and a lid under a force on the
// right.
Scene lid_column(const Lid& lid, double step, const Values& left = {}, const Values& right = {}) {
  Scene scene = test::scene(2, step, beads_from(1 - bead_overlap),
                            {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {bead_damping}}});
  Values wall = {{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}};
  wall.insert(wall.end(), left.begin(), left.end());
  test::add_boundary(scene, "plane", wall, "wall");
  Values pressed = {{"point", {(2 - bead_overlap) * bead_count - bead_overlap, 0, 0}},
                    {"normal", {-1, 0, 0}},
                    {"control", {plane_force}},
                    {"force", {0, bead_stiffness * bead_overlap}},
                    {"mass", {lid.mass}},
                    {"viscosity", {lid.viscosity}}};
  pressed.insert(pressed.end(), right.begin(), right.end());
  test::add_boundary(scene, "plane", pressed, "lid");
  return scene;
}

LinearSystem column_system(const Lid& lid) {
  return assemble(Simulation(lid_column(lid, 1e-4)), {.fewest_contacts = 1});
}

using Row = std::array<Complex, bead_count + 2>;  // displacements along x of wall, beads and lid

// u_n = a zⁿ + b z⁻ⁿ, z = e^(iκ), 4 (k + iωγ) sin²(κ/2) = m ω², with the wall at u_0 and
// (iωγ_l − ω²m_l)(u_(N+1) − d) = (k + iωγ)(u_N − u_(N+1)).
Row exact_column(const Lid& lid, double omega, const Complex& u_0, const Complex& d) {
  const Complex spring(bead_stiffness, omega * bead_damping);
  const Complex inertia = Complex(-omega * omega * lid.mass, omega * lid.viscosity);
  const Complex kappa = 2.0 * std::asin(0.5 * omega * std::sqrt(bead_mass / spring));
  const auto wave = [&](int n) { return std::exp(Complex(0, 1) * kappa * double(n)); };
  const auto at_lid = [&](int sign) {
    return (inertia + spring) * wave(sign * (bead_count + 1)) - spring * wave(sign * bead_count);
  };
  const Complex a = (inertia * d - u_0 * at_lid(-1)) / (at_lid(1) - at_lid(-1));
  Row u;
  for (int n = 0; n <= bead_count + 1; ++n) u[std::size_t(n)] = a * wave(n) + (u_0 - a) * wave(-n);
  return u;
}

// The same from the linear system.
Row column_of(const LinearSystem& system, const HarmonicResponse& response, const Complex& u_0) {
  Row u;
  u.front() = u_0;
  for (std::size_t n = 1; n <= bead_count; ++n)
    u[n] = response.amplitude[system.freedom.translation(n - 1, 0)];
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
    std::array<double, bead_count + 2> x;
    x.front() = s.planes()[0].point[0];
    for (std::size_t n = 1; n <= bead_count; ++n) x[n] = test::position(s, n - 1)[0];
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

// Round-off, amplified at most by the quality of the resonances of the chain.
TEST_CASE("a column under a lid with mass and viscosity moves as the discrete chain", "[response]") {
  const double cut_off_hz = std::sqrt(bead_stiffness / bead_mass) / pi;
  for (const Lid& lid : {absorbing, Lid{2, 0.1}, Lid{1e-4, 0}}) {
    const LinearSystem system = column_system(lid);
    REQUIRE(system.freedom.size() == 2 * bead_count + 1);
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
  REQUIRE(modes.square_frequency.size() == 2 * bead_count);
  const double first = 2 * std::sqrt(bead_stiffness / bead_mass) * std::sin(pi / (2 * (2 * bead_count + 1)));
  double nearest = 1;
  for (Eigen::Index m = 0; m < modes.square_frequency.size(); ++m) {
    const double off = std::abs(std::sqrt(std::max(0.0, modes.square_frequency[m])) / first - 1);
    if (off >= nearest) continue;
    nearest = off;
    CHECK(modes.shape(lid, m) == Approx(-modes.shape(system.freedom.translation(bead_count - 1, 0), m)));
  }
  CHECK(nearest < 1e-10);
}

// Velocity Verlet solves the chain with frequencies that are off by (ωh)²/24, at most that of the largest
// one, over some radians of phase along the row; transients have left through the lid.
TEST_CASE("a column under a lid moves in a run as its linear response says", "[response]") {
  const double step = 1e-4, amplitude = 1e-5;
  const double tolerance = std::pow(2 * std::sqrt(bead_stiffness / bead_mass) * step, 2);
  const LinearSystem system = column_system(absorbing);
  const std::vector<double> sine = {1, 0, amplitude, frequency_hz, 0};
  {
    const Scene driven =
        lid_column(absorbing, step, {{"control", {plane_displacement}}, {"displacement", sine}});
    const auto response = solve(system, {.walls = Eigen::VectorXcd::Unit(4, 0)}, {frequency_hz});
    CHECK(difference(column_of_run(driven, amplitude), column_of(system, response[0], 1)) < tolerance);
  }
  const Scene shaken = lid_column(absorbing, step, {}, {{"superposed", sine}});
  // Along the normal of the lid, −x.
  const auto response = solve(system, {.walls = -Eigen::VectorXcd::Unit(4, 2)}, {frequency_hz});
  CHECK(difference(column_of_run(shaken, amplitude), column_of(system, response[0], 0)) < tolerance);
}

TEST_CASE("a wall under stress that no body touches has no equation", "[response]") {
  Scene scene = lid_column(absorbing, 1e-4);
  scene.boundaries.pop_back();
  test::add_boundary(
      scene, "plane",
      {{"point", {100, 0, 0}}, {"normal", {-1, 0, 0}}, {"control", {plane_force}}, {"force", {0, 1}}}, "lid");
  const LinearSystem system = assemble(Simulation(scene), {.fewest_contacts = 1});
  CHECK(system.freedom.wall(1) == DegreesOfFreedom::none);
  CHECK(system.freedom.size() == 2 * bead_count);
}
