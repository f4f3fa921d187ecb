#include "layer_support.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/plugin/program.hpp>

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

constexpr double wall_amplitude = 0.003, wall_frequency = 4, wall_phase = 0.7, shaken_step = 1e-3;
constexpr int steps_per_sample = 5, steps_per_period = 250;
// Positions are rounded at 1 m, here in each of up to 2500 steps that are summed.
constexpr double summed_rounding = 2500 * 2.2e-16;

// A wall that oscillates along x about x = −1 m.
Simulation shaken() {
  Scene s = scene(3, shaken_step, {body(1, 0.01, 1, {{0, 0, 0}})},
                  {{"normal_stiffness", {5000}}, {"normal_damping", {0}}});
  add_boundary(s, "plane",
               {{"point", {-1 + wall_amplitude * std::sin(wall_phase), 0, 0}},
                {"normal", {1, 0, 0}},
                {"displacement", {Program::sine, 0, wall_amplitude, wall_frequency, wall_phase}}});
  return Simulation(s);
}

Parameters lock_in(const Values& values) {
  Parameters p = parameters("lock_in", SCREE_PROBE, values);
  p.set_input("of", "wall.x", "m");
  return p;
}

// What the wall shows at a time.
using Signal = std::function<double(double wall, double time)>;

double as_it_is(double wall, double) { return wall; }

void observe(Probe& probe, Simulation& s, int steps, const Signal& signal) {
  for (int k = 0; k < steps; ++k) {
    if (s.steps() % steps_per_sample == 0) {
      const SimulationView view(s, 0);
      const double value = signal(view.get().planes[0].point[0], s.time());
      probe.observe(view.get(), std::span(&value, 1));
    }
    s.step();
  }
}

Sampled row_of(Probe& probe, const Simulation& s) {
  return {probe.names(), probe.sample(SimulationView(s, 0).get())};
}

// The row after so many periods.
Sampled measured(const Values& values, int periods, const Signal& signal = as_it_is) {
  Simulation s = shaken();
  Probe probe(lock_in(values), 3);
  observe(probe, s, periods * steps_per_period, signal);
  return row_of(probe, s);
}

const Values eight_periods = {{"frequency_hz", {wall_frequency}}, {"from", {0.25}}, {"periods", {8}}};

Values with(Values values, const Values& others) {
  values.insert(values.end(), others.begin(), others.end());
  return values;
}

