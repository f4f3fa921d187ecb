#include "table_support.hpp"

#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/spectrum/spectrum_plan.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("a spectrum is read with its grid, drive and columns, and needs no stages", "[spectrum]") {
  const scenario::Plan plan = plan_with_spectrum(driven, {"spectrum.relative_to_mean=['particles.z_1']"});
  CHECK(plan.stages.empty());
  CHECK(plan.studies == std::vector<std::string>{"spectrum"});
  const auto spectrum = spectrum::read_spectrum(plan);
  REQUIRE(spectrum);
  CHECK(spectrum->frequencies() == std::vector<double>{10, 20, 30, 40, 50});
  CHECK(spectrum->boundary == "floor");
  CHECK(spectrum->key == "displacement");
  REQUIRE(spectrum->observed.size() == 1);
  CHECK(spectrum->observed[0].relative);
  CHECK(spectrum->observed[0].unit == "m");
  CHECK(spectrum->observed[0].column == 2);
  CHECK(spectrum->pulse.longest == 3);
}

TEST_CASE("a scene without [spectrum] has none to read", "[spectrum]") {
  const scenario::Plan plan = plan_with_spectrum(std::string(discs));
  CHECK(plan.studies.empty());
  CHECK_FALSE(spectrum::read_spectrum(plan));
}

TEST_CASE("[spectrum] is an unknown table where no study reads it", "[spectrum]") {
  CHECK(refusal(driven).find("unknown key 'spectrum'") != std::string::npos);
}

TEST_CASE("a grid whose steps do not add up to its end stops before it", "[spectrum]") {
  CHECK(spectrum::read_spectrum(plan_with_spectrum(driven, {"spectrum.to_hz=49"}))->frequencies() ==
        std::vector<double>{10, 20, 30, 40});
}

TEST_CASE("each method reads the keys of its own table", "[spectrum]") {
  const auto spectrum = spectrum::read_spectrum(plan_with_spectrum(
      driven + "[spectrum.sweep]\nadaptive = true\ntolerance = 1e-2\n"
               "[spectrum.pulse]\nwave = 'noise'\nnoise_rms = 2e-8\nnoise_duration = 9\nlongest = 4\n",
      {"spectrum.linear.step='run'", "spectrum.linear.tolerance=1e-4"}));
  CHECK(spectrum->sweep.adaptive);
  CHECK_FALSE(spectrum->linear.adaptive);
  CHECK(spectrum->sweep.tolerance == 1e-2);
  CHECK(spectrum->linear.tolerance == 1e-4);
  CHECK(spectrum->linear.step_of_run);
  CHECK(spectrum->amplitude == 1e-8);
  CHECK(spectrum->pulse_amplitude() == 2e-8);
  CHECK(spectrum->pulse.longest_record() == 9);
}

TEST_CASE("a former key is answered with its present place", "[spectrum]") {
  const auto [former, now] = GENERATE(table<std::string, std::string>({
      {"longest_pulse = 3", "spectrum.longest_pulse is now spectrum.pulse.longest"},
      {"pulse = 'chirp'", "spectrum.pulse is now spectrum.pulse.wave"},
      {"tolerance = 1e-3",
       "spectrum.tolerance is now spectrum.sweep.tolerance and spectrum.linear.tolerance"},
      {"linear_step = 'run'", "spectrum.linear_step is now spectrum.linear.step"},
  }));
  CHECK_THAT(refused(driven + former + "\n"), Catch::StartsWith("scene.toml:28:") &&
                                                  Catch::Contains(": " + now) &&
                                                  Catch::EndsWith("; write it there"));
}

