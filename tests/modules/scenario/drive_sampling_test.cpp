#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// With a step of 1e-5 s, half the sampling rate is 50 kHz.
const std::string shaken =
    "[time]\nstep = 1e-5\nduration = 1e-3\n[[material]]\nname = 'grain'\ndensity = 1000\n"
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e3\nnormal_damping = 0\n"
    "[[particle]]\nposition = [0, 0, 0.01]\nradius = 0.01\n"
    "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\ndisplacement = ";

std::vector<std::string> warnings_of(const std::string& drive) {
  return plan_of(shaken + drive + "\n").warnings;
}

}  // namespace

TEST_CASE("drives that steps do not sample are warned of, others not", "[scenario]") {
  const auto [below, beyond] = GENERATE(table<std::string, std::string>({
      {"{ amplitude = 1e-8, frequency_hz = 49e3 }", "{ amplitude = 1e-8, frequency_hz = 51e3 }"},
      {"{ from = 0, to = 1e-8, period = 2.1e-5 }", "{ from = 0, to = 1e-8, period = 1.9e-5 }"},
      {"{ wave = 'sine', amplitude = 1e-8, frequency_hz = 49e3 }",
       "{ wave = 'sine', amplitude = 1e-8, frequency_hz = 51e3 }"},
      {"{ wave = 'chirp', amplitude = 1e-8, from_hz = 49e3, to_hz = 1e3, duration = 1e-3 }",
       "{ wave = 'chirp', amplitude = 1e-8, from_hz = 51e3, to_hz = 1e3, duration = 1e-3 }"},
      {"{ wave = 'sweep', amplitude = 1e-8, from_hz = 1e3, to_hz = 49e3, step_hz = 24e3, periods = 2 }",
       "{ wave = 'sweep', amplitude = 1e-8, from_hz = 1e3, to_hz = 51e3, step_hz = 25e3, periods = 2 }"},
      // 1/(2π width) is 50 kHz at 3.18e-6 s.
      {"{ wave = 'gaussian', amplitude = 1e-8, at = 1e-4, width = 3.3e-6 }",
       "{ wave = 'gaussian', amplitude = 1e-8, at = 1e-4, width = 3.1e-6 }"},
      {"{ wave = 'ricker', amplitude = 1e-8, at = 1e-4, frequency_hz = 49e3 }",
       "{ wave = 'ricker', amplitude = 1e-8, at = 1e-4, frequency_hz = 51e3 }"},
      // The highest of ten sines lies half their distance below the end of the band.
      {"{ wave = 'noise', rms = 1e-8, low_hz = 1e3, high_hz = 51e3, sines = 10 }",
       "{ wave = 'noise', rms = 1e-8, low_hz = 1e3, high_hz = 54e3, sines = 10 }"},
  }));
  CAPTURE(below, beyond);
  CHECK(warnings_of(below).empty());
  const std::vector<std::string> lines = warnings_of(beyond);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].find(": 'displacement' of 'floor': ") != std::string::npos);
  CHECK(lines[0].ends_with(
      " Hz is not below half the sampling rate of a sample per step, 50000 Hz; give a lower "
      "frequency, or a shorter time.step"));
}

TEST_CASE("drives of stages are looked at too, and each is named once", "[scenario]") {
  const std::string stage =
      "[[stage]]\nduration = 1e-3\nset.floor.displacement = { amplitude = 1e-8, frequency_hz = 51e3 }\n";
  const std::string still = shaken + "0\n";
  CHECK(plan_of(with(still, "duration = 1e-3\n", "") + stage + stage).warnings.size() == 1);
  CHECK(plan_of(still).warnings.empty());
}

TEST_CASE("functions of groups are looked at too", "[scenario]") {
  const std::string key = GENERATE("velocity", "displacement", "force", "spin", "torque");
  const auto moved = [&](const char* hz) {
    return shaken + "0\n[[group]]\nname = 'shaker'\nwhere.ids = [1]\nfixed = true\n" + key +
           " = [0, { amplitude = 1e-8, frequency_hz = " + hz + " }, 0]\n";
  };
  CHECK(plan_of(moved("49e3")).warnings.empty());
  REQUIRE(plan_of(moved("51e3")).warnings.size() == 1);
  CHECK_THAT(plan_of(moved("51e3")).warnings[0],
             Catch::Contains(": '" + key + "' of 'shaker': 51000 Hz is not below half the sampling rate"));
}
