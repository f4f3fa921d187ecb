#include "bench.hpp"
#include "foreign_state.hpp"

#include <algorithm>
#include <fstream>

#include <catch2/catch.hpp>

#include <scree/files/directory_lock.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

TEST_CASE("a scenario that is edited beside a spectrum that goes on is reported, and restored",
          "[spectrum]") {
  Bench bench(Chain().text(
      "from_hz = 100\nto_hz = 110\nstep_hz = 5\nsweep.periods = 12\nsweep.analysed_periods = 6\n"));
  bench.options.methods = {Method::sweep};
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](double share, double, const std::string&) { stop = share > 0; };
  REQUIRE(measure(bench.plan, bench.options).interrupted);
  stop = false;
  bench.options.on_progress = {};
  std::vector<std::string> warnings;
  bench.options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  const auto file = bench.options.out / "scenario.toml";
  const std::string began = bench.text("scenario.toml");
  std::ofstream(file) << with(began, "to_hz = 110", "to_hz = 200");
  CHECK_FALSE(resume_measurement(bench.options, host()).interrupted);
  REQUIRE(warnings.size() >= 1);
  CHECK_THAT(warnings[0],
             Catch::Contains("out/scenario.toml: is not the scenario with which these results began"));
  CHECK(bench.text("scenario.toml") == began);
}

TEST_CASE("a measurement that is interrupted in its stages goes on within them", "[spectrum]") {
  // A floor that rises, in 4000 steps, after 4000 others.
  const std::string text =
      with(Chain().text("from_hz = 80\nto_hz = 100\nstep_hz = 5\nlinear.fewest_contacts = 1\n"),
           "displacement = 0", "displacement = {from = 0, to = 0.001, duration = 0.2}") +
      "[[stage]]\nduration = 0.2\n[[stage]]\nname = 'second'\nduration = 0.2\n";
  Bench whole(text), parted(text);
  whole.options.methods = parted.options.methods = {Method::linear};
  measure(whole.plan, whole.options);

  std::atomic<bool> stop = false;
  parted.options.stop = &stop;
  for (const std::string in : {"stage 1", "second"}) {
    CAPTURE(in);
    stop = false;
    parted.options.on_progress = [&](double, double, const std::string& what) { stop = what == in; };
    const Measurement part =
        in == "stage 1" ? measure(parted.plan, parted.options) : resume_measurement(parted.options, host());
    CHECK(part.interrupted);
    CHECK(part.spectra.empty());
    CHECK(parted.text("spectrum.json").find("\"interrupted\"") != std::string::npos);
  }
  stop = false;
  parted.options.on_progress = {};
  CHECK(!resume_measurement(parted.options, host()).interrupted);
  CHECK(parted.text("spectrum.csv") == whole.text("spectrum.csv"));
}

TEST_CASE("a measurement that goes on keeps the hashes of what it began from", "[spectrum]") {
  const TemporaryFolder folder;
  folder.write("bead.csv", "id,material,x,y,z,radius\n9,sphere,0.1,0,0.1,0.005\n");
  std::string text = Chain().text(
      "from_hz = 100\nto_hz = 110\nstep_hz = 2\nsweep.periods = 12\nsweep.analysed_periods = 6\n");
  Bench bench(text + "[particles]\nfile = '" + (folder / "bead.csv").string() + "'\n");
  bench.options.methods = {Method::sweep};
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](double share, double, const std::string&) { stop = share > 0; };
  const Measurement first = measure(bench.plan, bench.options);
  REQUIRE(first.interrupted);
  REQUIRE(!first.inputs.bodies.empty());
  stop = false;
  bench.options.on_progress = {};
  CHECK(resume_measurement(bench.options, host()).inputs == first.inputs);
}

// In its steps, or after them in the second of its two columns.
TEST_CASE("a measurement that is interrupted in a pulse goes on with it", "[spectrum]") {
  const auto [in, at_share] =
      GENERATE(table<std::string, double>({{"pulse", 0}, {"response to the pulse", 0.6}}));
  CAPTURE(in);
  const std::string text = Chain().text(
      "from_hz = 100\nto_hz = 110\nstep_hz = 5\nsweep.periods = 12\nsweep.analysed_periods = 6\nlinear.fewest_contacts = 1\n");
  Bench whole(text), parted(text);
  measure(whole.plan, whole.options);

  std::atomic<bool> stop = false;
  parted.options.stop = &stop;
  parted.options.on_progress = [&, in = in, at_share = at_share](double share, double,
                                                                 const std::string& what) {
    stop = stop || (what == in && share >= at_share);
  };
  const Measurement first = measure(parted.plan, parted.options);
  REQUIRE(first.interrupted);
  REQUIRE(first.spectra.size() == 1);
  CHECK(first.spectra[0].method == "linear");
  CHECK_THAT(parted.text("spectrum.json"), Catch::Contains("\"status\": \"interrupted\""));
  stop = false;
  parted.options.on_progress = [](double, double, const std::string& what) {
    CHECK(what != "linear response");  // it is in the state
  };
  parted.options.methods = {Method::sweep};
  CHECK(resume_measurement(parted.options, host()).spectra.size() == 3);
  CHECK(parted.text("spectrum.csv") == whole.text("spectrum.csv"));
}

