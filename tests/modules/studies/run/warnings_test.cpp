#include "run_support.hpp"

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/run/warnings.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;

namespace {

// Parts of the scene discs that tests replace.
const std::string box =
    "plugin = 'box'\nx_low = 'fixed'\nx_high = 'fixed'\ny_low = 'fixed'\ny_high = 'fixed'\ngap = 0.005\n";
const std::string lattice =
    "[particles]\nlattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
    "random_velocity = 0.1\n";

}  // namespace

TEST_CASE("warnings are told and kept in run.json", "[run]") {
  // 1e8 N/m: π √(m*/k) = 1.2e-4 s, 12 steps in a contact; the discs overlap by a tenth of their radius.
  Bench bench(with(discs, lattice,
                   "[[particle]]\nradius = 0.01\nposition = [0, 0]\n[[particle]]\nradius = 0.01\n"
                   "position = [0.019, 0]\n"),
              {"contact.normal_stiffness=1e8"});
  std::vector<std::string> told;
  bench.options.on_warning = [&](const std::string& line) { told.push_back(line); };
  const RunResult result = bench.run();
  CHECK(result.warnings == told);
  REQUIRE(told.size() >= 2);
  CHECK(told[0].starts_with("the shortest contact takes 12"));
  CHECK(told[0].find("; use 20 or more") != std::string::npos);
  CHECK(told[1].find(" overlap by 0.1 of the smaller radius at t = 0") != std::string::npos);
  CHECK(text_of(bench.options.out / "run.json").find(told[1]) != std::string::npos);
  // Bodies of a state bear a load.
  const auto simulation = set_up(bench.plan);
  CHECK(start_warnings(bench.plan, *simulation)[1] == told[1]);
  bench.plan.from_state = std::make_shared<State>();
  CHECK(start_warnings(bench.plan, *simulation) == std::vector<std::string>{told[0]});
}

TEST_CASE("bodies that overlap through a periodic face are found at the start", "[run]") {
  // Two discs of 0.01 m whose images are 0.0154 m apart: 0.46 R.
  const std::string periodic = with(
      with(discs, box, "plugin = 'periodic'\naxes = 'x'\nlower = [0, 0]\nupper = [0.0854, 0]\n"), lattice,
      "[[particle]]\nradius = 0.01\nposition = [0.0077, 0]\n[[particle]]\nradius = 0.01\n"
      "position = [0.0777, 0]\n");
  const LargestOverlap largest = largest_overlap(*set_up(plan_of(periodic)));
  CHECK(largest.ratio == Approx(0.46));
  CHECK((largest.bodies == "particle 1 and particle 2" || largest.bodies == "particle 2 and particle 1"));
}

TEST_CASE("the final packing of a periodic run has its box, and a scene that drops it is warned", "[run]") {
  const std::string periodic =
      with(discs, box, "plugin = 'periodic'\naxes = 'x'\nlower = [0, 0]\nupper = [0.07, 0]\n");
  const Bench bench(periodic);
  bench.run();
  const std::string packing = text_of(bench.options.out / "final_packing.csv");
  CHECK(packing.find("# lower [m]: 0 ") != std::string::npos);
  CHECK(packing.find("# upper [m]: 0.07 ") != std::string::npos);
  CHECK(packing.find("# periodic: x\n") != std::string::npos);
  const auto again = [&](const std::string& text) {
    return plan_of(with(text,
                        "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                        "random_velocity = 0.1\n",
                        "file = '" + (bench.options.out / "final_packing.csv").string() + "'\n"))
        .warnings;
  };
  CHECK(again(periodic).empty());
  const std::vector<std::string> dropped = again(discs);
  REQUIRE(dropped.size() == 1);
  CHECK(dropped[0].starts_with(
      "the file of bodies is periodic along x from 0 to 0.07 m, and the scene is not; "));
  CHECK(again(with(periodic, "upper = [0.07, 0]", "upper = [0.14, 0]"))[0].find("over 0.14 m") !=
        std::string::npos);
}

