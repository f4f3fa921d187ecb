#include "sweep.hpp"

#include "bench.hpp"
#include "pulse.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/spectrum/peak.hpp>
#include <scree/spectrum/spectrum_in_memory.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

namespace {

Start start_of(const scenario::Plan& plan) {
  return {plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
}

MethodSpectrum sweep(const Start& start) {
  Sweep sweep(start);
  sweep.run([] {});
  return sweep.spectra().at(0);
}

constexpr const char* few_points =
    "from_hz = 101\nto_hz = 105\nstep_hz = 2\nsweep.periods = 12\nsweep.analysed_periods = 6\n";

}  // namespace

TEST_CASE("a sweep measures the response of the discrete chain", "[spectrum]") {
  const Chain chain;
  const auto detrend = GENERATE("period_average", "polynomial");
  const scenario::Plan plan = driven_plan_of(
      chain.text("from_hz = 80\nto_hz = 95\nstep_hz = 3\nsweep.periods = 150\nsweep.analysed_periods = 50\n"
                 "sweep.detrend = '" +
                 std::string(detrend) + "'\n"));
  const Start start = start_of(plan);
  const MethodSpectrum spectrum = sweep(start);
  REQUIRE(spectrum.frequencies.size() == 6);
  for (std::size_t k = 0; k < spectrum.frequencies.size(); ++k)
    for (const std::size_t c : {0u, 1u}) {
      CAPTURE(spectrum.frequencies[k], c, detrend);
      // The run has the response of ω₁ = 2 sin(ωh/2)/h, off by (ωh)²/24 = 4e-5 of the frequency at most.
      const double hz = std::sin(std::numbers::pi * spectrum.frequencies[k] * Chain::step) /
                        (std::numbers::pi * Chain::step);
      const std::complex<double> exact = chain.response(c == 0 ? 1 : Chain::beads, hz);
      // Transients of a mode of width w = 3.9 Hz fall by exp(−π w t) = 5e-7 in the 100 periods before.
      // Dampers act by predicted velocities: γ h/m = 2.5e-3 of the damping, of second order at rest; (ωh)² =
      // 9e-4 of it.
      CHECK(std::abs(spectrum.columns[c].response[k] - exact) < 1e-3 * std::abs(exact));
    }
}

TEST_CASE("the samples of a sweep do not change the motion", "[spectrum]") {
  const Chain chain;
  const scenario::Plan plan = driven_plan_of(chain.text(
      "from_hz = 100\nto_hz = 104\nstep_hz = 9\nsweep.periods = 12\nsweep.analysed_periods = 6\n"));
  const Start start = start_of(plan);
  Sweep watched(start);
  watched.run([] {});
  Scene scene = start.scene;
  set_wave(scene, start.spectrum, watched.wave());

  Simulation alone(start.scene, start.state);
  start_wave(alone, start.spectrum, watched.wave());
  alone.run(watched.points().at(0).steps, [] { return true; });
  CHECK(alone.state_hash() == Simulation(scene, watched.save()).state_hash());
}

TEST_CASE("the driven wall moves on without a jump where the frequency changes", "[spectrum]") {
  const Chain chain;
  const scenario::Plan plan = driven_plan_of(chain.text(few_points));
  const Start start = start_of(plan);
  Sweep sweep(start);
  sweep.run([] {});
  const SweepPoint& last = sweep.points().at(2);
  const State state = sweep.save();
  Scene scene = start.scene;
  set_wave(scene, start.spectrum, sweep.wave());
  const double phase =
      sweep.wave()[5] + 2 * std::numbers::pi * last.frequency * double(last.steps) * Chain::step;
  // Sums of 6e3 increments of up to 3e-10 m, rounded to 1e-24 m each.
  CHECK(std::abs(Simulation(scene, state).planes()[0].point[2] - 1e-8 * std::sin(phase)) < 1e-18);
}

TEST_CASE("a sweep that is saved and restored goes on to the same bits", "[spectrum]") {
  const Chain chain;
  // A layer keeps where its bodies were at the start.
  const scenario::Plan plan =
      driven_plan_of(with(chain.text(few_points), "'particles.z_1'", "'layer.displacement'") +
                     "[[probe]]\nplugin = 'layer'\naxis = 'z'\nat = 0.035\nhalf_width = 0.01\n");
  const Start start = start_of(plan);
  Sweep whole(start);
  whole.run([] {});

  std::atomic<bool> stop = false;
  Start stopped = start_of(plan);
  stopped.stop = &stop;
  Sweep first(stopped);
  std::optional<State> saved;
  first.run([&] {
    saved = first.save();
    stop = true;
  });
  REQUIRE(first.points().size() == 1);
  stop = false;
  Sweep second(stopped, *saved);
  second.run([] {});
  REQUIRE(second.points().size() == 3);
  for (std::size_t k = 0; k < 3; ++k)
    for (const std::size_t c : {0u, 1u}) {
      CHECK(second.points()[k].columns[c].response == whole.points()[k].columns[c].response);
      CHECK(second.points()[k].columns[c].error == whole.points()[k].columns[c].error);
      CHECK(second.points()[k].columns[c].mean == whole.points()[k].columns[c].mean);
    }
  CHECK(second.save().at("bodies/position") == whole.save().at("bodies/position"));
}

TEST_CASE("an adaptive sweep finds the response with a quarter of the steps", "[spectrum]") {
  const Chain chain;
  const std::string grid = "from_hz = 75\nto_hz = 155\nstep_hz = 0.5\n";
  const scenario::Plan plan = driven_plan_of(chain.text(grid)),
                       adaptive = driven_plan_of(chain.text(grid + "sweep.adaptive = true\n"));
  const Start start = start_of(plan), adaptive_start = start_of(adaptive);
  const MethodSpectrum full = sweep(start), quick = sweep(adaptive_start);
  CHECK(quick.notes.empty());
  CHECK(4 * quick.steps < full.steps);
  for (std::size_t k = 0; k < quick.frequencies.size(); ++k) {
    const double hz =
        std::sin(std::numbers::pi * quick.frequencies[k] * Chain::step) / (std::numbers::pi * Chain::step);
    CAPTURE(quick.frequencies[k]);
    // The tolerance of 1e-3, and γ h/m = 2.5e-3 of the damping by contacts, which is most of it at the peak.
    CHECK(std::abs(quick.columns[1].response[k] - chain.response(Chain::beads, hz)) <
          3.5e-3 * std::abs(quick.columns[1].response[k]));
  }
  const auto exact = peaks_in({full}, read_spectrum(plan)->observed),
             found = peaks_in({quick}, read_spectrum(plan)->observed);
  REQUIRE(exact.size() == 4);
  REQUIRE(found.size() == 4);
  for (std::size_t k = 0; k < found.size(); ++k) {
    CAPTURE(k, exact[k].mode.frequency, found[k].mode.frequency, found[k].mode.frequency_error);
    const double true_frequency = Chain::with_step(Chain::mode_hz(k % 2 == 0 ? 2 : 3));
    // Three stated errors, which are a hundredth of the width or less.
    CHECK(std::abs(found[k].mode.frequency - true_frequency) <
          3 * found[k].mode.frequency_error + 1e-4 * true_frequency);
    CHECK(found[k].mode.frequency_error < 0.01 * found[k].mode.width);
  }
}

TEST_CASE("layers of shapes change neither the steps of an adaptive sweep nor those of a pulse",
          "[spectrum]") {
  const std::string keys = "from_hz = 75\nto_hz = 100\nstep_hz = 0.5\nsweep.adaptive = true\n";
  std::vector<std::uint64_t> steps, of_pulse;
  for (const char* shape : {"", "shape_from = 'profile'\n"}) {
    const scenario::Plan plan = driven_plan_of(Chain().text(keys + shape) + Chain::layers);
    steps.push_back(sweep(start_of(plan)).steps);
    of_pulse.push_back(pulse_spectrum(start_of(plan)).steps);
  }
  CHECK(steps[0] == steps[1]);
  CHECK(of_pulse[0] == of_pulse[1]);
}

TEST_CASE("a sweep up and down has a spectrum for each direction", "[spectrum]") {
  const Chain chain;
  const scenario::Plan plan =
      driven_plan_of(chain.text(few_points + std::string("sweep.direction = 'both'\n")));
  const Start start = start_of(plan);
  Sweep sweep(start);
  sweep.run([] {});
  const auto spectra = sweep.spectra();
  REQUIRE(spectra.size() == 2);
  CHECK(spectra[0].method == "sweep");
  CHECK(spectra[1].method == "sweep_down");
  CHECK(spectra[0].frequencies == spectra[1].frequencies);
  CHECK(spectra[0].columns[0].response != spectra[1].columns[0].response);
}

TEST_CASE("a column that the wave does not reach is noted by pulse and sweep", "[spectrum]") {
  // Beads on one axis do not move sideways.
  const scenario::Plan plan =
      driven_plan_of(with(Chain().text(few_points), "'particles.z_8']", "'particles.z_8', 'particles.x_8']"));
  for (const MethodSpectrum& spectrum : {sweep(start_of(plan)), pulse_spectrum(start_of(plan))}) {
    const auto noted = std::count_if(
        spectrum.notes.begin(), spectrum.notes.end(),
        [](const std::string& note) { return note.find("the wave does not reach ") != std::string::npos; });
    CAPTURE(spectrum.method, spectrum.notes);
    CHECK(noted == 1);
    CHECK(
        std::count(spectrum.notes.begin(), spectrum.notes.end(),
                   spectrum.method +
                       ": the wave does not reach particles.x_8, which is 0 at all frequencies; compress the "
                       "packing, observe another column, or give a larger spectrum.amplitude") == 1);
  }
}

TEST_CASE("a sweep whose periods are too few for a steady response says so", "[spectrum]") {
  const auto notes = [](const std::string& periods) {
    const scenario::Plan plan =
        driven_plan_of(Chain().text("from_hz = 100\nto_hz = 140\nstep_hz = 40\n" + periods));
    return spectrum_in_memory(plan, *read_spectrum(plan), {Method::sweep}, nullptr).spectra.at(0).notes;
  };
  // Modes of the chain decay by exp(−(drag/m + ω² damping/k) t/2), at 100 Hz by a half in 5 periods.
  CHECK(notes("sweep.periods = 100\nsweep.analysed_periods = 60\n").empty());
  const std::vector<std::string> few =
      notes("sweep.periods = 10\nsweep.analysed_periods = 6\nsweep.rise_periods = 2\n");
  REQUIRE(few.size() == 1);
  CHECK(few[0].starts_with("sweep: at 2 of 2 frequencies the response was not steady after 10 periods"));
  CHECK(few[0].ends_with("; give a larger spectrum.sweep.tolerance or more spectrum.sweep.periods"));
}

TEST_CASE("an interrupted sweep goes on to the same table", "[spectrum]") {
  const std::string text = Chain().text(
      "from_hz = 100\nto_hz = 110\nstep_hz = 2\nsweep.periods = 12\nsweep.analysed_periods = 6\n");
  Bench whole(text), parted(text);
  whole.options.methods = parted.options.methods = {Method::sweep};
  measure(whole.plan, whole.options);

  std::atomic<bool> stop = false;
  parted.options.stop = &stop;
  int reports = 0;
  parted.options.on_progress = [&](double share, double, const std::string&) {
    stop = share > 0 && ++reports >= 1;
  };
  const Measurement first = measure(parted.plan, parted.options);
  REQUIRE(first.interrupted);
  REQUIRE(first.spectra.at(0).frequencies.size() < 6);
  stop = false;
  parted.options.on_progress = {};
  const Measurement second = resume_measurement(parted.options, host());
  CHECK(!second.interrupted);
  CHECK(parted.text("sweep.csv") == whole.text("sweep.csv"));
  CHECK(parted.text("spectrum.csv") == whole.text("spectrum.csv"));
  CHECK(message([&] { resume_measurement(parted.options, host()); }).find("the spectrum is finished") !=
        std::string::npos);
}
