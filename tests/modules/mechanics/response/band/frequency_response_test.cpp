#include "bead_chain.hpp"
#include "matrices.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/response/band_response.hpp>
#include <scree/response/found_modes.hpp>
#include <scree/response/frequency_response.hpp>

using namespace scree;
using namespace scree::response;
using scree::test::bead_count;
using scree::test::bead_damping;
using scree::test::bead_mass;
using scree::test::bead_overlap;
using scree::test::bead_stiffness;
using scree::test::beads_from;
using scree::test::Complex;
using std::numbers::pi;

namespace {

// A row between a wall on its left and nothing on its right.
LinearSystem fixed_free_chain(double damping) {
  Scene scene = test::scene(2, 1e-4, beads_from(1 - bead_overlap),
                            {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {damping}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}}, "wall");
  return assemble(Simulation(scene), {.fewest_contacts = 1});
}

Eigen::VectorXd longitudinal(const LinearSystem& system) {
  const Modes modes = modes_of(system);
  std::vector<double> along;
  for (Eigen::Index m = 0; m < modes.square_frequency.size(); ++m)
    if (std::abs(modes.shape(system.freedom.translation(0, 0), m)) > 1e-9)
      along.push_back(std::sqrt(modes.square_frequency[m]));
  return Eigen::Map<Eigen::VectorXd>(along.data(), Eigen::Index(along.size()));
}

}  // namespace

TEST_CASE("a chain has the frequencies of a discrete chain", "[response]") {
  const Eigen::VectorXd omega = longitudinal(fixed_free_chain(0));
  REQUIRE(omega.size() == bead_count);
  for (int m = 1; m <= bead_count; ++m) {
    const double exact =
        2 * std::sqrt(bead_stiffness / bead_mass) * std::sin((2 * m - 1) * pi / (2 * (2 * bead_count + 1)));
    // Round-off of the largest eigenvalue in the smallest: 1e-16 (ω_20/ω_1)² = 7e-14.
    CHECK(std::abs(omega[m - 1] / exact - 1) < 1e-12);
  }
}

// u_n = w cos(κ (N + 1/2 − n))/cos(κ (N + 1/2)),  4 (k + iωγ) sin²(κ/2) = m ω²
TEST_CASE("a chain driven by its wall moves as the discrete chain", "[response]") {
  const double cut_off_hz = std::sqrt(bead_stiffness / bead_mass) / pi;
  const std::vector<double> frequencies = {0, 0.03 * cut_off_hz, 0.41 * cut_off_hz, 0.97 * cut_off_hz,
                                           1.3 * cut_off_hz};
  for (const double damping : {0.0, bead_damping}) {
    const LinearSystem system = fixed_free_chain(damping);
    const std::vector<HarmonicResponse> responses =
        solve(system, {.walls = Eigen::VectorXcd::Unit(2, 0)}, frequencies);
    REQUIRE(responses.size() == frequencies.size());
    for (const HarmonicResponse& response : responses) {
      CAPTURE(damping, response.frequency_hz);
      const double omega = 2 * pi * response.frequency_hz;
      const Complex kappa =
          2.0 * std::asin(0.5 * omega * std::sqrt(bead_mass / Complex(bead_stiffness, omega * damping)));
      double difference = 0;
      for (int n = 1; n <= bead_count; ++n) {
        const Complex exact = std::cos(kappa * (bead_count + 0.5 - n)) / std::cos(kappa * (bead_count + 0.5));
        const Complex found = response.amplitude[system.freedom.translation(std::size_t(n - 1), 0)];
        difference = std::max(difference, std::abs(found - exact));
      }
      CHECK(difference < 1e-10 * response.amplitude.norm());
      CHECK(response.residual < 1e-12);
      CHECK(response.error < 1e-10);
    }
  }
}

