// Amplitude and phase of a column of another probe at a frequency and its harmonics.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <scree/error.hpp>
#include <scree/plugin/formatted.hpp>
#include <scree/plugin/lock_in.hpp>
#include <scree/plugin/period_average.hpp>
#include <scree/plugin/probe.hpp>

namespace {

using scree::formatted, scree::LockIn, scree::LockInOptions, scree::PeriodAverage;

struct LockInProbe {
  scree::InputColumn of;
  double frequency = 0, from = 0, periods = 0, samples_per_period = 50, origin = 0;
  int harmonics = 3, detrend = 0, drift_degree = 1;

  static constexpr scree::About about = {
      "lock_in", "amplitude and phase of a column of another probe at a frequency, with their errors",
      "x(t) = drift + Σ_h A_h sin(2π h f (t − t_0) + φ_h), h = 1, 2, 3, by least squares;\n"
      "amplitude, phase: A_1, φ_1; amplitude_2, phase_2, ...: of the harmonics; mean: of the drift, after detrending by period_average of what is left;\n"
      "..._error: standard errors by the noise near h f; residual: root mean square of x minus the fit",
      "framework/include/scree/plugin/lock_in.hpp"};

  void declare(scree::Declaration& d) {
    d.input("of", of, "the column x").required();
    d.number("frequency_hz", frequency, "Hz", scree::positive, "f").required();
    d.number("from", from, "s", scree::non_negative, "start of the record");
    d.number("periods", periods, "", scree::positive, "length of the record in periods of f").required();
    d.number("samples_per_period", samples_per_period, "", {.minimum = 3, .maximum = 1e6},
             "samples at the steps nearest to these; every step if a period has fewer");
    d.integer("harmonics", harmonics, "", {.minimum = 1, .maximum = 3}, "largest h");
    d.choice("detrend", detrend, "polynomial|period_average",
             "period_average subtracts first the mean over the period around each sample");
    d.integer("drift_degree", drift_degree, "", {.minimum = 0, .maximum = 3},
              "of the polynomial that is fitted as drift");
    d.number("origin", origin, "s", scree::any_number, "t_0, to which phases refer");
  }
  void prepare(const scree::Setup& setup) const {
    if (samples_per_period < 2 * harmonics + 1)
      setup.refuse(
          "samples_per_period is not above twice the harmonics by 1 or more; give more of them, or fewer harmonics");
  }

  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_NO_BODIES;
    instance.column_count = std::uint32_t(per_harmonic * harmonics + 3);
    instance.observe_every = 1 / (frequency * samples_per_period);
  }
  scree::ColumnName column(std::uint32_t c) const {
    const int h = 1 + int(c) / per_harmonic;
    if (h > harmonics) {
      static constexpr const char* names[] = {"mean", "residual", "samples"};
      static constexpr const char* meanings[] = {
          "of the fitted drift", "root mean square of what the fit leaves", "number in the record so far"};
      const std::uint32_t k = c - std::uint32_t(per_harmonic * harmonics);
      return {names[k], k < 2 ? of.unit : "", meanings[k]};
    }
    static constexpr const char* names[] = {"amplitude", "phase", "amplitude_error", "phase_error"};
    const std::uint32_t k = c % per_harmonic;
    std::string name = names[k];
    if (h > 1) name.append("_").append(std::to_string(h));
    static constexpr const char* meanings[] = {"of the sine at the frequency", "at the time origin",
                                               "standard error", "standard error"};
    return {name, k % 2 ? "rad" : of.unit,
            h > 1 && k == 0 ? "of a harmonic, at a multiple of the frequency" : meanings[k]};
  }

  // State: time of the last sample, the lock-in, and with detrend = "period_average" the samples of a period.
  std::uint64_t state_size(const scree_view&) const {
    return 1 + LockIn::state_size(options()) + (averages() ? PeriodAverage::state_size(most_in_period()) : 0);
  }

