#include "mode_properties.hpp"

#include "bead_row.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/response/found_modes.hpp>

using namespace scree;
using namespace scree::modes;
using namespace scree::test;

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
