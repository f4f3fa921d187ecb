#include "harmonic_motion.hpp"

#include "chain.hpp"

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

TEST_CASE("the harmonic motion of a chain on a moving floor is that of its closed form", "[spectrum]") {
  const scenario::Plan plan = driven_plan_of(Chain().text("from_hz = 20\nto_hz = 160\nstep_hz = 20\n"));
  const auto simulation = run::set_up(plan);
  const std::vector<double> frequencies = {20, 87, 160};
  const HarmonicMotion motion =
      harmonic_motion(*simulation, {Vec3{{0, 0, 1}}}, frequencies, {.fewest_contacts = 1}, {});
  REQUIRE(motion.responses.size() == frequencies.size());
  CHECK(motion.sliding_contacts == 0);
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    CHECK(motion.responses[k].frequency_hz == frequencies[k]);
    for (int n = 1; n <= Chain::beads; ++n) {
      CAPTURE(frequencies[k], n);
      const auto z = motion.freedom.translation(std::size_t(n - 1), 2);
      const std::complex<double> exact = Chain().response(n, frequencies[k]);
      // Eight degrees of freedom along the chain: round-off, some of the largest stiffness over the least.
      CHECK(std::abs(motion.responses[k].amplitude[z] - exact) < 1e-9 * std::abs(exact));
    }
  }
}
