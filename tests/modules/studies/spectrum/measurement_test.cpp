#include "bench.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/spectrum/measurement.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

namespace {

constexpr const char* measured_grid =
    "from_hz = 70\nto_hz = 105\nstep_hz = 0.5\nsweep.periods = 100\nlinear.fewest_contacts = 1\npulse.decay = 1e-6\n";

}  // namespace

TEST_CASE("three methods find the same peak of a chain", "[spectrum]") {
  const Bench bench(Chain().text(measured_grid));
  const Measurement m = measure(bench.plan, bench.options);
  REQUIRE(m.spectra.size() == 3);
  REQUIRE(m.peaks.size() == 6);
  for (const Peak& r : m.peaks) {
    // The fit of three widths leaves a background of the other modes: 1e-5 of f0. Runs are shifted by the
    // step.
    const bool runs = m.spectra[r.spectrum].method != "linear";
    const double exact = runs ? Chain::with_step(Chain::mode_hz(2)) : Chain::mode_hz(2);
    CAPTURE(m.spectra[r.spectrum].method, r.column, r.mode.frequency, exact, r.mode.frequency_error);
    CHECK(std::abs(r.mode.frequency / exact - 1) < 1e-4);
  }
  for (const char* file : {"sweep.csv", "spectrum.csv", "peaks.csv", "methods.csv", "spectrum.json",
                           "scenario.toml", "state.h5"})
    CHECK(bench.has(file));
  const std::string report = text_report(m);
  INFO(report);
  CHECK(std::count(report.begin(), report.end(), '\n') <= 25);
  CHECK(report.find("particles.z_8") != std::string::npos);
}

TEST_CASE("a column relative to its mean is divided by it on every method", "[spectrum]") {
  const std::string few =
      "from_hz = 100\nto_hz = 110\nstep_hz = 5\nsweep.periods = 12\nsweep.analysed_periods = 6\nlinear.fewest_contacts = 1\n";
  Bench plain(Chain().text(few)), relative(Chain().text(few + "relative_to_mean = ['particles.z_8']\n"));
  const Measurement a = measure(plain.plan, plain.options), b = measure(relative.plan, relative.options);
  REQUIRE(a.spectra.size() == 3);
  // The bead at the top is at 0.07464 m; it moves by 1e-8 m about that.
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 3; ++k) {
      CAPTURE(a.spectra[r].method, k);
      const std::complex<double> whole = a.spectra[r].columns[1].response[k];
      CHECK(std::abs(0.07464 * b.spectra[r].columns[1].response[k] / whole - 1.0) < 1e-6);
      CHECK(b.spectra[r].columns[0].response[k] == a.spectra[r].columns[0].response[k]);
    }
}

TEST_CASE("stages run before anything is measured", "[spectrum]") {
  // A floor that stays where its stage has brought it.
  const std::string text =
      with(Chain().text("from_hz = 80\nto_hz = 100\nstep_hz = 5\nlinear.fewest_contacts = 1\n"),
           "displacement = 0", "displacement = {from = 0, to = 0.001, duration = 0.05}") +
      "[[stage]]\nduration = 0.2\n";
  Bench bench(text);
  bench.options.methods = {Method::linear};
  std::set<std::string> seen;
  bench.options.on_progress = [&](double, double, const std::string& what) { seen.insert(what); };
  const Measurement m = measure(bench.plan, bench.options);
  CHECK(seen.contains("stage 1"));
  CHECK(std::abs(m.spectra.at(0).columns[1].response[0] - Chain().response(Chain::beads, 80)) < 1e-6);
}

TEST_CASE("a spectrum that cannot be measured leaves nothing behind", "[spectrum]") {
  const auto refused = [](const std::string& text, const std::vector<std::string>& overrides) {
    Bench bench(text, overrides);
    bench.options.methods = {Method::linear};
    const std::string line = message([&] { measure(bench.plan, bench.options); });
    CHECK(!std::filesystem::exists(bench.options.out));
    return line;
  };
  std::string without = Chain().text(measured_grid);
  without = with(without.erase(without.find("[spectrum]")), "[time]\n", "[time]\nduration = 1\n");
  CHECK_THAT(refused(without, {}), Catch::Contains("has no [spectrum]; add one"));
  CHECK_THAT(refused(Chain().text(measured_grid), {"spectrum.linear.fewest_contacts=9"}),
             Catch::Contains("no body is held"));
}

