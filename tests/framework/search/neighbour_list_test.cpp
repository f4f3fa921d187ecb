#include "contacts/contacts.hpp"
#include "numbers.hpp"
#include "scenes.hpp"

#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

using scree::Body;
using scree::Scene;
using scree::Simulation;
using scree::Vec3;
using scree::test::epsilon;
using scree::test::Values;

namespace {

constexpr double gas_edge = 10, gas_step = 1e-3;

enum Walls { box, periodic };

// A dilute gas of fast bodies of two sizes: the fastest move by a hundredth of a radius per step.
Scene gas(int dimension, Walls walls, double skin, double perturbation = 0) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Body> bodies;
  const int per_axis = dimension == 2 ? 7 : 4;
  for (int i = 0; i < std::pow(per_axis, dimension); ++i) {
    Vec3 x = {}, v = {};
    for (int k = 0, rest = i; k < dimension; ++k, rest /= per_axis) {
      x[k] = (rest % per_axis + 0.5) * gas_edge / per_axis + perturbation * uniform(generator);
      v[k] = 10 * uniform(generator);
    }
    const double radius = i % 3 ? 0.3 : 0.6;
    bodies.push_back(scree::test::body(i, radius, radius, x, v));
  }
  Scene s =
      scree::test::scene(dimension, gas_step, bodies, {{"normal_stiffness", {2e4}}, {"normal_damping", {0}}});
  s.skin = skin;
  if (walls == box) {
    Values values = {{"lower", {0, 0, 0}}, {"upper", {gas_edge, gas_edge, gas_edge}}};
    for (const char* wall : {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"})
      values.push_back({wall, {1}});
    scree::test::add_boundary(s, "box", values);
  } else {
    scree::test::add_boundary(s, "periodic",
                              {{"axes", {dimension == 2 ? 3.0 : 6.0}},
                               {"lower", {0, 0, 0}},
                               {"upper", {gas_edge, gas_edge, gas_edge}}});
  }
  return s;
}

double nearest_image(double x) { return x - gas_edge * std::round(x / gas_edge); }

using IndexPairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// Overlapping bodies, or bodies and walls, by brute force.
IndexPairs overlapping(const Simulation& s, bool planes) {
  IndexPairs pairs;
  const bool wraps = s.domain().any_periodic();
  const std::size_t n = s.particles().size();
  for (std::uint32_t a = 0; a < n; ++a) {
    const Body body = s.particles().body(a);
    for (std::uint32_t b = 0; planes && b < s.planes().size(); ++b) {
      const scree_plane& plane = s.planes()[b];
      double height = 0;
      for (int k = 0; k < 3; ++k) height += (body.position[k] - plane.point[k]) * plane.normal[k];
      if (height < body.radius) pairs.insert({a, b});
    }
    for (std::uint32_t b = a + 1; !planes && b < n; ++b) {
      const Body other = s.particles().body(b);
      Vec3 d = body.position - other.position;
      for (int k = 0; wraps && k < s.dimension(); ++k) d[k] = nearest_image(d[k]);
      if (norm(d) < body.radius + other.radius) pairs.insert({a, b});
    }
  }
  return pairs;
}

IndexPairs listed_pairs(const Simulation& s, bool planes) {
  IndexPairs pairs;
  for (const scree::PairGroup& group : s.contacts().groups())
    for (std::size_t p = group.begin; p < group.end && group.planes == planes; ++p)
      pairs.insert({s.contacts().a[p], s.contacts().b[p]});
  return pairs;
}

// Takes steps and counts overlaps; fails if one is not listed.
std::size_t watch(Simulation& s, int steps) {
  std::size_t overlaps = 0;
  for (int k = 0; k < steps; ++k) {
    s.step();
    for (const bool planes : {false, true}) {
      const IndexPairs present = listed_pairs(s, planes);
      for (const auto& pair : overlapping(s, planes)) {
        ++overlaps;
        INFO("pair " << pair.first << ", " << pair.second << " at step " << s.steps());
        REQUIRE(present.count(pair) == 1);
      }
    }
  }
  return overlaps;
}

// Largest distance between the same bodies of two gases, with the minimum-image convention.
double distance(const Simulation& s, const Simulation& t) {
  double largest = 0;
  for (std::size_t i = 0; i < s.particles().size(); ++i) {
    Vec3 d = scree::test::position(s, i) - scree::test::position(t, i);
    for (int k = 0; k < s.dimension(); ++k) d[k] = nearest_image(d[k]);
    largest = std::max(largest, norm(d));
  }
  return largest;
}

const double* history_of(const Simulation& s, std::uint32_t a, std::uint32_t b, bool planes,
                         std::uint32_t column) {
  for (const scree::PairGroup& group : s.contacts().groups())
    for (std::size_t p = group.begin; p < group.end && group.planes == planes; ++p)
      if (s.contacts().a[p] == a && s.contacts().b[p] == b)
        return group.history.column(column) + (p - group.begin);
  return nullptr;
}

}  // namespace

TEST_CASE("no contact of a fast gas is missed") {
  const int dimension = GENERATE(2, 3);
  const Walls walls = GENERATE(box, periodic);
  const double skin = GENERATE(0.003, 0.05, 0.5, 3.0);
  CAPTURE(dimension, walls, skin);
  // The longest reach, 1.2 + skin, must fit twice into the periodic length: it does up to 3.8.
  Simulation s(gas(dimension, walls, skin));
  CHECK(watch(s, 800) > 200);
  // The bound on displacements is used: rare searches with a wide skin, one nearly every step with the
  // narrowest.
  if (skin > 2) CHECK(s.rebuilds() < 20);
  if (skin < 0.01) CHECK(s.rebuilds() > 600);
}

TEST_CASE("a fast wall misses no body at rest") {
  for (const double skin : {0.003, 0.05, 0.5, 3.0}) {
    Scene scene = gas(3, box, skin);
    for (Body& body : scene.bodies) body.velocity = {};
    // Starts 0.2 m below the lowest surface and goes 0.3 m further, all within 20 steps.
    scree::test::add_boundary(
        scene, "plane",
        {{"point", {0, 0, 0.45}}, {"normal", {0, 0, 1}}, {"displacement", {3, 0, 0.5, 0.02}}});
    Simulation s(scene);
    CHECK(watch(s, 20) > 20);
  }
}

TEST_CASE("contacts with walls give the same bits for any skin") {
  // A listed pair that does not touch adds an exact zero, so that without images no rounding depends on the
  // skin.
  for (const int dimension : {2, 3}) {
    std::set<std::uint64_t> hashes;
    for (const double skin : {0.003, 0.05, 0.5, 3.0}) {
      Simulation s(gas(dimension, box, skin));
      scree::test::run(s, 600);
      hashes.insert(s.state_hash());
    }
    CHECK(hashes.size() == 1);
  }
}

TEST_CASE("periodic motion is the same for any skin, to round-off") {
  for (const int dimension : {2, 3}) {
    // Searches happen at other times and round positions when folding them, by half an ulp of the edge.
    // Collisions amplify differences; the factor is measured with a displacement far above round-off.
    const int steps = 300;
    const double displacement = 1e-10;
    Simulation reference(gas(dimension, periodic, 0.05)),
        displaced(gas(dimension, periodic, 0.05, displacement));
    scree::test::run(reference, steps);
    scree::test::run(displaced, steps);
    const double growth = distance(reference, displaced) / displacement;
    REQUIRE(growth < 1e5);  // otherwise the comparison would be meaningless
    for (const double skin : {0.003, 0.5, 3.0}) {
      Simulation s(gas(dimension, periodic, skin));
      scree::test::run(s, steps);
      REQUIRE(s.rebuilds() != reference.rebuilds());
      // One rounding per step, amplified at most like one at the start; the displacement samples one
      // direction only, hence the factor of 10.
      CHECK(distance(s, reference) <= 10 * growth * steps * epsilon * gas_edge);
    }
  }
}

TEST_CASE("loaded springs survive searches caused by a distant body") {
  // Two discs on the ground with a third on top stand by friction alone: all springs are stretched.
  const double radius = 0.5, mass = 1, stiffness = 1e4, gravity = 1, spread = 1.2 * radius;
  const auto pile = [&](double skin) {
    std::vector<Body> bodies = {
        scree::test::body(0, radius, mass, {{-spread, radius, 0}}, {}, {}, 2),
        scree::test::body(1, radius, mass, {{spread, radius, 0}}, {}, {}, 2),
        scree::test::body(2, radius, mass, {{0, radius + 1.6 * radius, 0}}, {}, {}, 2),
        scree::test::body(3, radius, mass, {{1e3, 1e3, 0}}, {{20, 0, 0}}, {}, 2)};
    Scene s = scree::test::scene(2, 2e-3, bodies,
                                 {{"normal_stiffness", {stiffness}},
                                  {"normal_damping", {100}},
                                  {"tangential_stiffness", {stiffness}},
                                  {"tangential_damping", {30}},
                                  {"static_friction", {1}}});
    s.skin = skin;
    scree::test::add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
    scree::test::add_body_force(s, "gravity", {{"acceleration", {0, -gravity, 0}}});
    return s;
  };
  const struct {
    std::uint32_t a, b;
    bool planes;
  } contacts[] = {{0, 2, false}, {1, 2, false}, {0, 0, true}, {1, 0, true}};

  Simulation rarely(pile(50)), often(pile(1e-3));
  const int settle = 10000;
  scree::test::run(rarely, settle);
  scree::test::run(often, settle);
  REQUIRE(often.rebuilds() > std::uint64_t(settle / 2));
  REQUIRE(rarely.rebuilds() < std::uint64_t(settle / 10));

  std::vector<double> springs;
  for (const auto& c : contacts)
    for (std::uint32_t k = 0; k < 2; ++k) {
      // Same bits: a search changes no spring.
      REQUIRE(history_of(often, c.a, c.b, c.planes, k));
      springs.push_back(*history_of(often, c.a, c.b, c.planes, k));
      CHECK(springs.back() == *history_of(rarely, c.a, c.b, c.planes, k));
    }
  // A force at each end keeps a disc in balance only along the line between them, which leans by half the
  // angle sin θ = 0.6 of the upper contact: the ground gives tan(θ/2) = 1/3 of the half weight that comes
  // from above. The overlaps turn that line a little, by about overlap/radius < 1e-3.
  CHECK(std::abs(springs[4]) * stiffness == Approx(mass * gravity / 6).epsilon(1e-3));

  // There is no creep: after hundreds of relaxation times the displacement of a step is under half an ulp of
  // all.
  scree::test::run(often, 2000);
  std::size_t next = 0;
  for (const auto& c : contacts)
    for (std::uint32_t k = 0; k < 2; ++k) CHECK(*history_of(often, c.a, c.b, c.planes, k) == springs[next++]);
}