TEST_CASE("a spectrum that goes on in its directory is not told to take another", "[spectrum]") {
  Bench bench(Chain().text("from_hz = 100\nto_hz = 110\nstep_hz = 5\nlinear.fewest_contacts = 1\n"));
  bench.options.methods = {Method::linear};
  measure(bench.plan, bench.options);
  const auto lock = files::DirectoryLock::take(bench.options.out);
  CHECK(message([&] {
          resume_measurement(bench.options, host());
        }).ends_with("out: another spectrum is running there; wait for it"));
  // The same directory for a new one.
  bench.options.overwrite = true;
  CHECK(message([&] {
          measure(bench.plan, bench.options);
        }).ends_with("another spectrum is running there; wait for it, or give another --out"));
}

TEST_CASE("a measurement that goes on and cannot write records the cure for its place", "[spectrum]") {
  Bench bench(Chain().text(
      "from_hz = 100\nto_hz = 110\nstep_hz = 2\nsweep.periods = 12\nsweep.analysed_periods = 6\n"));
  bench.options.methods = {Method::sweep};
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](double share, double, const std::string&) { stop = share > 0; };
  REQUIRE(measure(bench.plan, bench.options).interrupted);
  stop = false;
  // A table cannot replace a directory.
  std::filesystem::remove(bench.options.out / "peaks.csv");
  std::filesystem::create_directories(bench.options.out / "peaks.csv");
  const auto status_of = [](const auto& work) {
    try {
      work();
    } catch (const Error& error) {
      return std::pair(error.status(), std::string(error.what()));
    }
    return std::pair(ExitStatus::success, std::string());
  };
  bench.options.on_progress = {};
  const auto [status, line] = status_of([&] { resume_measurement(bench.options, host()); });
  CHECK(status == ExitStatus::failure);
  const std::string problem = "peaks.csv: is a directory in the place of a file; move it elsewhere";
  CHECK_THAT(line, Catch::Contains(problem));
  const std::string record = bench.text("spectrum.json");
  CHECK_THAT(record, Catch::Contains("\"status\": \"failed\"") && Catch::Contains(problem + "\""));
  std::filesystem::remove(bench.options.out / "peaks.csv");
  CHECK(!resume_measurement(bench.options, host()).interrupted);
}

TEST_CASE("a measurement that goes on keeps the warnings of the methods before", "[spectrum]") {
  std::string text = Chain().text(
      "from_hz = 100\nto_hz = 110\nstep_hz = 5\nsweep.periods = 12\nsweep.analysed_periods = 6\nlinear.fewest_contacts = 1\n");
  // Observes a column that has no linear response.
  const std::string observed = "observe = ['particles.z_1', 'particles.z_8']";
  text.replace(text.find(observed), observed.size(),
               "observe = ['particles.z_1', 'energy.kinetic_translation']");
  text.insert(text.find("[spectrum]"), "[[probe]]\nplugin = 'energy'\nevery = 1e-3\n");
  Bench bench(text);
  bench.options.methods = {Method::linear, Method::sweep};
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](double, double, const std::string& what) {
    stop = what.starts_with("sweep");
  };
  const Measurement first = measure(bench.plan, bench.options);
  REQUIRE(first.interrupted);
  const auto left_out = [](const Measurement& m) {
    return std::count_if(m.warnings.begin(), m.warnings.end(), [](const std::string& line) {
      return line.find("(method 'linear' skipped)") != std::string::npos;
    });
  };
  CHECK(left_out(first) == 1);
  CHECK(std::none_of(first.spectra.begin(), first.spectra.end(),
                     [](const MethodSpectrum& spectrum) { return spectrum.method == "linear"; }));
  stop = false;
  bench.options.on_progress = {};
  CHECK(left_out(resume_measurement(bench.options, host())) == 1);
}

