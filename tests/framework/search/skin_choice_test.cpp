#include "search/skin_choice.hpp"

#include "contacts/contacts.hpp"
#include "scenes.hpp"

#include <vector>

#include <catch2/catch.hpp>

using scree::Body;
using scree::Scene;
using scree::Simulation;
using scree::SkinChoice;

namespace {

// Bodies of radius 0.5 on a square lattice, `gap` apart, all but the first at rest.
Scene square_lattice(double gap, double speed, double skin = 0) {
  std::vector<Body> bodies;
  for (int i = 0; i < 100; ++i)
    bodies.push_back(scree::test::body(i, 0.5, 1, {{(i % 10) * (1 + gap), (i / 10) * (1 + gap), 0}},
                                       {{i == 0 ? -speed : 0, 0, 0}}));
  Scene s = scree::test::scene(2, 1e-3, bodies, {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
  s.skin = skin;
  return s;
}

std::size_t listed_count(const Simulation& s) {
  std::size_t pairs = 0;
  for (const scree::PairGroup& group : s.contacts().groups()) pairs += group.end - group.begin;
  return pairs;
}

}  // namespace

TEST_CASE("the skin becomes thin where nothing moves, and a given one is kept") {
  // Half of the pairs of neighbours do not touch: 4 % of the diameter apart, within the first skin of 5 %.
  Simulation own(square_lattice(0.04, 0)), stated(square_lattice(0.04, 0, 0.05));
  CHECK(listed_count(own) == 180);
  for (int k = 0; k < 2000; ++k) own.step(), stated.step();
  CHECK(own.skin() < 0.04);
  // The step limit of a later stage does not depend on how thin the skin has become.
  CHECK(own.first_skin() == Approx(0.05));
  CHECK(listed_count(own) == 0);
  CHECK(own.rebuilds() == 2);
  CHECK(stated.skin() == 0.05);
  CHECK(stated.rebuilds() == 1);
}

TEST_CASE("the skin becomes thick where bodies are fast, and the motion is the same for every skin") {
  Simulation own(square_lattice(0.04, 3)), stated(square_lattice(0.04, 3, 0.02));
  for (int k = 0; k < 2000; ++k) own.step(), stated.step();
  CHECK(own.skin() > 0.05);
  CHECK(own.rebuilds() < stated.rebuilds() / 2);
  CHECK(own.state_hash() == stated.state_hash());
}

TEST_CASE("the skin minimises the cost: s² = 2 u C/ρ, within a factor of 2 of the last") {
  // u = 1e-4 a step, C = 15 × 1000 pair evaluations, ρ = 1e5 pairs/m: s = 5.5e-3, a hundredth to five times
  // 0.1.
  const SkinChoice::ListStatistics list = {0.01, 0.01, 100, 2000, 1000, 1000};
  CHECK(SkinChoice(0.1, 0.5).next_skin(list) == Approx(std::sqrt(2 * 1e-4 * 15e3 / 1e5)));
  SkinChoice::ListStatistics slow = list;
  slow.travelled = 0;
  CHECK(SkinChoice(0.1, 0.5).next_skin(slow) == Approx(0.005));
  CHECK(SkinChoice(0.1, 0).fixed());
}
