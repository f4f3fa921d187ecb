#include "over_ranks.hpp"
#include "step/sliding_layers.hpp"

#include <atomic>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/simulation.hpp>

// What fails or is asked for on one rank concerns all.

using scree::Ranks;
using scree::Scene;
using scree::Simulation;
using scree::test::over_ranks;

namespace {

// Bodies at rest, of which the last two meet.
Scene meeting_bodies() {
  std::vector<scree::Body> bodies;
  for (int i = 0; i < 3000; ++i) bodies.push_back(scree::test::body(i, 1, 1, {{3.0 * i, 0, 0}}));
  bodies.back().velocity[0] = -10;
  Scene s = scree::test::scene(3, 1e-2, bodies, {{"normal_stiffness", {1000}}, {"restitution", {1}}});
  s.limits.speed = 100;
  return s;
}

// What a simulation throws within some steps.
std::string failure_of(const Scene& scene, Ranks* ranks) {
  Simulation s(scene, ranks);
  try {
    s.run(200, [] { return true; });
  } catch (const scree::Error& error) {
    // What is there is still read.
    CHECK(s.particles().size() == scene.bodies.size());
    s.contact_list();
    return error.what();
  }
  return "nothing";
}

std::string failure_over(unsigned ranks, const Scene& scene) {
  std::string failure;
  over_ranks(ranks, false, [&](Ranks& all) { failure = failure_of(scene, &all); });
  return failure;
}

}  // namespace

TEST_CASE("an exception of a law on any rank ends the step on all with its text", "[ranks]") {
  scree::PluginHost laws({SCREE_TEST_LAWS});
  Scene scene = meeting_bodies();
  scene.laws = {{"law", scree::Parameters(laws.find("throwing", SCREE_CONTACT_LAW))}};
  scene.laws[0].parameters.set("limit", {0.05});
  const std::string alone = failure_of(scene, nullptr);
  CHECK_THAT(alone, Catch::StartsWith("one of the plug-ins throwing threw an exception (boo) in step 11, "));
  for (const unsigned ranks : {1u, 2u, 3u}) CHECK(failure_over(ranks, scene) == alone);
}

TEST_CASE("a limit that is exceeded on one rank is reported as in one process", "[ranks]") {
  Scene deep = meeting_bodies(), fast = meeting_bodies();
  deep.limits.overlap_ratio = 0.05;
  fast.limits.speed = 10.5;
  scree::test::add_body_force(fast, "gravity", {{"acceleration", {-5, 0, 0}}});
  for (const Scene& scene : {deep, fast}) {
    const std::string alone = failure_of(scene, nullptr);
    CHECK_THAT(alone, Catch::Contains("above the limit"));
    for (const unsigned ranks : {2u, 3u}) CHECK(failure_over(ranks, scene) == alone);
  }
}

TEST_CASE("walls that ranks have moved differently are named", "[ranks]") {
  scree::PluginHost laws({SCREE_TEST_LAWS});
  Scene scene = meeting_bodies();
  scene.boundaries = {{"floor", 0, scree::Parameters(laws.find("wandering", SCREE_BOUNDARY))}};
  CHECK(failure_of(scene, nullptr) == "nothing");
  CHECK_THAT(failure_over(3, scene), Catch::StartsWith("wall floor: is not at the same place on all ranks"));
}

TEST_CASE("a wall that fails on one rank while others ask for loads ends the step on all", "[ranks]") {
  scree::PluginHost laws({SCREE_TEST_LAWS});
  Scene scene = meeting_bodies();
  scene.boundaries = {{"floor", 0, scree::Parameters(laws.find("asking", SCREE_BOUNDARY))}};
  scree::Parameters& asking = scene.boundaries[0].parameters;
  asking.set("fatal_call", {7});
  CHECK_THAT(failure_of(scene, nullptr), Catch::Contains("no more") && Catch::Contains("step 7"));
  for (const int fatal_call : {7, 8, 9}) {
    asking.set("fatal_call", {double(fatal_call)});
    CHECK_THAT(failure_over(3, scene), Catch::Contains("no more") && Catch::Contains("step 3"));
  }
}

TEST_CASE("a rank that is asked to stop has the first rank know after the next step", "[ranks]") {
  const Scene scene = scree::test::sliding_layers(2);
  std::atomic<bool> asked = false;
  scree::test::RankThreads(3).run([&](Ranks& member) {
    if (member.rank() > 0)
      return scree::follow_first_rank(member, scree::test::host(), 1,
                                      [&] { return member.rank() == 2 && asked; });
    const scree::FirstRank leads(&member);
    Simulation s(scene, &member);
    s.step();
    CHECK_FALSE(s.is_interrupted_elsewhere());
    asked = true;
    s.step();
    CHECK(s.is_interrupted_elsewhere());
  });
}

TEST_CASE("ranks follow several simulations one after the other, and one that fails at its start",
          "[ranks]") {
  const Scene scene = meeting_bodies();
  Scene deep = scene;
  deep.bodies[1].position = deep.bodies[0].position;
  std::uint64_t alone = 0;
  {
    Simulation s(scene);
    s.run(30, [] { return true; });
    alone = s.state_hash();
  }
  over_ranks(3, false, [&](Ranks& all) {
    for (int k = 0; k < 2; ++k) {
      CHECK_THROWS_AS(Simulation(deep, &all), scree::Error);
      Simulation s(scene, &all);
      s.run(30, [] { return true; });
      CHECK(s.state_hash() == alone);
    }
  });
}