TEST_CASE("the state of another spectrum is refused", "[spectrum]") {
  const auto interrupted = [](Bench& bench, std::atomic<bool>& stop) {
    bench.options.methods = {Method::sweep};
    bench.options.stop = &stop;
    bench.options.on_progress = [&](double, double, const std::string&) { stop = true; };
    measure(bench.plan, bench.options);
    bench.options.on_progress = {};
    stop = false;
  };
  const std::string text =
      "from_hz = 100\nstep_hz = 5\nsweep.periods = 12\nsweep.analysed_periods = 6\nto_hz = ";
  Bench one(Chain().text(text + "110\n")), other(Chain().text(text + "120\n"));
  std::atomic<bool> stop = false;
  interrupted(one, stop);
  interrupted(other, stop);
  std::filesystem::copy_file(other.options.out / "state.h5", one.options.out / "state.h5",
                             std::filesystem::copy_options::overwrite_existing);
  CHECK_THAT(
      message([&] { resume_measurement(one.options, host()); }),
      Catch::Contains("state.h5: is the state of another spectrum than that in spectrum.json; put back"));
  CHECK(resume_measurement(other.options, host()).spectra.size() == 1);
}

TEST_CASE("a spectrum writes states as [checkpoint] says, and where it is interrupted", "[spectrum]") {
  const std::string every = GENERATE("'never'", "'10 min'");
  CAPTURE(every);
  Bench bench(
      Chain().text(
          "from_hz = 100\nto_hz = 110\nstep_hz = 5\nsweep.periods = 12\nsweep.analysed_periods = 6\n"),
      {"checkpoint.every=" + every});
  bench.options.methods = {Method::sweep};
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bool written = false;
  bench.options.on_progress = [&](double, double, const std::string&) {
    written = bench.has("state.h5");
    stop = true;
  };
  REQUIRE(measure(bench.plan, bench.options).interrupted);
  CHECK(written == (every != "'never'"));
  CHECK(bench.has("state.h5"));
  stop = false;
  bench.options.on_progress = {};
  CHECK_FALSE(resume_measurement(bench.options, host()).interrupted);
}

TEST_CASE("a state of a measurement that does not fit is refused, and nothing is changed", "[spectrum]") {
  Bench bench(Chain().text(
      "from_hz = 100\nto_hz = 110\nstep_hz = 2\nsweep.periods = 400\nsweep.analysed_periods = 6\nlinear.fewest_contacts = 1\n"));
  bench.options.methods = {Method::linear, Method::sweep};
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](double share, double, const std::string& what) {
    stop = share > 0.2 && what.starts_with("sweep");
  };
  REQUIRE(measure(bench.plan, bench.options).interrupted);
  bench.options.on_progress = {};
  const std::filesystem::path file = bench.options.out / "state.h5";
  const std::string sound = text_of(file), record = bench.text("spectrum.json");
  const auto refused = [&](const auto& change) {
    bench.folder.write("out/state.h5", sound);
    change();
    const std::string line = message([&] { resume_measurement(bench.options, host()); });
    CHECK(line.find("; ") != std::string::npos);
    CHECK(bench.text("spectrum.json") == record);
    return line;
  };
  const auto shortened = [&](const char* path) {
    return refused([&] { change_state(file, path, shorten); });
  };
  for (const std::string path :
       {"spectrum/asked", "spectrum/sweep/walls/motion", "clock/time", "bodies/radius"})
    CHECK_THAT(refused([&] { remove_array(file, path); }),
               Catch::StartsWith(file.string() + ": the state has no '" + path + "'; "));
  for (const char* path : {"motion", "at_rest"})
    CHECK(shortened((std::string("spectrum/sweep/walls/") + path).c_str()).find("does not have") !=
          std::string::npos);
  CHECK(refused([&] {
          change_state(file, "spectrum/sweep/walls/at_rest", [](StateArray& array) {
            array.values = std::vector<double>{};
            array.shape = {0};
          });
        }).find("does not have a vector for each wall") != std::string::npos);
  for (const char* path :
       {"spectrum/sweep/0/columns", "spectrum/method_0/0/response", "spectrum/method_0/0/error",
        "spectrum/method_0/frequencies", "spectrum/sweep/observer/0/state"})
    shortened(path);
  CHECK(refused([&] {
          change_number(file, "spectrum/sweep/frequencies", 1, 101.5);
        }).find("are not those of the scenario") != std::string::npos);
  CHECK(refused([&] {
          change_number(file, "spectrum/sweep/0/frequency", 0, 102.0);
        }).find("is not that of the sweep there") != std::string::npos);
  for (const char* path : {"spectrum/count", "spectrum/sweep/points", "spectrum/method_0/columns"})
    refused([&] { change_number(file, path, 0, std::uint64_t(1) << 60); });
  CHECK(refused([&] {
          const std::string plain = with(Chain().text(""), "[spectrum]\n", "[spectrum_of_none]\n");
          change_number(file, "spectrum/scenario", 0, plain.substr(0, plain.find("[spectrum_of_none]")));
        }) != "no error");
}