TEST_CASE("one method that fails does not hinder the others", "[spectrum]") {
  Bench bench(
      Chain().text(
          "from_hz = 100\nto_hz = 110\nstep_hz = 5\nsweep.periods = 12\nsweep.analysed_periods = 6\npulse.longest = 0.1\n") +
          "[[expect]]\nrequirement = 'r'\nquantity = 'peaks.linear.particles.z_8.peak_1.frequency'\nat_most = 1e9\n",
      {"spectrum.linear.fewest_contacts=9"});
  std::vector<std::string> warnings;
  bench.options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  const Measurement m = measure(bench.plan, bench.options);
  CHECK(m.spectra.size() == 2);
  REQUIRE(!warnings.empty());
  CHECK(warnings[0].find("method 'linear' skipped") != std::string::npos);
  // What was asked for and is not there is not met.
  REQUIRE(m.verdicts.size() == 1);
  CHECK(!m.verdicts[0].met);
}

TEST_CASE("a sweep that becomes unstable keeps what it has and says that it failed", "[spectrum]") {
  // Beads move faster than the limit where the frequency is that of the chain.
  Bench bench(Chain().text(
      "from_hz = 60\nto_hz = 87\nstep_hz = 9\nsweep.periods = 40\nsweep.analysed_periods = 20\n"));
  bench.plan.scene.limits.speed = 2e-5;  // reached at 87 Hz alone
  bench.options.methods = {Method::sweep};
  CHECK_THROWS_AS(measure(bench.plan, bench.options), Error);
  CHECK(bench.text("spectrum.json").find("\"status\": \"failed\"") != std::string::npos);
  const std::string table = bench.text("sweep.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') > 1);
  CHECK(bench.has("state.h5"));
}

TEST_CASE("columns without a value and layers without beads are refused before anything is written",
          "[spectrum]") {
  std::string line;
  SECTION("a layer without beads") {
    Bench bench(with(Chain().text(measured_grid), "'particles.z_1'", "'layer.position'") +
                "[[probe]]\nplugin = 'layer'\naxis = 'z'\nat = 5\nhalf_width = 0.001\n");
    line = message([&] { measure(bench.plan, bench.options); });
    CHECK(!std::filesystem::exists(bench.options.out));
  }
  SECTION("energies that are not computed") {
    Bench bench(with(Chain().text(measured_grid), "'particles.z_1'", "'energy.residual'") +
                "[[probe]]\nplugin = 'energy'\n");
    bench.plan.scene.audit = false;
    line = message([&] { measure(bench.plan, bench.options); });
    CHECK(line.find("'energy.residual' has no value at the start; observe") != std::string::npos);
    CHECK(!std::filesystem::exists(bench.options.out));
  }
  INFO(line);
  CHECK(line.find("scene.toml:") != std::string::npos);
  CHECK(line.find("; ") != std::string::npos);
}

TEST_CASE("a drive that moves no wall is refused", "[spectrum]") {
  const std::string text = with(Chain().text(measured_grid), "displacement = 0\n", "control = 'fixed'\n");
  Bench bench(text);
  CHECK(message([&] { measure(bench.plan, bench.options); }).find("moves no wall with its present control") !=
        std::string::npos);
  CHECK(!std::filesystem::exists(bench.options.out));
}

TEST_CASE("peaks are named from the shape of the motion", "[spectrum]") {
  Bench bench(
      Chain().text(
          "from_hz = 20\nto_hz = 160\nstep_hz = 0.25\nlinear.fewest_contacts = 1\nshape_from = 'profile'\n") +
      Chain::layers);
  bench.options.methods = {Method::linear};
  const Measurement m = measure(bench.plan, bench.options);
  std::vector<std::string> names;
  for (const Peak& r : m.peaks)
    if (m.observed[r.column].name == "particles.z_8") names.push_back(name_of(r));
  CHECK(names == std::vector<std::string>{"λ/4", "3λ/4", "5λ/4"});
  const auto record = nlohmann::json::parse(bench.text("spectrum.json"));
  for (const std::string& name : names) CHECK(record["peaks"]["linear"]["particles.z_8"].contains(name));
  // The discrete shape of the fixed-free chain, sin((2j - 1) n π/(2 N + 1)). The other modes are in
  // quadrature at a peak, so that they enter by the square of their share: 3/Q of each neighbour, Q = 15.
  constexpr double tolerance = 2 * (3.0 / 15) * (3.0 / 15);
  for (std::size_t n = 1; n <= 8; ++n) {
    const double exact = std::sin(3 * double(n) * std::acos(-1.0) / 17);
    CHECK(std::abs(std::abs(m.peaks[1].shape[n - 1]) - std::abs(exact)) < tolerance);
  }
  CHECK(bench.has("shapes.csv"));
  // The last layer holds bead 8 alone: its response is that of the column. Central differences leave 1e-9.
  const Peak& peak = m.peaks[1];
  const std::size_t nearest = std::size_t(std::lround((peak.mode.frequency - 20) / 0.25));
  const auto is_bead = [](const auto& c) { return c.name == "particles.z_8"; };
  const auto column = std::find_if(m.observed.begin(), m.observed.end(), is_bead) - m.observed.begin();
  const std::complex<double> bead = m.spectra[0].columns[std::size_t(column)].response[nearest];
  CHECK(std::abs(peak.layers[7] - bead) < 1e-8 * std::abs(bead));
  // Layers are in the shapes, not in the tables.
  CHECK(bench.text("spectrum.csv").find("displacement") == std::string::npos);
}

TEST_CASE("expectations of peaks are judged by the methods that measured", "[spectrum]") {
  const auto expect = [](const char* quantity, const char* bounds) {
    return fmt::format("[[expect]]\nrequirement = 'r'\nquantity = '{}'\n{}\n", quantity, bounds);
  };
  // The second mode, 87.11 Hz; the fit of a peak leaves 1e-5 of the other modes.
  Bench bench(
      Chain().text(
          "from_hz = 20\nto_hz = 160\nstep_hz = 0.25\nlinear.fewest_contacts = 1\nshape_from = 'profile'\n") +
      Chain::layers +
      expect("peaks.linear.particles.z_8.3lambda/4.frequency", "reference = 87.11\ntolerance = 0.01") +
      expect("peaks.linear.particles.z_1.peak_1.frequency", "at_least = 30") +
      expect("peaks.linear.particles.z_8.peak_9.frequency", "at_most = 1e9") +
      expect("peaks.pulse.particles.z_8.peak_1.frequency", "at_most = 1"));
  bench.options.methods = {Method::linear};
  const Measurement m = measure(bench.plan, bench.options);
  REQUIRE(m.verdicts.size() == 3);  // there is no pulse
  CHECK(m.verdicts[0].met);
  CHECK(!m.verdicts[1].met);
  CHECK(std::abs(m.verdicts[1].value - Chain::mode_hz(1)) < 0.01);
  CHECK(!m.verdicts[2].met);  // there is no such peak
  CHECK(std::isnan(m.verdicts[2].value));
  const std::string record = bench.text("spectrum.json");
  CHECK(record.find("\"name\": \"3λ/4\"") != std::string::npos);
  CHECK(record.find("\"met\": true") != std::string::npos);
}

TEST_CASE("a spectrum that would be noise or empty is refused before anything is written", "[spectrum]") {
  const auto refused = [](const std::string& keys, Method method, const std::string& from = "",
                          const std::string& to = "") {
    const std::string text = Chain().text(
        "from_hz = 100\nto_hz = 110\nstep_hz = 5\nsweep.periods = 12\n"
        "sweep.analysed_periods = 6\nlinear.fewest_contacts = 1\n" +
        keys);
    Bench bench(from.empty() ? text : with(text, from, to));
    bench.options.methods = {method};
    const std::string line = message([&] { measure(bench.plan, bench.options); });
    CHECK(!bench.has("spectrum.json"));
    return line;
  };
  // Positions of up to 0.08 m are rounded to 1e-17 m.
  for (const Method method : {Method::pulse, Method::sweep})
    CHECK_THAT(refused("", method, "amplitude = 1e-8", "amplitude = 1e-16"),
               Catch::Contains("an amplitude of 1e-16 m is lost in the round-off of positions"));
  CHECK_THAT(refused("pulse.longest = 0.01\n", Method::pulse),
             Catch::Contains("the record of 0.01 s ends before the pulse of 0.0363636 s; give a longer"));
  CHECK_THAT(refused("relative_to_mean = ['particles.x_1']\n", Method::sweep, "observe = ['particles.z_1'",
                     "observe = ['particles.x_1'"),
             Catch::Contains("'particles.x_1' is 0 at the start"));
}

TEST_CASE("a wall that keeps its load cannot be driven", "[spectrum]") {
  std::string text = Chain().text("from_hz = 100\nto_hz = 110\nstep_hz = 5\nlinear.fewest_contacts = 1\n");
  text = with(text, "displacement = 0", "control = 'massless'\nforce = 0.08\nspeed_limit = 1");
  Bench bench(with(text, "drive = 'floor.displacement'", "drive = 'floor.superposed'"));
  CHECK_THAT(message([&] { measure(bench.plan, bench.options); }),
             Catch::Contains(
                 "a servo or massless wall keeps its load, so that 'superposed' of 'floor' drives nothing"));
}

TEST_CASE("an overriding empty text or list leaves the shapes out", "[spectrum]") {
  const std::string text =
      with(Chain().text("from_hz = 100\nto_hz = 110\nstep_hz = 5\nshape_from = 'profile'\n"), "[spectrum]",
           Chain::layers + std::string("[spectrum]"));
  CHECK(read_spectrum(driven_plan_of(text))->observed.size() == 2 + 8);
  for (const char* empty : {"spectrum.shape_from=[]", "spectrum.shape_from=\"\""}) {
    CAPTURE(empty);
    CHECK(read_spectrum(driven_plan_of(text, {empty}))->observed.size() == 2);
  }
}

TEST_CASE("a peak whose amplitude is below twice its error has no name", "[spectrum]") {
  Peak peak;
  peak.wavelengths = 1.75;
  peak.mode.amplitude = 36;
  peak.maximum = 0;
  for (const auto& [error, name] : {std::pair{17.0, "7λ/4"}, std::pair{19.0, ""}}) {
    peak.mode.amplitude_error = error;
    CHECK(name_of(peak) == name);
  }
}

TEST_CASE("outstanding maxima that no peak fits are named", "[spectrum]") {
  const Chain chain = {.damping = 0.02};
  const auto warned = [&](const std::string& frequencies) {
    Bench bench(chain.text(frequencies + "linear.fewest_contacts = 1\n"));
    bench.options.methods = {Method::linear};
    const std::vector<std::string> lines = measure(bench.plan, bench.options).warnings;
    return std::count_if(lines.begin(), lines.end(), [](const std::string& line) {
      return line.starts_with("linear: the maximum of particles.z_8 at ");
    });
  };
  // The modes at 29.4, 87.1 and 141.9 Hz are (drag/m + ω² damping/k)/2π = 1.7, 2.5 and 4.1 Hz wide, less than
  // 4 steps of 3 Hz. At 10, 13, ... Hz the highest responses to them are alike.
  const auto height = [&](double hz) { return std::abs(chain.response(Chain::beads, hz)); };
  for (const double hz : {88, 142}) REQUIRE(height(hz) > 0.5 * std::max(height(28), height(31)));
  CHECK(warned("from_hz = 10\nto_hz = 160\nstep_hz = 0.4\n") == 0);
  CHECK(warned("from_hz = 10\nto_hz = 160\nstep_hz = 3\n") == 3);
  CHECK(warned("from_hz = 10\nto_hz = 60\nstep_hz = 3\n") == 1);
}
