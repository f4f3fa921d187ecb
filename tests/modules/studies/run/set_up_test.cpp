#include "run_support.hpp"

#include <cstdlib>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/run/warnings.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

// Discs that touch each other and a box whose walls a stage may move, and move about under gravity.
const std::string sliding =
    with(with(with(with(discs, "duration = 1e-4\n", "expected_speed = 1\n"), "gap = 0.1", "gap = 0.0"),
              "gap = 0.005", "gap = 0"),
         "normal_damping = 0\n",
         "normal_damping = 0.5\ntangential_stiffness = 5e3\nstatic_friction = 0.4\n") +
    "[[body_force]]\nplugin = 'gravity'\nacceleration = [1, -10]\n";
const std::string touching_lattice =
    "lattice = { kind = 'square', count = [3, 3], gap = 0.0 }\nradius = 0.01\nrandom_velocity = 0.1\n";
const std::string preparation = "[[stage]]\nduration = 6e-3\n";

// The scene that begins from the state at the end of a run.
std::string from_state(const Bench& prepared) {
  ::setenv("SCREE_STATE_PATH", prepared.options.out.c_str(), 1);
  return with(sliding, touching_lattice,
              "state = '" + (prepared.options.out / "final_state.h5").string() + "'\n");
}

// The results of a run as they are written.
std::string results_of(const Bench& bench) {
  bench.run();
  return text_of(bench.options.out / "series/energy.csv") + text_of(bench.options.out / "final_packing.csv");
}

}  // namespace

TEST_CASE("a stage that makes contacts too stiff for the time step is refused before the run starts",
          "[run]") {
  const Bench bench(with(discs, "duration = 1e-4\n", "") +
                    "[[stage]]\nname = 'soft'\nduration = 1e-4\n[[stage]]\nname = 'stiff'\n"
                    "duration = 1e-4\nset.linear_spring_dashpot.normal_stiffness = 1e14\n");
  try {
    bench.run();
    FAIL("the step is too long");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::bad_input);
    CHECK(std::string(error.what())
              .find("scene.toml:4:8: in stage 'stiff' the time step of 1e-05 s is too long: ") !=
          std::string::npos);
    CHECK_FALSE(fs::exists(bench.options.out));
  }
}

TEST_CASE("errors of the scene as a whole have a position in the file too", "[run]") {
  const std::string head =
      with(discs,
           "[particles]\nlattice = { kind = 'square', count = [3, 3], gap = 0.1 }\n"
           "radius = 0.01\nrandom_velocity = 0.1\n",
           "[[particle]]\nradius = 0.01\nposition = [0, 0]\n[[particle]]\nradius = 0.01\n"
           "position = [0.001, 0]\n");
  const auto reason = [](const Plan& plan) { return message([&] { set_up(plan); }); };
  const auto overlap = reason(plan_of(head));
  CHECK(overlap.find(
            "scene.toml:13:1: contact of particle 1 with particle 2: overlap is 1.9 of the smaller radius") !=
        std::string::npos);
  const Plan narrow =
      plan_of(with(head,
                   "plugin = 'box'\nx_low = 'fixed'\nx_high = 'fixed'\ny_low = 'fixed'\n"
                   "y_high = 'fixed'\ngap = 0.005\n",
                   "plugin = 'periodic'\naxes = 'x'\nlower = [-0.015, 0]\nupper = [0.015, 0]\n"));
  CHECK(reason(narrow).find("scene.toml:20:10: the periodic length 0.03 m along x is under twice ") !=
        std::string::npos);
  const Plan no_walls = plan_of(with(discs,
                                     "plugin = 'box'\nx_low = 'fixed'\nx_high = 'fixed'\ny_low = 'fixed'\n"
                                     "y_high = 'fixed'\ngap = 0.005\n",
                                     "plugin = 'plane'\npoint = [0, -1]\nnormal = [0, 1]\n"),
                                {"probe={plugin='box',every=1e-5}"});
  CHECK(reason(no_walls).starts_with(
      "--set probe={plugin='box',every=1e-5}: probe box: the box probe needs walls"));
}

TEST_CASE("what the first stage sets holds from the start, as if the scene had it", "[run]") {
  const std::string stage = "[[stage]]\nname = 'on'\nduration = 4e-4\n";
  // What the first stage sets, and the same in the scene.
  const auto [set, place, given] = GENERATE(table<const char*, const char*, const char*>(
      {{"set.linear_spring_dashpot.static_friction = 0.8\n", "static_friction = 0.4\n",
        "static_friction = 0.8\n"},
       {"set.linear_spring_dashpot.static_friction = 0.02\n", "static_friction = 0.4\n",
        "static_friction = 0.02\n"},
       {"set.linear_spring_dashpot.normal_stiffness = 2e4\n", "normal_stiffness = 1e4\n",
        "normal_stiffness = 2e4\n"},
       {"set.linear_spring_dashpot.normal_damping = 2\n", "normal_damping = 0.5\n", "normal_damping = 2\n"},
       {"set.gravity.acceleration = [0, 0]\n", "acceleration = [1, -10]\n", "acceleration = [0, 0]\n"},
       {"set.box = { y_high = 'velocity', velocity_y_high = 3 }\n", "y_high = 'fixed'\n",
        "y_high = 'velocity'\nvelocity_y_high = 3\n"},
       {"set.box = { y_high = 'stress', stress = 500 }\n", "y_high = 'fixed'\n",
        "y_high = 'stress'\nstress = 500\n"}}));
  INFO(set);
  const bool new_packing = GENERATE(true, false);
  const Bench prepared(sliding + preparation);
  if (!new_packing) prepared.run();
  const std::string begin = new_packing ? sliding : from_state(prepared);
  const Bench by_stage(begin + stage + set), by_scene(with(begin, place, given) + stage);
  CHECK(results_of(by_stage) == results_of(by_scene));
  ::unsetenv("SCREE_STATE_PATH");
}

TEST_CASE("springs of a state outlive a friction of the scene that the first stage replaces", "[run]") {
  const Bench prepared(sliding + preparation);
  prepared.run();
  const std::string begin = with(from_state(prepared), "static_friction = 0.4\n", "static_friction = 0.01\n");
  const auto simulation_of = [&](const std::string& stage) { return set_up(plan_of(begin + stage)); };
  const auto kept =
      simulation_of("[[stage]]\nduration = 1e-4\nset.linear_spring_dashpot.static_friction = 0.4\n");
  CHECK(kept->energy().elastic_tangential > 0);
  CHECK(kept->let_go().empty());
  const auto cut = simulation_of("[[stage]]\nduration = 1e-4\n");
  CHECK(cut->energy().elastic_tangential < 0.1 * kept->energy().elastic_tangential);
  REQUIRE(cut->let_go().size() == 1);
  CHECK(start_warnings(plan_of(begin + "[[stage]]\nduration = 1e-4\n"), *cut).back() == cut->let_go()[0]);
  ::unsetenv("SCREE_STATE_PATH");
}
