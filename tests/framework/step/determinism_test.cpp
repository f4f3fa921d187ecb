#include "contacts/contacts.hpp"
#include "instruction_level.hpp"
#include "sanitized.hpp"
#include "scenes.hpp"

#include <memory>
#include <random>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/state_hash.hpp>

using scree::Body;
using scree::PluginHost;
using scree::Scene;
using scree::Simulation;
using scree::Vec3;

namespace {

std::vector<const char*> levels_of_this_processor() {
  std::vector<const char*> levels = {"baseline"};
  if (scree::test::is_supported(3)) levels.push_back("x86-64-v3");
  if (scree::test::is_supported(4)) levels.push_back("x86-64-v4");
  return levels;
}

// Bodies of two sizes that fall into a box and collide: normal, sliding and sticking contacts, walls, a body
// force, several blocks of pairs, several searches.
Scene falling_heap(int dimension, bool frictional) {
  std::mt19937_64 generator(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const int per_axis = dimension == 2 ? 20 : 8;
  std::vector<Body> bodies;
  for (int i = 0; i < (dimension == 2 ? 400 : 512); ++i) {
    Vec3 x = {}, v = {};
    for (int k = 0, rest = i; k < dimension; ++k, rest /= per_axis) {
      x[k] = 1.9 * (rest % per_axis) + 0.05 * uniform(generator);
      v[k] = 3 * uniform(generator);
    }
    const double radius = i % 2 ? 1 : 0.8;
    bodies.push_back(scree::test::body(i, radius, radius, x, v, {}, dimension));
  }
  Scene s = scree::test::scene(dimension, 1e-3, bodies,
                               {{"normal_stiffness", {1e4}},
                                {"restitution", {0.8}},
                                {"tension", {1}},
                                {"tangential_stiffness", {3e3}},
                                {"tangential_damping", {1}},
                                {"static_friction", {frictional ? 0.3 : 0.0}}});
  scree::test::add_boundary(s, "box",
                            {{"stress", {0, 30}}, {"mass", {1000}}, {"viscosity", {10}}, {"x_low", {1}}});
  scree::test::add_body_force(s, "gravity", {{"acceleration", {0, -10, 0}}});
  return s;
}

std::uint64_t hash_after(const Scene& scene, int steps) {
  Simulation s(scene);
  scree::test::run(s, std::uint64_t(steps));
  // The scene covers the cases: more than one block of contacts, and several searches.
  REQUIRE(s.contact_list().size() > 256);
  REQUIRE(s.rebuilds() > 3);
  return s.state_hash();
}

void flip_lowest_bit(double& x) {
  x = __builtin_bit_cast(double, __builtin_bit_cast(std::uint64_t, x) ^ std::uint64_t(1));
}

}  // namespace

TEST_CASE("the same scene gives the same bits twice") {
  for (const int dimension : {2, 3})
    CHECK(hash_after(falling_heap(dimension, true), 200) == hash_after(falling_heap(dimension, true), 200));
}

TEST_CASE("any number of threads gives the same bits", "[threads]") {
  const int dimension = GENERATE(2, 3);
  const bool frictional = GENERATE(false, true);
  Scene scene = falling_heap(dimension, frictional);
  const std::uint64_t alone = hash_after(scene, 120);
  for (const unsigned threads : {2u, 3u, 4u}) {
    scene.threads = threads;
    scene.min_bodies_per_thread = 1;
    INFO(threads << " threads");
    CHECK(hash_after(scene, 120) == alone);
  }
}

TEST_CASE("energies and momentum errors have the same bits for any number of threads", "[threads]") {
  Scene scene = falling_heap(3, true);
  std::set<std::uint64_t> hashes;
  for (const unsigned threads : {1u, 2u, 3u, 4u}) {
    scene.threads = threads;
    scene.min_bodies_per_thread = 1;
    Simulation s(scene);
    scree::test::run(s, 100);
    scree::StateHash hash;
    const scree_energy e = s.energy();
    for (const double x :
         {e.elastic_normal, e.elastic_tangential, e.dissipated_normal, e.dissipated_tangential,
          e.dissipated_friction, e.residual, s.momentum_residual(), s.max_overlap_ratio()})
      hash.add(x);
    CHECK(e.dissipated_friction > 0);
    hashes.insert(hash.value());
  }
  CHECK(hashes.size() == 1);
}

TEST_CASE("every build of the law gives the same bits") {
  const int dimension = GENERATE(2, 3);
  const bool frictional = GENERATE(false, true);
  std::set<std::uint64_t> hashes;
  std::set<const scree_plugin*> builds;
  // All hosts are kept, so that no build is loaded at the address of another.
  std::vector<std::unique_ptr<PluginHost>> hosts;
  for (const char* name : levels_of_this_processor()) {
    const scree::test::InstructionLevel level(name);
    hosts.push_back(std::make_unique<PluginHost>(std::vector<std::filesystem::path>{SCREE_TEST_PLUGINS}));
    Scene scene = falling_heap(dimension, frictional);
    scree::Parameters law(hosts.back()->find("linear_spring_dashpot", SCREE_CONTACT_LAW));
    for (const auto& [key, value] : scree::test::Values{{"normal_stiffness", {1e4}},
                                                        {"normal_damping", {5}},
                                                        {"tangential_stiffness", {3e3}},
                                                        {"tangential_damping", {1}},
                                                        {"static_friction", {frictional ? 0.3 : 0.0}}})
      law.set(key, value);
    scene.laws[0].parameters = law;
    hashes.insert(hash_after(scene, 120));
    builds.insert(&law.plugin());
  }
  CHECK(hashes.size() == 1);
  CHECK(builds.size() == levels_of_this_processor().size());  // the libraries differ
}

TEST_CASE("fused steps have the same bits as single steps") {
  const int dimension = GENERATE(2, 3);
  const int steps = scree::test::fewer_if_sanitized(300), first = 2 * steps / 5;
  for (const scree::IntegrationTraits& traits : scree::integrations()) {
    CAPTURE(dimension, traits.name);
    Scene scene = falling_heap(dimension, true);
    scene.integration = traits.integration;
    scene.step = 2e-4;
    Simulation one_by_one(scene), together(scene), stopped(scene);
    scree::test::run(one_by_one, steps);
    CHECK(together.run(first, [] { return true; }) == first);
    CHECK(together.run(steps - first, [] { return true; }) == steps - first);
    CHECK(together.state_hash() == one_by_one.state_hash());
    CHECK(together.energy().residual == one_by_one.energy().residual);
    CHECK(together.momentum_residual() == one_by_one.momentum_residual());
    // If `proceed` returns false, the step is completed.
    int polls = 0;
    CHECK(stopped.run(1000, [&] { return ++polls < steps; }) == steps);
    CHECK(stopped.state_hash() == one_by_one.state_hash());
  }
}

TEST_CASE("the last bit of any state changes the hash") {
  const int dimension = GENERATE(2, 3);
  Simulation s(falling_heap(dimension, true));
  scree::test::run(s, 100);
  const std::uint64_t hash = s.state_hash();
  // The simulation itself is not const; only its accessor is.
  auto& particles = const_cast<scree::Particles&>(s.particles());
  auto& contacts = const_cast<scree::Contacts&>(s.contacts());
  auto& planes = const_cast<std::vector<scree_plane>&>(s.planes());

  std::size_t tried = 0;
  const auto check = [&](double& x) {
    const double before = x;
    flip_lowest_bit(x);
    REQUIRE(s.state_hash() != hash);
    x = before;
    ++tried;
  };
  for (const auto& vectors : {particles.position(), particles.velocity(), particles.spin()})
    for (int k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < vectors[k].size(); i += 37) check(vectors[k][i]);
  for (scree::PairGroup& group : contacts.groups())
    for (std::size_t i = 0; i < group.end - group.begin; i += 29)
      for (std::uint32_t k = 0; k < group.history_width; ++k) check(group.history.column(k)[i]);
  for (scree_plane& plane : planes)
    for (int k = 0; k < 3; ++k) check(plane.point[k]), check(plane.velocity[k]);
  REQUIRE(s.state_hash() == hash);
  CHECK(tried > 100);

  s.step();
  CHECK(s.state_hash() != hash);
}

TEST_CASE("the hash distinguishes which spring of a contact is stretched") {
  Simulation s(falling_heap(3, true));
  scree::test::run(s, 100);
  auto& contacts = const_cast<scree::Contacts&>(s.contacts());
  for (scree::PairGroup& group : contacts.groups())
    for (std::size_t i = 0; i < group.end - group.begin; ++i) {
      double &x = group.history.column(0)[i], &y = group.history.column(1)[i];
      if (x == 0) continue;
      x = 1, y = 0;
      const std::uint64_t along_x = s.state_hash();
      std::swap(x, y);
      REQUIRE(s.state_hash() != along_x);
    }
}

TEST_CASE("hashes distinguish order, sign of zero and length") {
  const auto hash = [](const std::vector<double>& data) {
    scree::StateHash h;
    h.add(data.data(), data.size());
    return h.value();
  };
  const std::set<std::uint64_t> all = {hash({}),     hash({0.0}),  hash({-0.0}),     hash({0.0, 0.0}),
                                       hash({1, 2}), hash({2, 1}), hash({1, 2, 0.0})};
  CHECK(all.size() == 7);
}
