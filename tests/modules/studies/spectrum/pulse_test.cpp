#include "pulse.hpp"

#include "chain.hpp"
#include "pulse_record.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/spectrum/spectrum_in_memory.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

TEST_CASE("a pulse measures the response of the discrete chain", "[spectrum]") {
  const Chain chain;
  const auto pulse = GENERATE("gaussian", "ricker", "chirp");
  const scenario::Plan plan =
      driven_plan_of(chain.text("from_hz = 20\nto_hz = 160\nstep_hz = 2\npulse.decay = 1e-6\npulse.wave = '" +
                                std::string(pulse) + "'\n"));
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  const MethodSpectrum spectrum = pulse_spectrum(start);
  CHECK(spectrum.notes.empty());
  double largest = 0;
  for (const std::complex<double>& h : spectrum.columns[1].response) largest = std::max(largest, std::abs(h));
  for (std::size_t k = 0; k < spectrum.frequencies.size(); ++k) {
    CAPTURE(spectrum.frequencies[k], pulse);
    const double hz =
        std::sin(std::numbers::pi * spectrum.frequencies[k] * Chain::step) / (std::numbers::pi * Chain::step);
    const std::complex<double> exact = chain.response(Chain::beads, hz);
    // As of a sweep; behind the record are 1e-6 of the response at most, against a drive that is 3.4 times
    // weaker at to_hz.
    CHECK(std::abs(spectrum.columns[1].response[k] - exact) < 1e-3 * std::abs(exact) + 1e-5 * largest);
    // A linear chain: what is left is round-off of a height of 0.07 m.
    CHECK(spectrum.columns[1].linearity[k] < 1e-4 * largest);
  }
}

TEST_CASE("a chirp finds the modes of the discrete chain", "[spectrum]") {
  const Chain chain = {.damping = 0.02};
  const scenario::Plan plan = driven_plan_of(chain.text(
      "from_hz = 20\nto_hz = 160\nstep_hz = 0.25\npulse.decay = 1e-6\npulse.wave = 'chirp'\npulse.chirp_duration = 0.5\n"));
  const InMemorySpectrum measured = spectrum_in_memory(plan, *read_spectrum(plan), {Method::pulse}, nullptr);
  CHECK(measured.spectra[0].notes.empty());
  std::vector<double> found;
  for (const Peak& r : measured.peaks)
    if (r.column == 1) found.push_back(r.mode.frequency);
  REQUIRE(found.size() == 3);
  for (int j = 1; j <= 3; ++j) {
    const double exact = Chain::with_step(Chain::mode_hz(j));
    CAPTURE(j, found[std::size_t(j - 1)], exact);
    // The fit of a peak leaves 1e-5 of the other modes.
    CHECK(std::abs(found[std::size_t(j - 1)] / exact - 1) < 1e-4);
  }
  // Stationary phase: the sum of a linear chirp is A sqrt(T/(4 (f1 - f0))) within its band, with ripples of
  // the edges.
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  const DrivenWalls walls(start);
  PulseRecord undriven(start, walls, 0, nullptr), driven(start, walls, 1e-8, &undriven);
  REQUIRE(driven.until_samples(std::size_t(0.6 * 160 * 50)));
  CHECK(std::abs(driven.drive_at(90)) / 1e-8 == Approx(std::sqrt(0.5 / (4 * 160))).epsilon(0.2));
}

TEST_CASE("noise measures the response and the modes of the discrete chain within its errors", "[spectrum]") {
  const Chain chain = {.damping = 0.05, .drag = 0.03};
  const scenario::Plan plan = driven_plan_of(chain.text(
      "from_hz = 20\nto_hz = 160\nstep_hz = 1\npulse.wave = 'noise'\npulse.noise_rms = 1e-8\npulse.noise_duration = 30\n"));
  const InMemorySpectrum measured = spectrum_in_memory(plan, *read_spectrum(plan), {Method::pulse}, nullptr);
  const MethodSpectrum& spectrum = measured.spectra[0];
  REQUIRE(spectrum.frequencies.size() == 141);
  int covered = 0, cases = 0;
  double largest = 0;
  for (std::size_t k = 0; k < spectrum.frequencies.size(); ++k) {
    const double hz =
        std::sin(std::numbers::pi * spectrum.frequencies[k] * Chain::step) / (std::numbers::pi * Chain::step);
    const std::complex<double> exact = chain.response(Chain::beads, hz), h = spectrum.columns[1].response[k];
    const double error = spectrum.columns[1].error[k];
    CHECK(std::abs(h - exact) < 5 * error);
    covered += std::abs(std::abs(h) - std::abs(exact)) < error, ++cases;
    largest = std::max(largest, error / std::abs(exact));
    CHECK(spectrum.columns[1].linearity[k] <
          1e-4 * std::abs(exact));  // a linear chain: round-off of a height of 0.07 m
  }
  CHECK(double(covered) / cases == Approx(0.68).margin(0.05 + 0.04));  // the share of 141 is known to 0.04
  CHECK(largest < 0.03);
  std::vector<signals::FittedMode> found;
  for (const Peak& r : measured.peaks)
    if (r.column == 1) found.push_back(r.mode);
  REQUIRE(found.size() == 3);
  for (int j = 1; j <= 3; ++j) {
    const signals::FittedMode& mode = found[std::size_t(j - 1)];
    const double exact = Chain::with_step(Chain::mode_hz(j));
    CAPTURE(j, mode.frequency, mode.frequency_error, exact);
    CHECK(std::abs(mode.frequency - exact) < 4 * mode.frequency_error);
    CHECK(mode.frequency_error < 2e-3 * exact);
  }
}

