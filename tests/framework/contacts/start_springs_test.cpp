#include "scenes.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using scree::test::Values;

namespace {

// Two bodies of mass 1 and radius 1 m that overlap by 1 %, and shear.
Scene sheared_pair(int dimension, const std::string& law, const Values& values) {
  return test::scene(
      dimension, 1e-4,
      {test::body(7, 1, 1, {0, 0, 0}, {}, {}, dimension),
       test::body(3, 1, 1, {1.98, 0.05, 0}, {-0.02, 0.4, dimension == 3 ? 0.2 : 0.0}, {}, dimension)},
      values, law);
}

Scene linear_pair(int dimension) {
  return sheared_pair(dimension, "linear_spring_dashpot",
                      {{"normal_stiffness", {1e4}},
                       {"normal_damping", {0}},
                       {"tangential_stiffness", {3e3}},
                       {"static_friction", {0.5}}});
}

Scene hertz_pair() {
  return sheared_pair(
      3, "hertz_mindlin",
      {{"youngs_modulus", {1e5}}, {"poissons_ratio", {0.3}}, {"restitution", {1}}, {"friction", {0.5}}});
}

Vec3 spring_of(const Simulation& s) {
  const ContactList list = s.contact_list();
  REQUIRE(list.size() == 1);
  Vec3 spring = {};
  for (int k = 0; k < s.dimension(); ++k) spring[k] = s.contact_history(list.pair[0], std::uint32_t(k));
  return spring;
}

Vec3 force_of(const Simulation& s) {
  const ContactList list = s.contact_list();
  return {list.force[0], list.force[1], list.force[2]};
}

// The bodies of a simulation at rest, with a spring between them.
Scene at_rest(Scene scene, const Simulation& s, const Scene::Spring& spring) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    scene.bodies[i].position = test::position(s, i);
    scene.bodies[i].velocity = {};
  }
  scene.springs = {spring};
  return scene;
}

}  // namespace

TEST_CASE("a scene at rest with the spring of a sheared contact has its tangential force", "[springs]") {
  const Scene scene = GENERATE(linear_pair(2), linear_pair(3), hertz_pair());
  Simulation sheared(scene);
  test::run(sheared, 20);
  const Vec3 spring = spring_of(sheared), force = force_of(sheared);
  REQUIRE(norm(spring) > 1e-4);
  // Laws without damping: the force depends on positions and the spring alone. Round-off of the projection.
  const Simulation again(at_rest(scene, sheared, {0, 1, spring}));
  CHECK(norm(force_of(again) - force) <= 1e-12 * norm(force));
  CHECK(norm(spring_of(again) - spring) <= 1e-12 * norm(spring));
  CHECK(again.taken_over() == std::vector<std::string>{"springs of 1 contact"});
  CHECK(again.let_go().empty());
  CHECK(again.energy().elastic_tangential > 0);
  // Named the other way round, the same spring points the other way.
  const Simulation swapped(at_rest(scene, sheared, {1, 0, -1.0 * spring}));
  CHECK(norm(force_of(swapped) - force) <= 1e-12 * norm(force));
}

TEST_CASE("a spring at the start loses its normal component, and what exceeds the limit of friction",
          "[springs]") {
  Scene scene = linear_pair(3);
  for (Body& body : scene.bodies) body.velocity = {};
  scene.springs = {{0, 1, {1e-3, 0, 1e-3}}};
  const Simulation s(scene);
  const Vec3 normal = {s.contact_list().normal[0], s.contact_list().normal[1], s.contact_list().normal[2]};
  CHECK(std::abs(dot(spring_of(s), normal)) < 1e-18);
  CHECK(norm(spring_of(s)) > 1e-3);
  scene.springs[0].displacement = {0, 0, 1};
  const Simulation cut(scene);
  const Vec3 force = force_of(cut);
  const double along = std::abs(dot(force, normal));
  CHECK(norm(force - dot(force, normal) * normal) == Approx(0.5 * along).epsilon(1e-12));
  REQUIRE(cut.let_go().size() == 1);
  CHECK_THAT(cut.let_go()[0], Catch::Contains("friction cuts springs of the file"));
  // Of the energy of the spring the balance has what is left and what was lost.
  CHECK(cut.energy().dissipated_friction + cut.energy().elastic_tangential == Approx(0.5 * 3e3 * 1));
}

TEST_CASE("springs of bodies that are apart, or of a law without springs, are said to be lost", "[springs]") {
  Scene scene = linear_pair(3);
  scene.bodies.push_back(test::body(9, 1, 1, {0, 5, 0}));
  scene.springs = {{0, 2, {1e-3, 0, 0}}, {0, 1, {0, 1e-3, 0}}};
  const Simulation apart(scene);
  CHECK(apart.taken_over() == std::vector<std::string>{"springs of 1 contact"});
  REQUIRE(apart.let_go().size() == 1);
  CHECK_THAT(apart.let_go()[0],
             Catch::StartsWith(
                 "1 spring of the file lost, since the bodies do not touch, are both fixed, or their law "));
  scene.laws[0].parameters = test::parameters("linear_spring_dashpot", SCREE_CONTACT_LAW,
                                              {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}});
  scene.springs.erase(scene.springs.begin());
  const Simulation smooth(scene);
  REQUIRE(smooth.let_go().size() == 1);
  CHECK_THAT(smooth.let_go()[0], Catch::Contains("the law has no such springs"));
}

TEST_CASE("a run that goes on from its state needs no springs of the start", "[springs]") {
  Scene scene = linear_pair(3);
  scene.springs = {{0, 1, {0, 2e-3, 0}}};
  Simulation whole(scene);
  test::run(whole, 5);
  const State state = whole.state();
  test::run(whole, 5);
  scene.springs.clear();
  Simulation resumed(scene, state);
  test::run(resumed, 5);
  CHECK(resumed.state_hash() == whole.state_hash());
}
