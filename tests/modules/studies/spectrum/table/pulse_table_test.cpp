#include "table_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("a chirp has ten periods of the lowest frequency, and a record thirty steps of the grid",
          "[spectrum]") {
  const spectrum::PulseSettings pulse = spectrum::read_spectrum(plan_with_spectrum(driven))->pulse;
  CHECK(pulse.chirp_duration == Approx(10.0 / 10));
  CHECK(pulse.longest_record() == Approx(30.0 / 10));
  CHECK(pulse.form == spectrum::PulseSettings::Form::gaussian);
}

TEST_CASE("a chirp without a period of the band, or longer than its record, is refused at its key",
          "[spectrum]") {
  const std::string chirp = driven + "[spectrum.pulse]\nwave = 'chirp'\n";  // 28, 29
  // 50 Hz is the highest frequency.
  CHECK_THAT(refused(chirp + "chirp_duration = 0.01\n"),
             Catch::StartsWith("scene.toml:30:18: a chirp of 0.01 s has no period of to_hz = 50 Hz; "));
  CHECK_THAT(refused(chirp + "longest = 0.5\n"),
             Catch::StartsWith("scene.toml:30:11: the record of 0.5 s ends before the chirp of 1 s; "));
}
