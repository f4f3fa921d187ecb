#include "plan_support.hpp"

#include <catch2/catch.hpp>

#include <scree/integration.hpp>
#include <scree/run/run.hpp>
#include <scree/run/run_in_memory.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;

namespace {

// Times in the energy series of a run.
std::vector<double> sampled_times(const std::string& text, const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  const Plan plan = plan_of(text, overrides);
  RunOptions options;
  options.out = folder / "out";
  run_plan(plan, options);
  std::ifstream file(folder / "out" / "series" / "energy.csv");
  std::string line;
  std::getline(file, line);
  std::vector<double> times;
  while (std::getline(file, line)) times.push_back(std::stod(line));
  return times;
}

// A probe that observes, in the scene `discs`, whose bodies fly freely for its ten steps of 1e-5 s: the squared
// displacement over windows is exact.
const std::string observing = std::string(discs) +
                              "[[probe]]\nname = 'msd'\nplugin = 'mean_squared_displacement'\n"
                              "window = 2e-5\nevery = 2e-5\n"
                              "[[expect]]\nrequirement = 'a'\nquantity = 'msd.total.last'\nat_least = 0\n";

struct Observed {
  std::uint64_t state_hash;
  double last;
};

Observed observed(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const TemporaryFolder folder;
  const Plan plan = plan_of(text, overrides);
  RunOptions options;
  options.out = folder / "out";
  const RunResult result = run_plan(plan, options);
  return {result.state_hash, result.verdicts[0].value};
}

// Mean of |v|² over the bodies (m²/s²).
double mean_square_speed() {
  const Plan plan = plan_of(discs);
  double sum = 0;
  for (const Body& b : plan.scene.bodies) sum += dot(b.velocity, b.velocity);
  return sum / double(plan.scene.bodies.size());
}

// A displacement of 1e-6 m is the difference of positions of up to 0.06 m, rounded in each step.
constexpr double rounding = 10 * 0.06 * 2.2e-16 / 1e-6 * 2;

}  // namespace

TEST_CASE("samples are taken at the step nearest to each multiple, and at the end", "[run]") {
  // 2.4 steps between samples: at steps 0, 2, 5, 7, 10; a rounded interval of 2 would drift.
  const std::vector<double> times = sampled_times(discs, {"probe.every=2.4e-5"});
  const std::vector<int> steps = {0, 2, 5, 7, 10};
  REQUIRE(times.size() == steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) CHECK(times[k] == Approx(steps[k] * 1e-5).epsilon(1e-12));
}

TEST_CASE("a run ends with a sample even if none is due", "[run]") {
  const std::vector<double> times = sampled_times(discs, {"probe.every=7e-5"});
  REQUIRE(times.size() == 3);
  CHECK(times.back() == Approx(1e-4));
}

TEST_CASE("what a probe observes does not depend on its samples, pictures or the way it is run", "[run]") {
  // Windows of three steps end between the samples.
  const std::string text = with(observing, "window = 2e-5", "window = 3e-5");
  const Observed reference = observed(text);
  CHECK(reference.last == Approx(mean_square_speed() * 9e-10).epsilon(rounding));
  std::vector<std::string> others = {"probe.msd.every=5e-5", "probe.msd.every=7e-5",
                                     "probe.energy.every=1e-5"};
  if (SCREE_TEST_PICTURES) others.push_back("snapshot={every=4e-5}");
  for (const std::string& other : others) {
    INFO(other);
    CHECK(observed(text, {other}).last == reference.last);
  }
  CHECK(run_in_memory(plan_of(text), {}).quantities[0] == reference.last);
}

TEST_CASE("observing does not change a run by a bit", "[run]") {
  // Bodies that touch from the start, for 40 steps; the probe interrupts each, or only the first.
  const std::string text = with(observing, "duration = 1e-4", "duration = 4e-4");
  for (const IntegrationTraits& scheme : integrations()) {
    INFO(scheme.name);
    const std::vector<std::string> touching = {"particles.lattice.gap=0",
                                               "time.integrator=" + std::string(scheme.name)};
    std::vector<std::string> silent = touching;
    silent.push_back("probe.msd.observe_every=1");
    CHECK(observed(text, touching).state_hash == observed(text, silent).state_hash);
  }
}

TEST_CASE("at one time a probe observes before it is sampled", "[run]") {
  // The first window is complete with the step of the second row, the last of this run; without it that is NaN.
  const Observed o = observed(with(observing, "duration = 1e-4", "duration = 2e-5"));
  CHECK(o.last == Approx(mean_square_speed() * 4e-10).epsilon(rounding));
}

TEST_CASE("observe_every spaces the observations, from the start of each stage", "[run]") {
  const double v2 = mean_square_speed();
  // At steps 3, 6 and 9: windows of three steps, and none of two.
  CHECK(observed(observing, {"probe.msd.observe_every=3e-5", "probe.msd.window=3e-5"}).last ==
        Approx(v2 * 9e-10).epsilon(rounding));
  CHECK(std::isnan(observed(observing, {"probe.msd.observe_every=3e-5"}).last));
  // In stages of five steps at 3, 5, 8: one window of two steps, from 3 to 5.
  const std::string staged =
      with(observing, "duration = 1e-4\n", "") +
      "[[stage]]\nname = 'a'\nduration = 5e-5\n[[stage]]\nname = 'b'\nduration = 5e-5\n";
  CHECK(observed(staged, {"probe.msd.observe_every=3e-5"}).last == Approx(v2 * 4e-10).epsilon(rounding));
  // In the second stage alone at 5, 8.
  CHECK(observed(staged, {"probe.msd.observe_every=3e-5", "probe.msd.window=3e-5", "probe.msd.stages=['b']"})
            .last == Approx(v2 * 9e-10).epsilon(rounding));
}
