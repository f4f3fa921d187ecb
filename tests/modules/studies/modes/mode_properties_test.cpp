#include "mode_properties.hpp"

#include "scenes.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/modes/density.hpp>
#include <scree/response/found_modes.hpp>

using namespace scree;
using namespace scree::modes;

namespace {

constexpr double stiffness = 1000, damping = 2, mass = 0.3;
constexpr int beads = 20;

// A row of beads along x between a wall and nothing, without a stress that would turn it over.
response::LinearSystem chain() {
  const double overlap = 1e-12;
  std::vector<Body> bodies;
  for (int n = 0; n < beads; ++n)
    bodies.push_back(test::body(n, 1, mass, {{1 - overlap + (2 - overlap) * n, 0, 0}}, {}, {}, 2));
  Scene scene = test::scene(2, 1e-4, std::move(bodies),
                            {{"normal_stiffness", {stiffness}}, {"normal_damping", {damping}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}}, "wall");
  return response::assemble(Simulation(scene), {.fewest_contacts = 1});
}

}  // namespace

// Beads in the first mode move as sin(κ n), κ = π/(2 N + 1); C = γ/k K.
TEST_CASE("the first mode of a chain has its frequency, participation, direction and damping",
          "[vibration]") {
  const response::LinearSystem system = chain();
  const response::FoundModes found = find_modes(response::UndampedSystem(system), {.count = 3});
  const std::vector<Mode> modes = properties_of(found, system);
  REQUIRE(modes.size() == beads + 3);
  const Mode& first = modes[beads];
  CHECK(first.kind == ModeKind::vibrating);
  CHECK(first.number == 1);
  const double kappa = std::numbers::pi / (2 * beads + 1);
  double sum = 0, squares = 0;
  for (int n = 1; n <= beads; ++n) {
    const double e = std::pow(std::sin(kappa * n), 2);
    sum += e, squares += e * e;
  }
  const double omega = 2 * std::sqrt(stiffness / mass) * std::sin(0.5 * kappa);
  // Round-off of the largest ω² in the smallest: 1e-13.
  CHECK(first.frequency_hz == Approx(omega / (2 * std::numbers::pi)).epsilon(1e-10));
  CHECK(first.participation == Approx(sum * sum / (beads * squares)).epsilon(1e-10));
  CHECK(first.direction[0] == Approx(1).epsilon(1e-10));
  CHECK(first.direction[1] == Approx(0).margin(1e-10));
  CHECK(first.rotation == 0);
  CHECK(first.damping_rate == Approx(damping / stiffness * omega * omega).epsilon(1e-10));
  CHECK(first.participants.front().body == beads - 1);
}

TEST_CASE("floppy modes name the bodies that move in them", "[vibration]") {
  const response::LinearSystem system = chain();
  const response::FoundModes found = find_modes(response::UndampedSystem(system), {.count = 1});
  // Each bead may move across the row.
  CHECK(found.floppy + found.unstable == beads);
  double sum = 0;
  for (const Participant& p : floppy_bodies(found, system)) sum += p.share;
  CHECK(sum == Approx(double(found.floppy)).epsilon(1e-10));
}

TEST_CASE("the density of states counts all modes, as a dense solver finds them", "[vibration]") {
  const response::LinearSystem system = chain();
  const response::UndampedSystem undamped(system);
  const std::vector<DensityPoint> points = density_of_states(undamped, beads, {.points = 17, .threads = 2});
  const Eigen::ArrayXd squares = modes_of(system).square_frequency.array();
  const auto resting = (squares <= undamped.rounding()).count();
  REQUIRE(points.size() == 17);
  double integral = 0;
  for (const DensityPoint& p : points) {
    const double omega = 2 * std::numbers::pi * p.to_hz;
    CHECK(p.below == std::size_t((squares < omega * omega).count() - resting));
    const double middle = 0.5 * (p.from_hz + p.to_hz);
    CHECK(p.reduced == Approx(p.density / middle));
    integral += p.density * (p.to_hz - p.from_hz) * beads;
  }
  CHECK(integral == Approx(beads));
  CHECK(points.back().below == beads);
}
