#include "sweep.hpp"

#include "chain.hpp"

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/sound/resonance.hpp>

using namespace scree;
using namespace scree::sound;
using namespace scree::test;

namespace {

Start start_of(const scenario::Plan& plan) { return {plan, plan.scene, run::set_up(plan)->state()}; }

RoadSpectrum sweep(const Start& start) {
  Sweep sweep(start);
  sweep.run([] {});
  return sweep.spectra().at(0);
}

constexpr const char* few = "from_hz = 100\nto_hz = 104\nstep_hz = 2\nperiods = 12\nanalysed_periods = 6\n";

}  // namespace

TEST_CASE("a sweep measures the response of the discrete chain", "[sound]") {
  const Chain chain;
  const auto detrend = GENERATE("period_average", "polynomial");
  const scenario::Plan plan =
      plan_of(chain.text("from_hz = 80\nto_hz = 95\nstep_hz = 3\nperiods = 150\nanalysed_periods = 50\n"
                         "detrend = '" +
                         std::string(detrend) + "'\n"));
  const Start start = start_of(plan);
  const RoadSpectrum road = sweep(start);
  REQUIRE(road.frequencies.size() == 6);
  for (std::size_t k = 0; k < road.frequencies.size(); ++k)
    for (const std::size_t c : {0u, 1u}) {
      CAPTURE(road.frequencies[k], c, detrend);
      // The run has the response of ω₁ = 2 sin(ωh/2)/h, off by (ωh)²/24 = 4e-5 of the frequency at most.
      const double hz =
          std::sin(std::numbers::pi * road.frequencies[k] * Chain::step) / (std::numbers::pi * Chain::step);
      const std::complex<double> exact = chain.response(c == 0 ? 1 : Chain::beads, hz);
      // Transients of a mode of width w = 3.9 Hz fall by exp(−π w t) = 5e-7 in the 100 periods before. Dampers act by predicted
      // velocities: γ h/m = 2.5e-3 of the damping, of second order at rest; (ωh)² = 9e-4 of it.
      CHECK(std::abs(road.columns[c].response[k] - exact) < 1e-3 * std::abs(exact));
    }
}

TEST_CASE("a sweep moves the bodies as if nobody looked", "[sound]") {
  const Chain chain;
  const scenario::Plan plan =
      plan_of(chain.text("from_hz = 100\nto_hz = 104\nstep_hz = 9\nperiods = 12\nanalysed_periods = 6\n"));
  const Start start = start_of(plan);
  Sweep watched(start);
  watched.run([] {});
  Scene scene = start.scene;
  set_wave(scene, start.spectrum(), watched.wave());

  Simulation alone(start.scene, start.state);
  start_wave(alone, start.spectrum(), watched.wave());
  alone.run(watched.points().at(0).steps, [] { return true; });
  CHECK(alone.state_hash() == Simulation(scene, watched.save()).state_hash());
}

TEST_CASE("a sweep that is saved and restored goes on to the same bits", "[sound]") {
  const Chain chain;
  const scenario::Plan plan = plan_of(chain.text(few));
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
    }
  CHECK(second.save().at("bodies/position") == whole.save().at("bodies/position"));
}

TEST_CASE("an adaptive sweep finds the response with a quarter of the steps", "[sound]") {
  const Chain chain;
  const std::string grid = "from_hz = 75\nto_hz = 155\nstep_hz = 0.5\n";
  const scenario::Plan plan = plan_of(chain.text(grid)),
                       adaptive = plan_of(chain.text(grid + "adaptive = true\n"));
  const Start start = start_of(plan), adaptive_start = start_of(adaptive);
  const RoadSpectrum full = sweep(start), quick = sweep(adaptive_start);
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
  const auto exact = resonances_of({full}), found = resonances_of({quick});
  REQUIRE(exact.size() == 4);
  REQUIRE(found.size() == 4);
  for (std::size_t k = 0; k < found.size(); ++k) {
    CAPTURE(k, exact[k].mode.frequency, found[k].mode.frequency);
    const double true_frequency = Chain::with_step(Chain::mode_hz(k % 2 == 0 ? 2 : 3));
    CHECK(std::abs(found[k].mode.frequency - true_frequency) <
          2 * std::abs(exact[k].mode.frequency - true_frequency) + 1e-4 * true_frequency);
  }
}

TEST_CASE("a sweep up and down has a spectrum for each direction", "[sound]") {
  const Chain chain;
  const scenario::Plan plan = plan_of(chain.text(few + std::string("direction = 'both'\n")));
  const Start start = start_of(plan);
  Sweep sweep(start);
  sweep.run([] {});
  const auto spectra = sweep.spectra();
  REQUIRE(spectra.size() == 2);
  CHECK(spectra[0].road == "sweep");
  CHECK(spectra[1].road == "sweep_down");
  CHECK(spectra[0].frequencies == spectra[1].frequencies);
  CHECK(spectra[0].columns[0].response != spectra[1].columns[0].response);
}