// A ring of discs with tangential springs and the force P = k δ, of length d and arm d/2 per contact. With
// s = sin(κ/2), c = cos(κ/2), transverse motion y and rotation θ at the wave number κ:
//   m ω² = 4 k s²                                                              along the ring
//   (4 (k_t − P/d) s² − m ω²)(k_t d² c² − I ω²) = (2 k_t d s c)²               y and θ
TEST_CASE("waves in a ring of discs couple rotation and transverse motion", "[response]") {
  const double k_t = 700, distance = 2 - bead_overlap, inertia = 0.5 * bead_mass,
               turning = bead_stiffness * bead_overlap / distance;
  Scene scene = test::scene(2, 1e-4, beads_from(0),
                            {{"normal_stiffness", {bead_stiffness}},
                             {"normal_damping", {0}},
                             {"tangential_stiffness", {k_t}},
                             {"static_friction", {1}}});
  test::add_boundary(scene, "periodic",
                     {{"axes", {0}}, {"lower", {-1, -9, 0}}, {"upper", {-1 + distance * bead_count, 9, 0}}});
  const Modes modes = modes_of(assemble(Simulation(scene)));
  std::vector<double> exact;
  for (int n = 0; n < bead_count; ++n) {
    const double s = std::sin(pi * n / bead_count), c = std::cos(pi * n / bead_count);
    const double transverse = 4 * (k_t - turning) * s * s / bead_mass;
    const double rotation = k_t * distance * distance * c * c / inertia;
    const double coupling = 2 * k_t * distance * s * c / std::sqrt(bead_mass * inertia);
    const double mean = 0.5 * (transverse + rotation);
    const double split = std::hypot(0.5 * (transverse - rotation), coupling);
    exact.insert(exact.end(), {4 * bead_stiffness * s * s / bead_mass, mean - split, mean + split});
  }
  std::sort(exact.begin(), exact.end());
  REQUIRE(modes.square_frequency.size() == Eigen::Index(exact.size()));
  CHECK(modes.asymmetry < 1e-14);
  const double largest = exact.back();
  for (std::size_t m = 0; m < exact.size(); ++m)
    CHECK(std::abs(modes.square_frequency[Eigen::Index(m)] - exact[m]) < 1e-10 * largest);
}

TEST_CASE("an undamped chain driven by nothing stays at rest, and drives of another size are refused",
          "[response]") {
  const LinearSystem system = fixed_free_chain(0);
  const std::vector<HarmonicResponse> responses = solve(system, {}, {1.0});
  CHECK(responses[0].amplitude.norm() == 0);
  CHECK(responses[0].residual == 0);
  CHECK_THROWS_WITH(solve(system, {.force = Eigen::VectorXcd::Ones(3)}, {1.0}),
                    "Drive::force has 3 components; give 40 or none");
}

TEST_CASE("a chain that nothing holds has no static response", "[response]") {
  const Scene scene =
      test::scene(2, 1e-4, beads_from(0), {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {0}}});
  const LinearSystem system = assemble(Simulation(scene), {.fewest_contacts = 1});
  const Drive drive = {.force = Eigen::VectorXcd::Unit(system.freedom.size(), 0)};
  // Its stiffness has an exact zero pivot: all its numbers are multiples of k/m.
  const auto refused = Catch::Contains(
      "the response at 0 Hz is infinite: no contact resists some motion, such as that of bodies with too few contacts; compress");
  CHECK_THROWS_WITH(solve(system, drive, {0.0}), refused);
  CHECK_THROWS_WITH(solve_band(system, drive, {1.0, 0.0, 2.0, 3.0}), refused);
  CHECK(solve(system, drive, {1.0})[0].error < 1e-10);
}

TEST_CASE("a stiffness that is singular but for round-off is noticed, and so is a mode at the frequency",
          "[response]") {
  // Beads whose distances are no multiples of anything: no pivot is exactly 0.
  std::vector<Body> bodies = beads_from(0);
  for (std::size_t n = 0; n < bodies.size(); ++n) bodies[n].position[0] += 1e-4 * std::sin(1.3 * double(n));
  const Scene scene = test::scene(2, 1e-4, std::move(bodies),
                                  {{"normal_stiffness", {bead_stiffness / 3}}, {"normal_damping", {0}}});
  const LinearSystem free = assemble(Simulation(scene), {.fewest_contacts = 1});
  const Drive drive = {.force = Eigen::VectorXcd::Unit(free.freedom.size(), 0)};
  CHECK_THROWS_WITH(solve(free, drive, {0.0}), Catch::Contains("the response at 0 Hz is infinite"));
  CHECK_THROWS_WITH(solve_band(free, drive, {0.0}), Catch::Contains("the response at 0 Hz is infinite"));
  CHECK(solve_band(free, drive, {1.0}, {.tolerance = 1e-6}).responses[0].error < 1e-6);

  const LinearSystem held = fixed_free_chain(0);
  const double mode = longitudinal(held)[3] / (2 * pi);
  CHECK_THROWS_WITH(
      solve(held, {.walls = Eigen::VectorXcd::Unit(2, 0)}, {mode}),
      Catch::Contains("an undamped mode has this frequency") && Catch::Contains("; add damping"));
}
