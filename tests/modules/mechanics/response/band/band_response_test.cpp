#include "packings.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/response/band_response.hpp>

using namespace scree;
using namespace scree::response;

namespace {

// Spheres on a cubic lattice above a plane, with tangential springs.
LinearSystem sphere_lattice(int side, double normal_damping = 0.6, double tangential_stiffness = 700,
                            TimeStep time_step = TimeStep::limit) {
  std::vector<Body> bodies;
  for (int n = 0; n < side * side * side; ++n) {
    const double wobble = 1e-3 * std::sin(1.7 * n);
    bodies.push_back(test::body(
        n, 1, 1, {{1.99 * (n % side), 1.99 * (n / side % side), 0.995 + 1.99 * (n / side / side) + wobble}},
        {}, {}, 3));
  }
  Scene scene = test::scene(3, time_step == TimeStep::limit ? 1e-4 : 5e-3, std::move(bodies),
                            {{"normal_stiffness", {1000}},
                             {"normal_damping", {normal_damping}},
                             {"tangential_stiffness", {tangential_stiffness}},
                             {"static_friction", {50}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}}, "floor");
  return assemble(Simulation(scene), {.fewest_contacts = 1, .time_step = time_step});
}

std::vector<double> frequency_grid(double from, double to, int count) {
  std::vector<double> frequencies;
  for (int k = 0; k < count; ++k) frequencies.push_back(from + (to - from) * k / (count - 1));
  return frequencies;
}

// In the coordinates √M q.
double relative_difference(const LinearSystem& system, const HarmonicResponse& a, const HarmonicResponse& b) {
  const Eigen::VectorXd root = system.mass.cwiseSqrt();
  return (root.asDiagonal() * (a.amplitude - b.amplitude)).norm() / (root.asDiagonal() * b.amplitude).norm();
}

}  // namespace

TEST_CASE("a band has the amplitudes of one factorisation per frequency", "[response]") {
  const Drive drive = {.walls = Eigen::VectorXcd::Unit(3, 2)};
  std::vector<double> frequencies = frequency_grid(0.25, 12, 48);
  std::swap(frequencies[3], frequencies[30]);
  for (const LinearSystem& system :
       {sphere_lattice(5), sphere_lattice(4, 0.1, 300), sphere_lattice(4, 3, 900),
        sphere_lattice(4, 0.6, 700, TimeStep::of_run)}) {
    const std::vector<HarmonicResponse> exact = solve(system, drive, frequencies);
    for (const double tolerance : {1e-2, 1e-10}) {
      CAPTURE(system.freedom.size(), tolerance);
      const BandResponse band = solve_band(system, drive, frequencies, {.tolerance = tolerance});
      REQUIRE(band.responses.size() == frequencies.size());
      CHECK(band.statistics.factorisations < int(frequencies.size()));
      for (std::size_t k = 0; k < frequencies.size(); ++k) {
        const HarmonicResponse& found = band.responses[k];
        CAPTURE(found.frequency_hz, found.error);
        CHECK(found.frequency_hz == frequencies[k]);
        CHECK(found.error <= tolerance);
        // 1e-11: round-off of both solutions, whose matrix has a condition of 1e5 near modes.
        CHECK(relative_difference(system, found, exact[k]) < found.error + 1e-11);
      }
    }
  }
}

TEST_CASE("a band does not depend on the number of threads", "[response][threads]") {
  const LinearSystem system = sphere_lattice(3);
  const Drive drive = {.force = Eigen::VectorXcd::Unit(system.freedom.size(), 4)};
  const std::vector<double> frequencies = frequency_grid(1, 9, 23);
  const BandResponse one = solve_band(system, drive, frequencies, {.threads = 1});
  const BandResponse three = solve_band(system, drive, frequencies, {.threads = 3});
  for (std::size_t k = 0; k < frequencies.size(); ++k)
    CHECK(one.responses[k].amplitude == three.responses[k].amplitude);
}

TEST_CASE("a band without a drive is at rest, and tolerances of 0 are refused", "[response]") {
  const LinearSystem system = sphere_lattice(2);
  const BandResponse band = solve_band(system, {}, {1.0, 2.0});
  CHECK(band.responses[1].amplitude.norm() == 0);
  CHECK(band.responses[1].error == 0);
  CHECK_THROWS_WITH(solve_band(system, {}, {1.0}, {.tolerance = 0}),
                    "BandOptions::tolerance is 0; give a number above 0");
}

// test_modules_mechanics_response "[.estimates]" prints the numbers of modules/mechanics/response/README.md.
TEST_CASE("errors of a band are seldom above their estimates", "[.estimates]") {
  const Drive drive = {.walls = Eigen::VectorXcd::Unit(3, 2)};
  int all = 0, above = 0;
  double worst = 0;
  for (int n = 0; n < 24; ++n) {
    const LinearSystem system =
        sphere_lattice(3 + n % 3, 0.04 * std::pow(1.27, n), 170 + 41 * ((5 * n) % 23));
    const std::vector<double> frequencies = frequency_grid(0.3 + 0.01 * n, 13 + 0.2 * n, 61);
    const std::vector<HarmonicResponse> exact = solve(system, drive, frequencies);
    for (const double tolerance : {3e-2, 1e-2, 1e-3, 1e-6}) {
      const BandResponse band = solve_band(system, drive, frequencies, {.tolerance = tolerance});
      for (std::size_t k = 0; k < frequencies.size(); ++k) {
        const HarmonicResponse& found = band.responses[k];
        const double ratio = relative_difference(system, found, exact[k]) / (found.error + 1e-11);
        ++all, above += ratio > 1, worst = std::max(worst, ratio);
      }
    }
  }
  WARN(above << " of " << all << " errors are above their estimates, the worst by a factor " << worst);
  CHECK(above < 0.01 * all);
}

TEST_CASE("a band that was stopped goes on to the same bits", "[response]") {
  const LinearSystem system = sphere_lattice(5);
  const Drive drive = {.walls = Eigen::VectorXcd::Unit(3, 2)};
  const std::vector<double> frequencies = frequency_grid(0.25, 12, 96);
  const BandResponse whole = solve_band(system, drive, frequencies, {.threads = 1});
  for (const unsigned threads : {1u, 2u}) {
    std::atomic<bool> stop = false;
    double last = 0;
    const auto on_progress = [&](double share) {
      CHECK(share > last);
      last = share;
      if (share > 0.6) stop = true;
    };
    BandResponse parts = solve_band(system, drive, frequencies,
                                    {.threads = threads, .on_progress = on_progress, .stop = &stop});
    CAPTURE(threads, parts.responses.size());
    REQUIRE(parts.responses.size() < frequencies.size());
    if (threads == 1)
      CHECK(parts.responses.size() == 48);  // two windows of 24; the one that was stopped is left out
    std::vector<double> left;
    for (const double f : frequencies)
      if (std::none_of(parts.responses.begin(), parts.responses.end(),
                       [f](const HarmonicResponse& r) { return r.frequency_hz == f; }))
        left.push_back(f);
    for (HarmonicResponse& r : solve_band(system, drive, left, {.threads = threads}).responses)
      parts.responses.push_back(std::move(r));
    REQUIRE(parts.responses.size() == frequencies.size());
    for (const HarmonicResponse& r : parts.responses)
      for (const HarmonicResponse& exact : whole.responses)
        if (exact.frequency_hz == r.frequency_hz) CHECK(exact.amplitude == r.amplitude);
  }
}
