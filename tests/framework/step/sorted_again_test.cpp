#include "contacts/contacts.hpp"
#include "state/heap.hpp"
#include "step/sliding_layers.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <catch2/catch.hpp>

#include <scree/plugin/program.hpp>
#include <scree/scene_record.hpp>
#include <scree/spatial_order.hpp>

// Bodies that mix until they are sorted again in memory, in scenes of several tiles.

using scree::Body;
using scree::BodyGroup;
using scree::ContactList;
using scree::Integration;
using scree::Program;
using scree::Scene;
using scree::Simulation;
using scree::State;
using scree::Vec3;
using scree::test::check_same;
using scree::test::integrators;
using scree::test::sliding_layers;

namespace {

constexpr const char* order_in_memory = "bodies/number_in_memory";

// The last state before the bodies are first sorted again, and the first one after it.
struct AroundSort {
  State before, after;
};
AroundSort around_sort(const Scene& scene) {
  Simulation s(scene);
  constexpr int every = 10;
  AroundSort states;
  do {
    states.before = s.state();
    scree::test::run(s, every);
    REQUIRE(s.steps() < 500);
  } while (!s.state().has(order_in_memory));
  Simulation again(scene, states.before);
  for (states.after = states.before; !states.after.has(order_in_memory); states.after = again.state()) {
    states.before = states.after;
    again.step();
  }
  return states;
}

State without(const State& state, const std::string& left_out) {
  State rest;
  for (const auto& [path, array] : state.arrays())
    if (path != left_out) rest.put(path, array);
  return rest;
}

// The largest difference of two columns relative to the largest number.
template <class Numbers>
double difference(const Numbers& a, const Numbers& b) {
  double largest = 0, apart = 0;
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(double(a[i])));
    apart = std::max(apart, std::abs(double(a[i]) - double(b[i])));
  }
  return largest > 0 ? apart / largest : apart;
}

// Forces are sums of few terms in another order, and velocities follow from them in one step: some units of
// round-off of the largest term, of which the sums may be a hundredth.
constexpr double reordered = 1e-12;

void check_same_but_for_round_off(const Simulation& a, const Simulation& b) {
  const scree::Particles &p = a.particles(), &q = b.particles();
  for (int k = 0; k < a.dimension(); ++k) {
    CHECK(difference(p.position()[k], q.position()[k]) <= reordered);
    CHECK(difference(p.velocity()[k], q.velocity()[k]) <= reordered);
    CHECK(difference(p.force()[k], q.force()[k]) <= reordered);
  }
  CHECK(difference(p.spin()[2], q.spin()[2]) <= reordered);
  CHECK(difference(p.torque()[2], q.torque()[2]) <= reordered);
  CHECK(std::equal(p.id.begin(), p.id.end(), q.id.begin()));
  CHECK(std::equal(p.fixed.begin(), p.fixed.end(), q.fixed.begin()));
  const ContactList c = a.contact_list(), d = b.contact_list();
  CHECK(c.a == d.a);
  CHECK(c.b == d.b);
  CHECK(c.sliding == d.sliding);
  CHECK(difference(c.force, d.force) <= reordered);
  CHECK(difference(c.normal, d.normal) <= reordered);
  for (std::uint32_t k = 0; k < 4; ++k) {
    std::vector<double> one, other;
    for (std::size_t i = 0; i < c.size(); ++i) {
      one.push_back(a.contact_history(c.pair[i], k));
      other.push_back(b.contact_history(d.pair[i], k));
    }
    CHECK(difference(one, other) <= reordered);
  }
  CHECK(a.energy().kinetic_translation == Approx(b.energy().kinetic_translation).epsilon(reordered));
  CHECK(a.energy().residual == Approx(b.energy().residual).margin(1e-12 * a.energy().kinetic_translation));
}

}  // namespace

TEST_CASE("bodies that have mixed are sorted again in memory, and only round-off tells", "[order]") {
  const int dimension = GENERATE(2, 3);
  Scene scene = sliding_layers(dimension);
  const AroundSort states = around_sort(scene);
  scene.bodies = scree::bodies_at_start(states.before);
  Simulation sorted(scene, states.before);
  // With this share after the last sort, bodies are not sorted again.
  State content = states.before;
  content.put("neighbours/crossing_when_sorted", {std::vector<double>{1}, {}, "1"});
  Simulation kept(scene, content);
  sorted.step(), kept.step();
  REQUIRE(sorted.state().has(order_in_memory));
  REQUIRE(!kept.state().has(order_in_memory));
  REQUIRE(sorted.contact_list().size() > 1000);  // of some 2200 bodies
  check_same_but_for_round_off(sorted, kept);
  CHECK(sorted.contacts().crossing().share() < kept.contacts().crossing().share() / 1.1);
}

TEST_CASE("a state lists bodies in the order of the scene, wherever they are in memory", "[order]") {
  Scene scene = sliding_layers(GENERATE(2, 3));
  const AroundSort states = around_sort(scene);
  scene.bodies = scree::bodies_at_start(states.after);
  Simulation sorted(scene, states.after), plain(scene, without(states.after, order_in_memory));
  check_same(states.after, sorted.state());
  CHECK(plain.state_hash() == sorted.state_hash());
  sorted.step(), plain.step();
  check_same_but_for_round_off(sorted, plain);
}

