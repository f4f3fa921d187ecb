#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const std::string driven =
    "[time]\nstep = 1e-5\n[[material]]\nname = 'grain'\ndensity = 1000\n"                          // 1 to 5
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e3\nnormal_damping = 0\n"  // 6 to 9
    "[[particle]]\nposition = [0, 0, 0.01]\nradius = 0.01\n"                                       // 10 to 12
    "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"      // 13 to 17
    "[[probe]]\nplugin = 'particles'\nids = [1]\n"                                                 // 18 to 20
    "[spectrum]\ndrive = 'floor.displacement'\namplitude = 1e-8\nobserve = ['particles.z_1']\n"    // 21 to 24
    "from_hz = 10\nto_hz = 50\nstep_hz = 10\n";                                                    // 25 to 27

void refuses(const std::vector<std::string>& overrides, const std::string& problem, const std::string& cure) {
  const std::string line = refusal(driven, overrides);
  CAPTURE(line, problem, cure);
  CHECK(line.find(problem) != std::string::npos);
  CHECK(line.find(cure) != std::string::npos);
}

}  // namespace

TEST_CASE("a spectrum is read with its grid, drive and columns, and needs no stages", "[scenario]") {
  const scenario::Plan plan = plan_of(driven, {"spectrum.relative_to_mean=['particles.z_1']"});
  CHECK(plan.stages.empty());
  REQUIRE(plan.spectrum);
  CHECK(plan.spectrum->frequencies() == std::vector<double>{10, 20, 30, 40, 50});
  CHECK(plan.spectrum->boundary == "floor");
  CHECK(plan.spectrum->key == "displacement");
  REQUIRE(plan.spectrum->observed.size() == 1);
  CHECK(plan.spectrum->observed[0].relative);
  CHECK(plan.spectrum->observed[0].unit == "m");
  CHECK(plan.spectrum->observed[0].column == 2);
  CHECK(plan.spectrum->longest_pulse == 3);
}

TEST_CASE("a grid whose steps do not add up to its end stops before it", "[scenario]") {
  CHECK(plan_of(driven, {"spectrum.to_hz=49"}).spectrum->frequencies() ==
        std::vector<double>{10, 20, 30, 40});
}

TEST_CASE("a spectrum that cannot be measured is refused at its key", "[scenario]") {
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
  refuses({"spectrum.analysed_periods=101"}, "101 analysed periods are more than the 100",
          "fewer analysed_periods");
  refuses({"spectrum.rise_periods=41"}, "a rise of 41 periods reaches into the analysed ones",
          "fewer rise_periods");
  refuses({"spectrum.pulse='chirp'", "spectrum.chirp_duration=4"},
          "the record of 3 s ends before the chirp of 4 s", "a longer longest_pulse");
  refuses({"spectrum.pulse='chirp'", "spectrum.chirp_duration=1e-3"},
          "a chirp of 0.001 s has no period of to_hz = 50 Hz", "such as 10 / from_hz");
  refuses({"spectrum.from_hz=1e-300"}, "100 periods of 1e-300 Hz take", "for at most 1e+12 steps");
  refuses({"spectrum.periods=1e300"}, "1e+300 periods of", "or fewer periods, for at most 1e+12 steps");
  refuses({"spectrum.pulse='nois'"}, "nois", "noise");
  refuses({"spectrum.pulse='noise'", "spectrum.longest_pulse=1.5"},
          "noise of 1.5 s has fewer than 8 segments of 0.2 s", "a longer longest_pulse");
  refuses({"spectrum.direction='left'"}, "direction", "up");
  refuses({"spectrum.adaptive=true", "spectrum.direction='both'"}, "takes each frequency once", "direction");
  refuses({"spectrum.fewest_contacts=4294967297"}, "fewest_contacts", "from 1 to 100");
  refuses({"spectrum.zzz=1"}, "zzz", "known keys");
}

TEST_CASE("a column that depends on all steps is not observed", "[scenario]") {
  const std::string line =
      refusal(driven + "[[probe]]\nplugin = 'mean_squared_displacement'\nname = 'path'\nwindow = 1\n",
              {"spectrum.observe=['path.total']"});
  INFO(line);
  CHECK(line.find("'path.total' depends on all steps") != std::string::npos);
}

TEST_CASE("expectations of peaks belong to the spectrum, and misspelt ones are refused", "[scenario]") {
  const auto with_quantity = [](const std::string& quantity) {
    return driven + "[[expect]]\nrequirement = 'r'\nat_most = 1\nquantity = '" + quantity + "'\n";
  };
  const scenario::Plan plan = plan_of(with_quantity("peaks.linear.particles.z_1.peak_1.frequency"));
  CHECK(plan.expectations.empty());
  CHECK(plan.peak_expectations.size() == 1);
  const std::string line = refusal(with_quantity("peaks.linear.particles.z_1.peak_1.frequncy"));
  INFO(line);
  CHECK(line.starts_with("scene.toml:31:"));
  CHECK(line.find("did you mean 'peaks.linear.particles.z_1.peak_1.frequency'?") != std::string::npos);
}
