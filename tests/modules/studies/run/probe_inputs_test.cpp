#include "run_support.hpp"

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/run/run_in_memory.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

namespace {

PluginHost& host_with_outside() {
  static PluginHost both({SCREE_TEST_PLUGINS, SCREE_TEST_OUTSIDE});
  return both;
}

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

// The bodies of `discs` under a weight, so that energies change, and what the probe `ratio` makes of two of them.
const std::string falling =
    std::string(discs) + "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -100]\n";
const std::string ratio =
    "[[probe]]\nplugin = 'ratio'\nabove = 'energy.potential'\nbelow = 'energy.kinetic_translation'\nevery = 3e-5\n";

struct Series {
  Table energy, ratio;
};

Series series_of(const std::string& text, const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  const scenario::Plan plan =
      scenario::read_plan(folder.write("s.toml", text), overrides, host_with_outside());
  RunOptions options;
  options.out = folder / "out";
  run_plan(plan, options);
  return {series_in(options.out / "series/energy.csv"), series_in(options.out / "series/ratio.csv")};
}

constexpr double pi = std::numbers::pi;

// A disc of 1 kg between two walls, pressed by both; one of them oscillates. The springs are linear while both touch.
constexpr double stiffness = 1e4, damping = 10, frequency = 20, drive = 1e-6, drive_phase = pi / 6;
const std::string oscillator =
    "[scene]\ndimension = 2\n[time]\nstep = 2e-4\nduration = 3.5\n"
    "[[material]]\nname = 'grain'\ndensity = 1000\n"
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e4\nnormal_damping = 10\ntension = 'allowed'\n"
    "[[particle]]\nposition = [0, 0]\nradius = 0.01\nmass = 1\n"
    "[[boundary]]\nplugin = 'plane'\nname = 'left'\npoint = [-0.0099, 0]\nnormal = [1, 0]\n"
    "displacement = { wave = 'sine', amplitude = 1e-6, frequency_hz = 20, phase_deg = 30 }\n"
    "[[boundary]]\nplugin = 'plane'\nname = 'right'\npoint = [0.0099, 0]\nnormal = [-1, 0]\n"
    "[[probe]]\nplugin = 'particles'\nids = [1]\nevery = 0.5\n"
    "[[probe]]\nplugin = 'lock_in'\nname = 'response'\nof = 'particles.x_1'\nfrequency_hz = 20\nfrom = 2.5\nperiods = 20\n"
    "every = 0.5\n"
    "[[expect]]\nrequirement = 'amplitude'\nquantity = 'response.amplitude.last'\nat_least = 0\n"
    "[[expect]]\nrequirement = 'phase'\nquantity = 'response.phase.last'\nat_least = -4\n"
    "[[expect]]\nrequirement = 'samples'\nquantity = 'response.samples.last'\nat_least = 1\n"
    "[[expect]]\nrequirement = 'residual'\nquantity = 'response.residual.last'\nat_least = 0\n";

}  // namespace

TEST_CASE("a probe from outside reads columns of others at its own times, whether they record then or not",
          "[run]") {
  const Series all = series_of(falling + ratio, {"probe.energy.every=1e-5", "probe.ratio.every=1e-5"});
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
  // The energy probe records at steps 0, 2, 4, ..., the ratio at 0, 3, 6, 9 and at the end; and the ratio stands first.
  const Series few = series_of(with(falling, "[[probe]]", ratio + "[[probe]]"), {});
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
  const Series read = series_of(text, {"probe[2].every=1e-5"});
  const std::string expected = "[[expect]]\nrequirement = 'a'\nquantity = 'second.sum.last'\nat_least = 0\n";
  const TemporaryFolder folder;
  const scenario::Plan plan =
      scenario::read_plan(folder.write("s.toml", text + expected), {}, host_with_outside());
  double sum = 0, sums = 0;
  for (const double energy : read.energy.at("potential [J]")) sums += (sum += energy);
  CHECK(run_in_memory(plan, {}).quantities[0] == sums);
}

TEST_CASE("a lock-in measures the response of a driven oscillator", "[run]") {
  const std::complex<double> i(0, 1);
  const double w = 2 * pi * frequency;
  // m x" = k (u − x) − k x + γ (u' − x') − γ x'
  const std::complex<double> response = drive * std::exp(i * drive_phase) * (stiffness + i * w * damping) /
                                        (2 * stiffness - w * w + 2.0 * i * w * damping);
  const std::vector<double> found = run_in_memory(plan_of(oscillator), {}).quantities;
  // (ω_0 h)² = 8e-4 is the step error of second order; the motion at the start has decayed by exp(−25).
  CHECK(found[0] == Approx(std::abs(response)).epsilon(8e-4));
  CHECK(found[1] == Approx(std::arg(response)).epsilon(0).margin(8e-4));
  CHECK(found[2] == 1000);
  CHECK(found[3] < 1e-6 * std::abs(response));
}

TEST_CASE("measuring a response does not change a run by a bit", "[run]") {
  const Bench with_probe(oscillator,
                         {"time.duration=0.5", "probe.response.from=0", "probe.response.periods=10"});
  const std::string probe = oscillator.substr(0, oscillator.find("[[probe]]"));
  CHECK(with_probe.run().state_hash == Bench(probe, {"time.duration=0.5"}).run().state_hash);
}

TEST_CASE("a run that is resumed in the middle of a record measures the same bits", "[run]") {
  const std::vector<std::string> settings = {
      "time.duration=1",          "probe.response.from=0.2",    "probe.response.periods=15",
      "probe.response.every=0.1", "checkpoint.every_time=0.43", "checkpoint.final_state=false"};
  const Bench bench(oscillator, settings);
  const RunResult whole = bench.run();
  const std::string series = text_of(bench.options.out / "series/response.csv");
  // Only the state at 0.43 s remains, after a quarter of the record.
  std::vector<std::filesystem::path> states;
  for (const auto& entry : std::filesystem::directory_iterator(bench.options.out / "checkpoint"))
    states.push_back(entry.path());
  REQUIRE(states.size() == 2);
  std::filesystem::remove(std::max(states[0], states[1]));
  const RunResult resumed = resume_run(bench.options, {}, host());
  CHECK(text_of(bench.options.out / "series/response.csv") == series);
  REQUIRE(resumed.verdicts.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) CHECK(resumed.verdicts[k].value == whole.verdicts[k].value);
  CHECK(resumed.verdicts[2].value == 750);
}

TEST_CASE("a record beyond the end of the run is refused where its probe stands", "[run]") {
  const TemporaryFolder folder;
  const scenario::Plan plan = plan_of(oscillator, {"probe.response.from=4"});
  const std::string line = message([&] { run_in_memory(plan, {}); });
  INFO(line);
  CHECK(line.find("scene.toml:") != std::string::npos);
  CHECK(line.find("probe lock_in: from = 4 s is not before 3.5 s, when the run") != std::string::npos);
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