TEST_CASE("a spectrum that cannot be measured is refused at its key", "[spectrum]") {
  refuses({"spectrum.drive='top.displacement'"}, "no boundary 'top'", "floor");
  refuses({"spectrum.drive='floor.displacment'"}, "no displacement of 'floor' named 'displacment'",
          "did you mean 'displacement'?");
  refuses({"spectrum.drive='floor.stress'"}, "no displacement of 'floor' named 'stress'", "displacement");
  refuses({"spectrum.drive='floor'"}, "'floor' names no key of a boundary", "top.displacement");
  refuses({"boundary.floor.control='stress'", "boundary.floor.area=1",
           "boundary.floor.stress={mean=1,amplitude=1,frequency_hz=1}", "spectrum.drive='floor.superposed'"},
          "'stress' of the driven boundary varies", "give it a constant");
  refuses({"spectrum.amplitude=0"}, "amplitude", "1e-100 m or more");
  refuses({"spectrum.amplitude=nan"}, "amplitude", ";");
  refuses({"spectrum.observe=[]"}, "'observe' has no columns", "strain.strain");
  refuses({"spectrum.observe=['particles.z_2']"}, "no column 'particles.z_2'",
          "did you mean 'particles.z_1'?");
  refuses({"spectrum.observe=['particles.z_1','particles.z_1']"}, "stands here twice", "remove one");
  refuses({"spectrum.relative_to_mean=['particles.x_1']"}, "no observed column 'particles.x_1'",
          "particles.z_1");
  refuses({"spectrum.shape_from='profil'"}, "no probe 'profil'", "particles");
  refuses({"spectrum.shape_from='particles'"}, "'particles' has 0 columns displacement_<n>",
          "give a probe such as profile");
  refuses({"spectrum.from_hz=50"}, "50 Hz is not below to_hz = 50 Hz", "lower frequency first");
  refuses({"spectrum.to_hz=5e4"}, "50000 Hz is not below half the sampling rate", "a shorter time.step");
  refuses({"spectrum.step_hz=1e-9"}, "frequencies are more than 100000", "larger step_hz");
  refuses({"spectrum.sweep.analysed_periods=101"}, "101 analysed periods are more than the 100",
          "fewer analysed_periods");
  refuses({"spectrum.sweep.rise_periods=41"}, "a rise of 41 periods reaches into the analysed ones",
          "fewer rise_periods");
  refuses({"spectrum.pulse.wave='chirp'", "spectrum.pulse.chirp_duration=4"},
          "the record of 3 s ends before the chirp of 4 s", "a longer pulse.longest");
  refuses({"spectrum.pulse.wave='chirp'", "spectrum.pulse.chirp_duration=1e-3"},
          "a chirp of 0.001 s has no period of to_hz = 50 Hz", "such as 10 / from_hz");
  refuses({"spectrum.from_hz=1e-300"}, "100 periods of 1e-300 Hz take", "for at most 1e+12 steps");
  refuses({"spectrum.sweep.periods=1e300"}, "1e+300 periods of",
          "or fewer sweep.periods, for at most 1e+12 steps");
  refuses({"spectrum.pulse.wave='nois'"}, "nois", "noise");
  refuses({"spectrum.pulse.wave='noise'"}, "has no 'noise_rms'", "add noise_rms");
  refuses(
      {"spectrum.pulse.wave='noise'", "spectrum.pulse.noise_rms=1e-8", "spectrum.pulse.noise_duration=1.5"},
      "noise of 1.5 s has fewer than 8 segments of 0.2 s", "a longer noise_duration");
  refuses({"spectrum.sweep.direction='left'"}, "direction", "up");
  refuses({"spectrum.sweep.adaptive=true", "spectrum.sweep.direction='both'"}, "takes each frequency once",
          "direction");
  refuses({"spectrum.linear.fewest_contacts=4294967297"}, "fewest_contacts", "from 1 to 100");
  refuses({"spectrum.zzz=1"}, "zzz", "known keys");
  for (const char* method : {"sweep", "pulse", "linear"})
    refuses({fmt::format("spectrum.{}.zzz=1", method)}, "unknown key 'zzz'", "known keys");
}

TEST_CASE("every key of [spectrum] and of its methods is declared", "[spectrum]") {
  for (const scenario::TableDescription& table : spectrum::spectrum_table().describe()) {
    CAPTURE(table.name);
    const std::string line = refused(driven, {table.name + ".zzz=1"}), opening = "known keys: ";
    REQUIRE(line.find(opening) != std::string::npos);
    std::istringstream known(line.substr(line.find(opening) + opening.size()));
    for (std::string key; std::getline(known >> std::ws, key, ',');) {
      CAPTURE(key);
      const bool is_method = key == "sweep" || key == "pulse" || key == "linear";
      CHECK((is_method || std::any_of(table.keys.begin(), table.keys.end(),
                                      [&](const auto& declared) { return declared.name == key; })));
    }
  }
}

TEST_CASE("a column that depends on all steps is not observed", "[spectrum]") {
  const std::string line =
      refused(driven + "[[probe]]\nplugin = 'mean_squared_displacement'\nname = 'path'\nwindow = 1\n",
              {"spectrum.observe=['path.total']"});
  INFO(line);
  CHECK(line.find("'path.total' depends on all steps") != std::string::npos);
}

TEST_CASE("expectations of peaks belong to the spectrum, and misspelt ones are refused", "[spectrum]") {
  const auto with_quantity = [](const std::string& quantity) {
    return driven + "[[expect]]\nrequirement = 'r'\nat_most = 1\nquantity = '" + quantity + "'\n";
  };
  const scenario::Plan plan =
      plan_with_spectrum(with_quantity("peaks.linear.particles.z_1.peak_1.frequency"));
  CHECK(plan.expectations.empty());
  CHECK(spectrum::read_spectrum(plan)->expectations.size() == 1);
  const std::string line = refused(with_quantity("peaks.linear.particles.z_1.peak_1.frequncy"));
  INFO(line);
  CHECK(line.starts_with("scene.toml:31:"));
  CHECK(line.find("did you mean 'peaks.linear.particles.z_1.peak_1.frequency'?") != std::string::npos);
}
