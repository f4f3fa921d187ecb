#include "oscillator.hpp"
#include "run_support.hpp"

#include <algorithm>
#include <map>
#include <sstream>

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

// A probe that observes, in the scene `discs`, whose bodies fly freely for its ten steps of 1e-5 s: the
// squared displacement over windows is exact.
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

// Plug-ins of the build tree and the probe `ratio`.
PluginHost& host_with_outside() {
  static PluginHost both({SCREE_TEST_PLUGINS, SCREE_TEST_OUTSIDE});
  return both;
}

// The bodies of `discs` under a weight, so that energies change, and what the probe `ratio` makes of two of
// them.
const std::string falling =
    std::string(discs) + "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -100]\n";
const std::string ratio =
    "[[probe]]\nplugin = 'ratio'\nabove = 'energy.potential'\nbelow = 'energy.kinetic_translation'\nevery = 3e-5\n";

using Table = std::map<std::string, std::vector<double>>;

// A series by the names of its columns, with their units.
Table series_in(const std::filesystem::path& file) {
  std::istringstream text(text_of(file));
  std::string line, cell;
  std::getline(text, line);
  std::vector<std::string> names;
  for (std::istringstream header(line); std::getline(header, cell, ',');) names.push_back(cell);
  Table table;
  while (std::getline(text, line)) {
    std::istringstream row(line);
    for (const std::string& name : names)
      std::getline(row, cell, ','), table[name].push_back(std::stod(cell));
  }
  return table;
}

struct Tables {
  Table energy, ratio;
};

Tables tables_of(const std::string& text, const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  const scenario::Plan plan =
      scenario::read_plan(folder.write("s.toml", text), overrides, host_with_outside());
  RunOptions options;
  options.out = folder / "out";
  run_plan(plan, options);
  return {series_in(options.out / "series/energy.csv"), series_in(options.out / "series/ratio.csv")};
}

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
  // The first window is complete with the step of the second row, the last of this run; without it that is
  // NaN.
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

TEST_CASE("a probe from outside reads columns of others at its own times, whether they record then or not",
          "[run]") {
  const Tables all = tables_of(falling + ratio, {"probe.energy.every=1e-5", "probe.ratio.every=1e-5"});
  const std::vector<double>&above = all.energy.at("potential [J]"),
        &below = all.energy.at("kinetic_translation [J]");
  REQUIRE(above.size() == 11);
  REQUIRE(all.ratio.at("ratio").size() == 11);
  double sum = 0;
  for (std::size_t k = 0; k < above.size(); ++k) {
    INFO(k);
    CHECK(all.ratio.at("ratio")[k] == above[k] / below[k]);
    CHECK(all.ratio.at("sum [J]")[k] == (sum += above[k]));
  }
  // The energy probe records at steps 0, 2, 4, ..., the ratio at 0, 3, 6, 9 and at the end; and the ratio
  // stands first.
  const Tables few = tables_of(with(falling, "[[probe]]", ratio + "[[probe]]"), {});
  const std::vector<std::size_t> steps = {0, 3, 6, 9, 10};
  REQUIRE(few.ratio.at("ratio").size() == steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    CHECK(few.ratio.at("ratio")[k] == all.ratio.at("ratio")[steps[k]]);
    CHECK(few.ratio.at("sum [J]")[k] == all.ratio.at("sum [J]")[steps[k]]);
  }
  CHECK(few.energy.at("time [s]").size() == 6);
}

TEST_CASE("a probe sees others after these have observed, also through a third", "[run]") {
  // The last of three probes adds up what the second sums, which adds up energies: sums of sums.
  const std::string second = with(with(ratio, "plugin = 'ratio'", "plugin = 'ratio'\nname = 'second'"),
                                  "above = 'energy.potential'", "above = 'ratio.sum'");
  const std::string text = with(falling, "[[probe]]", second + ratio + "[[probe]]");
  const Tables read = tables_of(text, {"probe[2].every=1e-5"});
  const std::string expected = "[[expect]]\nrequirement = 'a'\nquantity = 'second.sum.last'\nat_least = 0\n";
  const TemporaryFolder folder;
  const scenario::Plan plan =
      scenario::read_plan(folder.write("s.toml", text + expected), {}, host_with_outside());
  double sum = 0, sums = 0;
  for (const double energy : read.energy.at("potential [J]")) sums += (sum += energy);
  CHECK(run_in_memory(plan, {}).quantities[0] == sums);
}

TEST_CASE("a record that does not lie within the stages of its probe is refused at the start", "[run]") {
  const std::string stages =
      with(oscillator, "duration = 3.5\n", "") +
      "[[stage]]\nname = 'one'\nduration = 1\n[[stage]]\nname = 'two'\nduration = 2\n[[stage]]\nname = 'three'\nduration = 1\n";
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& of_stages, const std::string& from) {
    const std::string text = with(with(stages, "from = 2.5\n", "from = " + from + "\n"),
                                  "name = 'response'\n", "name = 'response'\nstages = " + of_stages + "\n");
    RunOptions options;
    options.out = folder / "out";
    const std::string line = message([&] {
      run_plan(scenario::read_plan(folder.write("s.toml", text), {"expect=[]"}, host_with_outside()),
               options);
    });
    CHECK(!std::filesystem::exists(options.out));
    return line;
  };
  // It is 1 s long; stage two is from 1 to 3 s.
  CHECK(refused("['two']", "2.5")
            .find("the record from 2.5 to 3.5 s lasts beyond 3 s, when the run or the stages of "
                  "the probe end; give fewer periods") != std::string::npos);
  CHECK(refused("['two']", "0.5")
            .find("the record begins at from = 0.5 s, and the probe at 1 s with its stages; give a "
                  "later from") != std::string::npos);
  CHECK(refused("['one']", "0.5").find("lasts beyond 1 s") != std::string::npos);
  CHECK(refused("['one', 'two']", "3").find("from = 3 s is not before 3 s") != std::string::npos);
}

TEST_CASE("a record that a stage of unknown length does not fill is told at the end", "[run]") {
  // The stage ends as soon as it may, before the record begins.
  const std::string text =
      with(with(oscillator, "duration = 3.5\n", ""), "at_least = 1\n", "at_least = 0\n") +
      "[[stage]]\nname = 'rest'\nuntil = {kinetic_over_elastic = 1e9, at_least = 0.1, at_most = 5}\n";
  const TemporaryFolder folder;
  RunOptions options;
  options.out = folder / "out";
  const RunResult result = run_plan(
      scenario::read_plan(folder.write("s.toml", text), {"expect=[]"}, host_with_outside()), options);
  const auto told = std::find_if(result.warnings.begin(), result.warnings.end(), [](const std::string& line) {
    return line.find("the record of 'response' was not filled while it recorded, so that amplitude, phase") !=
           std::string::npos;
  });
  REQUIRE(told != result.warnings.end());
  CHECK(told->find("s.toml:") != std::string::npos);
  CHECK(told->find("; give it an earlier or shorter record, or longer stages") != std::string::npos);
}

TEST_CASE("measuring a response does not change a run by a bit", "[run]") {
  const Bench with_probe(oscillator,
                         {"time.duration=0.5", "probe.response.from=0", "probe.response.periods=10"});
  const std::string probe = oscillator.substr(0, oscillator.find("[[probe]]"));
  CHECK(with_probe.run().state_hash == Bench(probe, {"time.duration=0.5"}).run().state_hash);
}
