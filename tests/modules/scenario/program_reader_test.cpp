#include "plan_support.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/plugin/program.hpp>

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

// The displacement of a wall with a function of time.
std::string scene_with_program(const std::string& program) {
  std::string text = discs;
  text +=
      "[[boundary]]\nplugin = 'plane'\nname = 'driven'\npoint = [0, -5]\nnormal = [0, 1]\ndisplacement = ";
  text += program;
  return text += '\n';
}

double displacement_at(const std::string& program, double time) {
  const scenario::Plan plan = plan_of(scene_with_program(program));
  for (const Scene::Boundary& boundary : plan.scene.boundaries)
    if (boundary.name == "driven") {
      const auto values = boundary.parameters.values();
      for (std::uint32_t k = 0; k < boundary.parameters.plugin().parameter_count; ++k)
        if (boundary.parameters.plugin().parameters[k].key == std::string("displacement"))
          return Program(values[k])(time);
    }
  return NAN;
}

}  // namespace

TEST_CASE("waves are read with their keys") {
  CHECK(displacement_at("{ wave = 'sine', amplitude = 2, frequency_hz = 10 }", 0.025) == Approx(2));
  CHECK(displacement_at("{ wave = 'sine', amplitude = 2, frequency_hz = 10, mean = 1, phase_deg = 90 }",
                        0.1) == Approx(3));
  CHECK(displacement_at("{ wave = 'sine', amplitude = 2, frequency_hz = 10, rise = 0.05 }", 0.025) ==
        Approx(1));
  CHECK(displacement_at("{ wave = 'gaussian', amplitude = 2, at = 0.1, width = 0.01 }", 0.1) == 2);
  CHECK(displacement_at("{ wave = 'ricker', amplitude = 2, at = 0.1, frequency_hz = 50 }", 0.1) == 2);
  CHECK(displacement_at("{ wave = 'chirp', amplitude = 2, from_hz = 10, to_hz = 30, duration = 1 }", 0.5) ==
        Approx(2 * std::sin(2 * pi * (5 + 2.5))).margin(1e-9));
}

TEST_CASE("a sweep holds each frequency for whole periods, in both directions") {
  const std::string up =
      "{ wave = 'sweep', amplitude = 1, from_hz = 10, to_hz = 20, step_hz = 5, periods = 2 }";
  // 10 Hz for 0.2 s, 15 Hz for 2/15 s, 20 Hz for 0.1 s.
  CHECK(displacement_at(up, 0.025) == Approx(1));
  CHECK(displacement_at(up, 0.2 + 0.25 / 15) == Approx(1));
  CHECK(displacement_at(up, 0.2 + 2.0 / 15 + 0.25 / 20) == Approx(1));
  CHECK(displacement_at(up, 0.2 + 2.0 / 15 + 0.1 + 0.01) == 0);
  const std::string down =
      "{ wave = 'sweep', amplitude = 1, from_hz = 20, to_hz = 10, step_hz = 5, periods = 2 }";
  CHECK(displacement_at(down, 0.25 / 20) == Approx(1));
  CHECK(displacement_at(down, 0.1 + 0.25 / 15) == Approx(1));
}

TEST_CASE("noise has its root mean square and depends on its seed") {
  const auto noise = [](int seed) {
    return "{ wave = 'noise', rms = 3, low_hz = 100, high_hz = 200, sines = 32, seed = " +
           std::to_string(seed) + " }";
  };
  CHECK(displacement_at(noise(1), 0.1) == displacement_at(noise(1), 0.1));
  CHECK(displacement_at(noise(1), 0.1) != displacement_at(noise(2), 0.1));
  // Over the time 1/spacing the sines are orthogonal, so that the mean square is exact but for the sampling.
  const scenario::Plan plan = plan_of(scene_with_program(noise(1)));
  const auto values = plan.scene.boundaries.back().parameters.values();
  double square = 0;
  constexpr int samples = 3200;
  for (const scree_value& value : values)
    if (value.count > 6)
      for (int k = 0; k < samples; ++k) {
        const double x = Program(value)(k * 32.0 / 100 / samples);
        square += x * x / samples;
      }
  CHECK(std::sqrt(square) == Approx(3).epsilon(1e-9));
}

TEST_CASE("wrong waves are refused at their key") {
  const auto refused = [](const std::string& program) { return refusal(scene_with_program(program)); };
  CHECK_THAT(refused("{ wave = 'sin', amplitude = 1, frequency_hz = 1 }"),
             Catch::Matchers::Contains("'sine'"));
  CHECK_THAT(refused("{ wave = 'sine', amplitude = 1 }"), Catch::Matchers::Contains("frequency_hz"));
  CHECK_THAT(refused("{ wave = 'sweep', amplitude = 1, from_hz = 1, to_hz = 2, step_hz = 1, periods = 1.5 }"),
             Catch::Matchers::Contains("not a whole number"));
  CHECK_THAT(refused("{ wave = 'sweep', amplitude = 1, from_hz = 1, to_hz = 1e9, step_hz = 1, periods = 1 }"),
             Catch::Matchers::Contains("larger step_hz"));
  CHECK_THAT(refused("{ wave = 'noise', rms = 1, low_hz = 3, high_hz = 2 }"),
             Catch::Matchers::Contains("band is empty"));
  CHECK_THAT(refused("{ wave = 'gaussian', amplitude = 1, at = 1, width = 0 }"),
             Catch::Matchers::Contains("width"));
  CHECK_THAT(refused("{ wave = 'sine', amplitude = 1, frequency_hz = 1, at = 2 }"),
             Catch::Matchers::Contains("at"));
}

TEST_CASE("keys of two functions of time are refused together", "[scenario]") {
  const auto motion = [](const std::string& keys) {
    return refusal(with(discs, "gap = 0.005", "gap = 0.005\nstress = " + keys));
  };
  const std::string line = motion("{ from = 0, to = 1, duration = 1, period = 2 }");
  INFO(line);
  CHECK(line.find("'period' and 'duration' belong to different functions of time; keep one: period (") !=
        std::string::npos);
}