  std::string start(const scree_view& view, double* state) const {
    state[0] = -std::numeric_limits<double>::infinity();
    if (2 * harmonics * frequency * view.step_length >= 1)
      return formatted(
          "%d times the frequency of %g Hz is above half of the sampling rate, one sample in each step of "
          "%g s; give a shorter time.step, a lower frequency or fewer harmonics",
          harmonics, frequency, view.step_length);
    const double samples = periods * std::min(samples_per_period, 1 / (frequency * view.step_length));
    if (const int unknowns = drift_degree + 1 + 2 * harmonics; samples < unknowns)
      return formatted(
          "%g periods have %.3g samples for %d unknowns of drift and harmonics; give more periods or "
          "samples_per_period, or fewer harmonics",
          periods, samples, unknowns);
    if (from >= view.end_time)
      return formatted(
          "from = %.12g s is not before %.12g s, when the run or the stages of the probe end, so that there are no "
          "samples; give an earlier time, or a longer run",
          from, view.end_time);
    if (end() > view.end_time + 0.5 * view.step_length)
      return formatted(
          "the record from %.12g to %.12g s lasts beyond %.12g s, when the run or the stages of the probe end; give "
          "fewer periods, an earlier from, or a longer run",
          from, end(), view.end_time);
    // Where the end is not known, this may be found in the middle of a run, which then goes on.
    if (std::isfinite(view.end_time) && from < view.time - 0.5 * view.step_length)
      return formatted(
          "the record begins at from = %g s, and the probe at %g s with its stages; give a later from, or other stages",
          from, view.time);
    return "";
  }

  void observe(const scree_view& view, double* state) const {
    // The mean is known half a period away from the ends of the samples.
    const double margin = averages() ? 0.5 / frequency : 0, early = 0.5 * view.step_length;
    if (view.time < from - margin - early || view.time >= end() + margin + early) return;
    // At the start of a stage samples may follow each other faster.
    if (view.time - state[0] < 0.5 / (frequency * samples_per_period)) return;
    state[0] = view.time;
    const auto add = [&](double time, double value) {
      if (time < from - early || time >= end() - early) return;
      LockIn(options(), lock_in_state(state)).add(time, value);
    };
    if (!averages()) return add(view.time, of.value(view));
    double* const ring = state + 1 + LockIn::state_size(options());
    PeriodAverage(1 / frequency, {ring, PeriodAverage::state_size(most_in_period())})
        .add(view.time, of.value(view), add);
  }

  void sample(const scree_view&, const double* state, double* row) const {
    const std::uint32_t columns = std::uint32_t(per_harmonic * harmonics + 3);
    std::fill_n(row, columns, std::numeric_limits<double>::quiet_NaN());
    std::vector<double> copy(state + 1, state + 1 + LockIn::state_size(options()));
    const LockIn lock_in(options(), copy);
    row[columns - 1] = double(lock_in.samples());
    scree::LockInResult result;
    try {
      result = lock_in.result();
    } catch (const scree::Error&) {
      return;  // too few samples so far
    }
    for (int h = 0; h < harmonics; ++h) {
      const scree::SpectralLine& line = result.lines[std::size_t(h)];
      for (const double value : {line.amplitude, line.phase, line.amplitude_error, line.phase_error})
        *row++ = value;
    }
    row[0] = result.mean;
    row[1] = result.residual_rms;
  }

 private:
  static constexpr int per_harmonic = 4;

  double end() const { return from + periods / frequency; }
  bool averages() const { return detrend == 1; }
  LockInOptions options() const { return {frequency, periods / frequency, harmonics, drift_degree, origin}; }
  std::span<double> lock_in_state(double* state) const { return {state + 1, LockIn::state_size(options())}; }
  // Samples are at least half of their nominal distance apart.
  std::size_t most_in_period() const { return 2 * std::size_t(std::ceil(samples_per_period)) + 2; }
};

}  // namespace

SCREE_PROBE_PLUGIN(LockInProbe)