TEST_CASE("simulations go on across a sort to the same bits, with any number of threads",
          "[order][threads]") {
  const int dimension = GENERATE(2, 3);
  Scene scene = sliding_layers(dimension);
  const Integration integration = GENERATE(from_range(std::begin(integrators), std::end(integrators)));
  // Under a sanitizer, the integrator that keeps most of each body.
  if (scree::test::sanitized && integration != Integration::predictor_corrector) return;
  scene.integration = integration;
  INFO(dimension << "D, integrator " << int(integration));
  const AroundSort states = around_sort(scene);
  scene.bodies = scree::bodies_at_start(states.before);
  Simulation whole(scene, states.before);
  scree::test::run(whole, 8);
  const State end = whole.state();
  REQUIRE(end.has(order_in_memory));
  for (const unsigned threads : {2u, 3u}) {
    scene.threads = threads;
    Simulation unobserved(scene, states.before), resumed(scene, states.after);
    unobserved.run(8, [] { return true; });
    resumed.run(8 - (resumed.steps() - Simulation(scene, states.before).steps()), [] { return true; });
    check_same(end, unobserved.state());
    check_same(end, resumed.state());
  }
}

TEST_CASE("an order in memory that does not list each body once is refused", "[order]") {
  Scene scene = sliding_layers(2);
  const AroundSort states = around_sort(scene);
  scene.bodies = scree::bodies_at_start(states.after);
  const auto given = std::get<std::vector<std::uint32_t>>(states.after.at(order_in_memory).values);
  std::vector<std::uint32_t> twice = given, unknown = given, too_few = given;
  twice[0] = twice[1];
  unknown[0] = std::uint32_t(unknown.size());
  too_few.pop_back();
  for (const auto& numbers : {twice, unknown, too_few}) {
    State damaged = states.after;
    damaged.put(order_in_memory, {numbers, {numbers.size()}, ""});
    CHECK_THAT(scree::test::error_line([&] { Simulation(scene, damaged); }),
               Catch::Contains("number_in_memory") && Catch::Contains("does not list each body once"));
  }
}

TEST_CASE("bodies that have been sorted again come to rest where they are", "[order][rest]") {
  Scene scene = sliding_layers(2);
  const AroundSort states = around_sort(scene);
  scene.bodies = scree::bodies_at_start(states.after);
  const Simulation moving(scene, states.after);
  const scree::Particles& p = moving.particles();
  // Each body a tenth of a radius higher, so that what was copied before tells.
  std::vector<Vec3> places, planes;
  for (std::size_t i = 0; i < p.size(); ++i) {
    Vec3 x = p.body(i).position;
    for (int k = 0; k < 2; ++k) x[k] += p.image[k][i] * moving.domain().length(k);
    x[1] += 0.1;
    places.push_back(x);
  }
  for (const scree_plane& plane : moving.planes())
    planes.push_back({{plane.point[0], plane.point[1], plane.point[2]}});
  const State rest = moving.state_at_rest(
      {moving.time(), places, planes, moving.loads(), {}, {}, moving.particles().orientations, {}});
  const Simulation resting(scene, rest);
  CHECK(rest.has(order_in_memory));
  CHECK(resting.energy().kinetic_translation == 0);
  double apart = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    apart = std::max(apart, std::abs(resting.particles().position()[1][i] - places[i][1]));
  CHECK(apart == 0);
}

TEST_CASE("loads of several groups on the same bodies are added in one order, whatever sorts were before",
          "[order][loads]") {
  Scene scene = sliding_layers(2);
  std::vector<std::uint32_t> shared;
  for (std::uint32_t i = 0; i < scene.bodies.size(); i += 10)
    if (!scene.bodies[i].fixed && !scene.bodies[i].held) shared.push_back(i);
  for (const double load : {0.1, 0.023, -0.077}) {
    BodyGroup group = scree::test::group_of("with " + std::to_string(load), shared);
    group.load[0] = {Program::constant, load};
    scene.groups.push_back(group);
  }
  // Bodies that have been far apart in memory are sorted for the second time.
  State mixed = around_sort(scene).after;
  std::vector<std::uint32_t> numbers(scene.bodies.size());
  for (std::size_t place = 0; place < numbers.size(); ++place)
    numbers[place] = std::uint32_t(7 * place % numbers.size());
  const scree::StateArray apart = {numbers, {numbers.size()}, ""};
  mixed.put(order_in_memory, apart);
  scene.bodies = scree::bodies_at_start(mixed);
  Simulation whole(scene, mixed);
  while (whole.state().at(order_in_memory) == apart) {
    REQUIRE(whole.steps() < 500);
    whole.step();
  }
  const State state = whole.state();
  Simulation resumed(scene, state);
  scree::test::run(whole, 5), scree::test::run(resumed, 5);
  check_same(whole.state(), resumed.state());
}