std::string refused(const Values& values, double end_time = 10) {
  const Simulation s = shaken();
  try {
    Probe(lock_in(values), 3).check(SimulationView(s, 0, end_time).get());
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a lock-in finds amplitude and phase of a wall, and no harmonics", "[lock_in]") {
  const Sampled row = measured(eight_periods, 10);
  CHECK(row["samples"] == 8 * steps_per_period / steps_per_sample);
  CHECK(row["amplitude"] == near(wall_amplitude, summed_rounding));
  CHECK(row["phase"] == near(wall_phase, summed_rounding / wall_amplitude));
  CHECK(row["amplitude_2"] == near(0, summed_rounding));
  CHECK(row["amplitude_3"] == near(0, summed_rounding));
  CHECK(row["mean"] == near(-1, summed_rounding));
  // The residual is the root of a difference of squares: 1e-7 of the signal (lock_in.hpp).
  CHECK(row["residual"] < 1e-7 * wall_amplitude);
  CHECK(row["amplitude_error"] < 1e-7 * wall_amplitude);
}

TEST_CASE("columns have the unit of what is read, and as many harmonics as there are to be", "[lock_in]") {
  const Probe one(lock_in(with(eight_periods, {{"harmonics", {1}}})), 3), three(lock_in(eight_periods), 3);
  CHECK(one.names() == std::vector<std::string>{"amplitude", "phase", "amplitude_error", "phase_error",
                                                "mean", "residual", "samples"});
  CHECK(one.units() == std::vector<std::string>{"m", "rad", "m", "rad", "m", "m", ""});
  CHECK(three.names()[11] == "phase_error_3");
  CHECK(three.names().size() == 15);
}

TEST_CASE("harmonics are told apart", "[lock_in]") {
  const auto bent = [](double wall, double time) {
    return wall + 1e-4 * std::sin(4 * pi * wall_frequency * time + 0.2) +
           2e-5 * std::sin(6 * pi * wall_frequency * time - 1);
  };
  const Sampled row = measured(eight_periods, 10, bent);
  CHECK(row["amplitude_2"] == near(1e-4, summed_rounding));
  CHECK(row["phase_2"] == near(0.2, summed_rounding / 1e-4));
  CHECK(row["amplitude_3"] == near(2e-5, summed_rounding));
  CHECK(row["phase_3"] == near(-1, summed_rounding / 2e-5));
}

TEST_CASE("only the record counts, which begins at `from` and lasts for its periods", "[lock_in]") {
  const auto disturbed = [](double wall, double time) {
    return time < 0.25 - shaken_step || time > 2.25 - shaken_step ? 100 * time : wall;
  };
  const Sampled row = measured(eight_periods, 12, disturbed);
  CHECK(row["samples"] == 400);
  CHECK(row["amplitude"] == near(wall_amplitude, summed_rounding));
}

TEST_CASE(
    "drift up to the degree of the polynomial changes no amplitude, and what a period average removes neither",
    "[lock_in]") {
  const auto drifting = [](double wall, double time) { return wall + 0.1 * time * time; };
  const auto amplitude_with = [&](const Values& more) {
    return measured(with(eight_periods, more), 12, drifting)["amplitude"];
  };
  // Drift of 0.4 m over the record is rounded like the position.
  CHECK(amplitude_with({{"drift_degree", {2}}}) == near(wall_amplitude, 2 * summed_rounding));
  // The mean over a period leaves of c t² a constant; its samples lie on straight lines, whose error is
  // constant too.
  CHECK(amplitude_with({{"drift_degree", {0}}, {"detrend", {1}}}) ==
        near(wall_amplitude, 2 * summed_rounding));
  CHECK(std::abs(amplitude_with({{"drift_degree", {0}}}) - wall_amplitude) > 1e-3 * wall_amplitude);
  CHECK(measured(with(eight_periods, {{"detrend", {1}}}), 12, drifting)["samples"] == 400);
}

TEST_CASE("phases refer to the origin", "[lock_in]") {
  const Sampled row = measured(with(eight_periods, {{"origin", {0.06}}}), 10);
  CHECK(row["phase"] == near(wall_phase + 2 * pi * wall_frequency * 0.06, summed_rounding / wall_amplitude));
}

TEST_CASE("a lock-in that goes on in the middle of its record has the same bits", "[lock_in]") {
  const double detrend = GENERATE(0, 1);
  const Values values = with(eight_periods, {{"detrend", {detrend}}});
  const Sampled whole = measured(values, 10);
  Simulation s = shaken();
  Probe first(lock_in(values), 3);
  observe(first, s, 4 * steps_per_period + 7, as_it_is);
  State state;
  first.transfer(StateTransfer::saving_to(state).below("probe"));
  Probe second(lock_in(values), 3);
  second.transfer(StateTransfer::restoring_from(state).below("probe"));
  second.check_restored(SimulationView(s, 0).get());
  observe(second, s, 6 * steps_per_period - 7, as_it_is);
  CHECK(row_of(second, s).row == whole.row);
}

TEST_CASE("before there are samples enough a lock-in has none but their number", "[lock_in]") {
  for (const auto& [steps, samples] : {std::pair(0, 0), std::pair(251, 1), std::pair(261, 3)}) {
    Simulation s = shaken();
    Probe probe(lock_in(eight_periods), 3);
    observe(probe, s, steps, as_it_is);
    const Sampled row = row_of(probe, s);
    CHECK(row["samples"] == samples);
    CHECK(std::isnan(row["amplitude"]));
    CHECK(std::isnan(row["mean"]));
  }
}

TEST_CASE("a lock-in refuses what cannot give an amplitude, with the cure", "[lock_in]") {
  CHECK(refused(eight_periods) == "no error");
  CHECK(
      refused({{"frequency_hz", {200}}, {"periods", {8}}}) ==
      "probe lock_in: 3 times the frequency of 200 Hz is above half of the sampling rate, one sample in each "
      "step of 0.001 s; give a shorter time.step, a lower frequency or fewer harmonics");
  CHECK(refused({{"frequency_hz", {200}}, {"periods", {8}}, {"harmonics", {2}}}) == "no error");
  CHECK(
      refused(eight_periods, 0.25) ==
      "probe lock_in: from = 0.25 s is not before 0.25 s, when the run or the stages of the probe end, so that there are no samples; "
      "give an earlier time, or a longer run");
  CHECK(refused(eight_periods, 2.2)
            .find("lasts beyond 2.2 s, when the run or the stages of the probe end; give fewer periods") !=
        std::string::npos);
  CHECK(refused(eight_periods, 2.25) == "no error");
  CHECK(refused(with(eight_periods, {{"samples_per_period", {6}}})).find("not above twice the harmonics") !=
        std::string::npos);
  // 6.5 samples a period may fall on the same 6 phases of each, which do not tell three harmonics apart.
  CHECK(refused(with(eight_periods, {{"samples_per_period", {6.5}}})).find("not above twice the harmonics") !=
        std::string::npos);
  CHECK_THROWS_WITH(lock_in({{"samples_per_period", {1e9}}}), Catch::Contains("from 3 to 1e+06"));
  CHECK(
      refused({{"frequency_hz", {wall_frequency}}, {"periods", {0.15}}}) ==
      "probe lock_in: 0.15 periods have 7.5 samples for 8 unknowns of drift and harmonics; give more periods or "
      "samples_per_period, or fewer harmonics");
  CHECK_THROWS_WITH(lock_in({{"harmonics", {4}}}), Catch::Contains("from 1 to 3"));
  CHECK_THROWS_WITH(lock_in({{"harmonics", {1.5}}}), Catch::Contains("give a whole number"));
}