TEST_CASE("a packing that is not at rest answers a pulse as one at rest", "[spectrum]") {
  const Chain chain;
  const std::string text = chain.text("from_hz = 80\nto_hz = 100\nstep_hz = 5\npulse.decay = 1e-6\n");
  std::vector<MethodSpectrum> spectra;
  // A bead that begins with 1e-4 m/s swings by up to 1e-4 m/s/(2 pi 29 Hz) = 5e-7 m, fifty times the pulse.
  for (const char* start : {"id = 3\n", "id = 3\nvelocity = [0, 0, 1e-4]\n"}) {
    const scenario::Plan plan = driven_plan_of(with(text, "id = 3\n", start));
    spectra.push_back(pulse_spectrum({plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()}));
  }
  for (std::size_t k = 0; k < spectra[0].frequencies.size(); ++k)
    // Both decay to 1e-6; round-off of heights is 1e-17/1e-8 of the response.
    CHECK(std::abs(spectra[0].columns[1].response[k] - spectra[1].columns[1].response[k]) <
          1e-5 * std::abs(spectra[0].columns[1].response[k]));
}

TEST_CASE("a pulse that has not decayed is noted with its bound", "[spectrum]") {
  const Chain chain;
  const scenario::Plan plan =
      driven_plan_of(chain.text("from_hz = 20\nto_hz = 160\nstep_hz = 2\npulse.longest = 0.5\n"));
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  const MethodSpectrum spectrum = pulse_spectrum(start);
  REQUIRE(spectrum.notes.size() == 2);
  CHECK(spectrum.notes[1].find("particles.z_8 has not decayed") != std::string::npos);
  CHECK(spectrum.notes[1].find("give a longer pulse.longest") != std::string::npos);
  // The error that it states holds.
  for (std::size_t k = 0; k < spectrum.frequencies.size(); ++k) {
    const double hz =
        std::sin(std::numbers::pi * spectrum.frequencies[k] * Chain::step) / (std::numbers::pi * Chain::step);
    CAPTURE(spectrum.frequencies[k]);
    CHECK(std::abs(spectrum.columns[1].response[k] - chain.response(Chain::beads, hz)) <
          spectrum.columns[1].error[k]);
  }
}

TEST_CASE("a pulse too high for a linear response is noted with the change at half its amplitude",
          "[spectrum]") {
  const Chain chain;
  // The top bead is pressed by 1e-5 m: a pulse of 1e-3 m opens contacts, one of 1e-8 m does not.
  const char* amplitude = GENERATE("1e-8", "1e-3");
  const scenario::Plan plan =
      driven_plan_of(with(chain.text("from_hz = 20\nto_hz = 160\nstep_hz = 2\n"), "amplitude = 1e-8",
                          "amplitude = " + std::string(amplitude)));
  const MethodSpectrum spectrum =
      pulse_spectrum({plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()});
  CAPTURE(amplitude, spectrum.notes);
  if (std::string(amplitude) == "1e-8") {
    CHECK(spectrum.notes.empty());
    return;
  }
  REQUIRE(spectrum.notes.size() == 2);  // of z_1 and z_8
  CHECK(spectrum.notes[1].starts_with(
      "pulse: at half the amplitude of 0.001 m the response of particles.z_8 changes by"));
  CHECK(spectrum.notes[1].ends_with("; give a lower spectrum.amplitude"));
}

TEST_CASE("a pulse into a packing that is not at rest is warned of", "[spectrum]") {
  std::string text =
      Chain().text("from_hz = 20\nto_hz = 160\nstep_hz = 10\npulse.decay = 1e-2\npulse.longest = 0.2\n");
  // A fifth more than the contacts bear.
  const std::string gravity = "[0, 0, -10]";
  text.replace(text.find(gravity), gravity.size(), "[0, 0, -12]");
  const scenario::Plan plan = driven_plan_of(text);
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  const MethodSpectrum spectrum = pulse_spectrum(start);
  REQUIRE_FALSE(spectrum.notes.empty());
  const auto note = std::find_if(spectrum.notes.begin(), spectrum.notes.end(), [](const std::string& line) {
    return line.starts_with("pulse: without the pulse particles.z_8 changes by ");
  });
  REQUIRE(note != spectrum.notes.end());
  CHECK_THAT(*note, Catch::Contains("the packing is not at rest; let it come to rest in a stage before"));
}