TEST_CASE("a scene that drops several periodic axes is warned once", "[run]") {
  const std::string periodic =
      with(discs, box, "plugin = 'periodic'\naxes = 'xy'\nlower = [0, 0]\nupper = [0.07, 0.08]\n");
  const Bench bench(periodic);
  bench.run();
  const auto again = [&](const std::string& text) {
    return plan_of(with(text,
                        "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                        "random_velocity = 0.1\n",
                        "file = '" + (bench.options.out / "final_packing.csv").string() + "'\n"))
        .warnings;
  };
  REQUIRE(again(discs).size() == 1);
  CHECK(again(discs)[0].starts_with(
      "the file of bodies is periodic along x from 0 to 0.07 m, y from 0 to 0.08 m, and the "
      "scene is not; "));
  const std::string one = with(periodic, "axes = 'xy'\nlower = [0, 0]\nupper = [0.07, 0.08]",
                               "axes = 'x'\nlower = [0, 0]\nupper = [0.14, 0]");
  REQUIRE(again(one).size() == 1);
  CHECK(again(one)[0].find("and the scene is along x over 0.14 m, not along y; ") != std::string::npos);
}

TEST_CASE("the number of steps in a contact is warned of below 20, and tells that from 20", "[run]") {
  const auto warnings = [](const std::string& fraction) {
    const Bench bench(discs, {"time.step={fraction=" + fraction + "}", "time.duration=1", "probe.every=0.1"});
    return run::start_warnings(bench.plan, *run::set_up(bench.plan));
  };
  // In these scenes contact time / (fraction × contact time) is below the bound by rounding, or not.
  for (const char* stiffness : {"1e3", "3e3", "7e3", "1.1e4", "1.3e4", "1.7e4", "4e4"}) {
    const Bench bench(discs, {"time.step={fraction=0.05}", "time.duration=1", "probe.every=0.1",
                              std::string("contact.normal_stiffness=") + stiffness});
    CHECK(run::start_warnings(bench.plan, *run::set_up(bench.plan)).empty());
  }
  REQUIRE(warnings("0.0500001").size() == 1);
  CHECK(
      warnings("0.0500001")[0].starts_with("the shortest contact takes 19.99996 time steps; use 20 or more"));
  REQUIRE(warnings("0.06").size() == 1);
  CHECK(warnings("0.06")[0].starts_with("the shortest contact takes 16.7 time steps; use 20 or more"));
}

TEST_CASE("fourth_order is warned of where friction or dashpots make it lose its order", "[run]") {
  const auto warnings = [](const std::vector<std::string>& overrides) {
    const Bench bench(discs, overrides);
    return start_warnings(bench.plan, *set_up(bench.plan));
  };
  const std::string integrator = "time.integrator=fourth_order";
  CHECK(warnings({integrator}).empty());
  CHECK(warnings({"contact.normal_damping=1"}).empty());
  for (const std::vector<std::string>& lossy :
       {std::vector<std::string>{integrator, "contact.normal_damping=1"},
        {integrator, "contact.tangential_stiffness=1e3", "contact.static_friction=0.3"}}) {
    const std::vector<std::string> told = warnings(lossy);
    REQUIRE(told.size() == 1);
    CHECK(told[0].starts_with("time.integrator = \"fourth_order\" "));
    CHECK(told[0].find("first order with dashpots") != std::string::npos);
  }
}

TEST_CASE("grazing impacts of springs with a potential are warned of with the steps that they need",
          "[run]") {
  const std::string hertz = with(with(discs, "linear_spring_dashpot", "hertz_mindlin"),
                                 "normal_stiffness = 1e4\nnormal_damping = 0\n",
                                 "youngs_modulus = 2e10\npoissons_ratio = 0.3\nrestitution = 0.5\n"
                                 "tension = 'cut'\nfriction = 0.5\nhistory = 'potential'\n");
  const auto warnings = [&](const std::vector<std::string>& overrides) {
    const Bench bench(hertz, overrides);
    return start_warnings(bench.plan, *set_up(bench.plan));
  };
  const std::vector<std::string> told = warnings({});
  REQUIRE(told.size() == 1);
  // β = 0.2553 of e = 0.5 without tension; E*/G* = 2 (2 − ν)/(1 − ν) = 4.857:
  // 4 (tan 80°/(0.0865 · 4.857 · 0.5 · 0.2553))^0.8.
  CHECK(told[0].find("impacts at 80 degrees from the normal need 167 with") != std::string::npos);
  CHECK(warnings({"contact.history=rescaled"}).empty());
  CHECK(warnings({"contact.restitution=1"}).empty());
  CHECK(warnings({"contact.friction=0.05"}).empty());  // a share of the impulse of 2e-4
  CHECK(warnings({"time.step=1e-6"}).empty());
}
