#include "over_ranks.hpp"
#include "sanitized.hpp"
#include "step/sliding_layers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/probes.hpp>
#include <scree/simulation.hpp>

// Probes that add up numbers over tiles.

using namespace scree;
using namespace scree::test;

namespace {

constexpr int steps_apart = sanitized ? 6 : 40;

struct Case {
  const char* plugin;
  Values values;
};

// A part of the scene with bins across y.
Values joined(Values values, const Values& more) {
  values.insert(values.end(), more.begin(), more.end());
  return values;
}
const Values layers = {
    {"region", {1}}, {"lower", {3, 1, 2}}, {"upper", {17, 21, 29}}, {"along", {1}}, {"bins", {3}}};
const Values around = {{"region", {2}}, {"centre", {2, 1, 1}}, {"radius", {7}}, {"follow", {1501}}};

std::vector<Case> cases() {
  std::vector<Case> all = {{"momentum", {{"about", {1, 2, 3}}}},
                           {"contacts", {}},
                           {"unbalanced_force", {}},
                           {"stress", {{"kinetic", {1}}}},
                           {"forces", {{"walls", {1}}}},
                           {"fabric", joined(layers, {{"walls", {1}}})}};
  for (const char* plugin : {"stress", "temperature", "velocity", "solid_fraction", "fabric"}) {
    all.push_back({plugin, layers});
    all.push_back({plugin, around});
  }
  all.push_back({"stress", joined(around, {{"kinetic", {1}}})});
  all.push_back({"stress", joined(layers, {{"kinetic", {2}}})});
  all.push_back({"forces", around});
  return all;
}

// Every third body is left out in every second case.
std::vector<std::uint8_t> left_out_in(std::size_t number, const Scene& scene) {
  std::vector<std::uint8_t> left_out;
  for (std::size_t i = 0; number % 2 && i < scene.bodies.size(); ++i) left_out.push_back(i % 3 == 0);
  return left_out;
}

std::vector<Probe> probes_of(const Scene& scene) {
  std::vector<Probe> probes;
  for (const auto& [plugin, values] : cases())
    probes.emplace_back(parameters(plugin, SCREE_PROBE, values), scene.dimension,
                        left_out_in(probes.size(), scene));
  return probes;
}

// With the totals of a simulation, and a view of walls alone once the probe has started.
std::vector<double> row_of(Probe& probe, const Simulation& s) {
  const SimulationView view(s, probe.view_needs(), NAN, probe.listed_bodies());
  return probe.sample(view.get(), {}, [&] { return s.totals_of(probe); });
}

// Rows at several times, as bits.
std::vector<std::uint64_t> rows_in_a_run(const Scene& scene, Ranks* ranks) {
  Simulation s(scene, ranks);
  std::vector<Probe> probes = probes_of(scene);
  std::vector<std::uint64_t> bits;
  for (int time = 0; time < 3; ++time) {
    for (Probe& probe : probes)
      for (const double x : row_of(probe, s)) bits.push_back(std::bit_cast<std::uint64_t>(x));
    s.run(steps_apart, [] { return true; });
  }
  return bits;
}

Scene moving_layers(unsigned threads) {
  Scene scene = sliding_layers(3);
  scene.threads = threads;
  return scene;
}

}  // namespace

TEST_CASE("totals of probes are the same bits on any number of ranks and threads", "[ranks]") {
  const std::vector<std::uint64_t> expected = rows_in_a_run(moving_layers(1), nullptr);
  CHECK(rows_in_a_run(moving_layers(3), nullptr) == expected);
  for (const bool at_random : {false, true})
    for (const unsigned count : {1u, 2u, 3u})
      over_ranks(count, at_random, [&](Ranks& ranks) {
        INFO(count << " ranks, tiles at random " << at_random);
        CHECK(rows_in_a_run(moving_layers(1), &ranks) == expected);
      });
}

// Their evaluation leaves bodies of other ranks where they are in the middle of a step, or as predicted.
TEST_CASE("totals are of the end of a step with each integrator", "[ranks]") {
  for (const Integration integration : {Integration::position_verlet, Integration::predictor_corrector}) {
    Scene scene = moving_layers(1);
    scene.integration = integration;
    const std::vector<std::uint64_t> expected = rows_in_a_run(scene, nullptr);
    over_ranks(2, false, [&](Ranks& ranks) { CHECK(rows_in_a_run(scene, &ranks) == expected); });
  }
}

// The sums of tiles differ from the sum over all bodies by round-off alone: of 2400 terms and means of them,
// about 2400 · 1.1e-16 of the sum of magnitudes, of which components may be a small part.
TEST_CASE("totals over tiles are those over all bodies and contacts", "[probe]") {
  Simulation s(moving_layers(1));
  s.run(2 * steps_apart, [] { return true; });
  REQUIRE(s.scene().bodies.size() >= 2048);
  for (Probe& probe : probes_of(s.scene())) {
    const SimulationView all(s, probe.needs());
    const std::vector<double> expected = probe.sample(all.get()), row = row_of(probe, s);
    REQUIRE(row.size() == expected.size());
    double largest = 0;
    for (const double x : expected)
      if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
    CHECK(largest > 0);
    for (std::size_t c = 0; c < row.size(); ++c) {
      INFO(probe.parameters().plugin().name << ": " << probe.names()[c]);
      if (std::isnan(expected[c]))
        CHECK(std::isnan(row[c]));
      else
        CHECK(std::abs(row[c] - expected[c]) <= 1e-10 * largest);
    }
  }
}

TEST_CASE("a probe with totals that fails on any rank is reported as in one process", "[ranks]") {
  PluginHost laws({SCREE_TEST_LAWS});
  const Scene scene = sliding_layers(3);
  const auto failure_of = [&](double id, bool throws, Ranks* ranks) {
    Parameters parameters(laws.find("failing", SCREE_PROBE));
    parameters.set("id", {id});
    parameters.set("throws", {double(throws)});
    Simulation s(scene, ranks);
    s.run(2, [] { return true; });
    Probe probe(parameters, 3);
    std::string failure = "nothing";
    try {
      const std::vector<double> row = row_of(probe, s);
      CHECK(row == std::vector<double>{double(scene.bodies.size()), double(scene.bodies.size() - 1)});
    } catch (const Error& error) {
      failure = error.what();
    }
    s.run(2, [] { return true; });  // goes on
    return failure;
  };
  struct Failing {
    double id;
    bool throws;
    const char* text;
  };
  for (const Failing& failing : {Failing{2200.0, true, "its function accumulate threw an exception (boo)"},
                                 {2200.0, false, "a largest value of its totals is not a number"},
                                 {-1.0, true, "nothing"}}) {
    const std::string alone = failure_of(failing.id, failing.throws, nullptr);
    CHECK_THAT(alone, Catch::Contains(failing.text));
    for (const unsigned count : {2u, 3u})
      over_ranks(count, false,
                 [&](Ranks& ranks) { CHECK(failure_of(failing.id, failing.throws, &ranks) == alone); });
  }
}
