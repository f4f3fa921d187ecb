#include "exponential_drift.hpp"
#include "line_fit.hpp"
#include "scree/signals/amplitude_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <scree/error.hpp>
#include <scree/median.hpp>

namespace scree::signals {

namespace {

constexpr std::size_t shortest_side = 6, longest_side = 50;
constexpr double least_over_median = 5;
constexpr double least_over_error = 5;
// Below, a line has fewer periods than its window needs.
constexpr std::size_t first_bin = 3;

double median_beside(const std::vector<double>& amplitude, std::size_t k) {
  // Noise that falls with frequency is compared with itself only nearby.
  const std::size_t side = std::clamp(k / 2, shortest_side, longest_side);
  const std::size_t begin = k > side ? k - side : 1;
  const std::size_t end = std::min(amplitude.size(), k + side + 1);
  return upper_median({amplitude.begin() + std::ptrdiff_t(begin), amplitude.begin() + std::ptrdiff_t(end)});
}

// Bins of maxima above the noise, the highest first.
std::vector<std::size_t> candidates(const std::vector<double>& amplitude) {
  std::vector<std::size_t> bins;
  for (std::size_t k = first_bin; k + 1 < amplitude.size(); ++k)
    if (amplitude[k] > amplitude[k - 1] && amplitude[k] >= amplitude[k + 1] &&
        amplitude[k] > least_over_median * median_beside(amplitude, k))
      bins.push_back(k);
  std::stable_sort(bins.begin(), bins.end(),
                   [&](std::size_t a, std::size_t b) { return amplitude[a] > amplitude[b]; });
  return bins;
}

// Behind a Hann window, bins at distances d and 1 - d from a line have amplitudes in the ratio (2 - d) : (1 + d).
double interpolated(const AmplitudeSpectrum& spectrum, std::size_t k) {
  const bool above = spectrum.amplitude[k + 1] > spectrum.amplitude[k - 1];
  const double ratio = spectrum.amplitude[above ? k + 1 : k - 1] / spectrum.amplitude[k];
  const double distance = (2 * ratio - 1) / (ratio + 1);
  return spectrum.frequency(k) + spectrum.resolution * (above ? distance : -distance);
}

// Whether a fit found what the spectrum shows at its bin, and not what another line left there.
bool is_at(const Wave& wave, const AmplitudeSpectrum& spectrum, std::size_t k) {
  constexpr double least_share = 0.5, furthest = 2;  // of the amplitude; (resolutions)
  return wave.amplitude > least_share * spectrum.amplitude[k] &&
         std::abs(wave.frequency - spectrum.frequency(k)) < furthest * spectrum.resolution;
}

bool stands_out(const FoundLine& line) {
  return line.amplitude > 0 && !(line.amplitude < least_over_error * line.amplitude_error);
}

// What others leave in a line falls by its share in them, some 0.05 at five resolutions, with each round.
constexpr int rounds_before_decay = 2, rounds_together = 6;

// A record, and what was found in it.
class Decomposition {
 public:
  Decomposition(std::span<const double> times, std::span<const double> values, PassDone pass_done)
      : times_(times), rest_(values.begin(), values.end()), pass_done_(std::move(pass_done)) {}

  const std::vector<Wave>& waves() const { return waves_; }

  // Looks for a wave at a place of the spectrum, in what the others leave.
  void try_at(const AmplitudeSpectrum& spectrum, std::size_t bin) {
    const Wave wave = fitted_wave(interpolated(spectrum, bin), times_, rest_, pass_done_);
    if (!is_at(wave, spectrum, bin)) return;
    add(wave, -1, times_, rest_);
    waves_.push_back(wave);
  }
  // Looks for waves that decay early, in spectra of the beginning: those of the whole record hardly have them.
  void try_at_beginning(std::size_t most) {
    constexpr std::size_t fewest_samples = 64, factor = 2;
    for (std::size_t count = rest_.size() / factor; count >= fewest_samples && waves_.size() < most;
         count /= factor) {
      const std::span<const double> times = times_.first(count), values = std::span(rest_).first(count);
      const AmplitudeSpectrum spectrum = amplitude_spectrum(
          (times.back() - times.front()) / double(count - 1), at_equal_steps(times, values));
      for (const std::size_t bin : candidates(spectrum.amplitude)) {
        Wave wave;
        wave.frequency = interpolated(spectrum, bin);
        let_decay(wave, times_, rest_, pass_done_);
        if (!(wave.decay > 0) || std::abs(wave.frequency - spectrum.frequency(bin)) > 2 * spectrum.resolution)
          continue;
        add(wave, -1, times_, rest_);
        waves_.push_back(wave);
        break;
      }
    }
  }
  // Lets waves decay, in what the others leave.
  void let_decay_all() {
    for (Wave& wave : waves_) {
      add(wave, 1, times_, rest_);
      let_decay(wave, times_, rest_, pass_done_);
      add(wave, -1, times_, rest_);
    }
  }
  // The drift and each wave in turn, from the record less all others. Whether they changed by more than round-off.
  bool refit_all() {
    add(drift_, 1, times_, rest_);
    drift_ = exponential_drift(times_, rest_);
    add(drift_, -1, times_, rest_);
    bool changed = false;
    for (Wave& wave : waves_) {
      const Wave before = wave;
      add(wave, 1, times_, rest_);
      refit(wave, times_, rest_, pass_done_);
      add(wave, -1, times_, rest_);
      changed |= has_changed(before, wave);
    }
    return changed;
  }
  FoundLine line(std::size_t number) {
    add(waves_[number], 1, times_, rest_);
    const FoundLine line = line_of(waves_[number], times_, rest_);
    add(waves_[number], -1, times_, rest_);
    return line;
  }

 private:
  bool has_changed(const Wave& before, const Wave& wave) const {
    constexpr double small = 1e-12;
    const double duration = times_.back() - times_.front();
    return std::abs(wave.frequency - before.frequency) * duration > small ||
           std::abs(wave.amplitude - before.amplitude) > small * before.amplitude;
  }

  std::span<const double> times_;
  std::vector<double> rest_;
  PassDone pass_done_;
  std::vector<Wave> waves_;
  ExponentialDrift drift_;
};

}  // namespace

std::vector<FoundLine> strongest_lines(std::span<const double> times, std::span<const double> values,
                                       const AmplitudeSpectrum& spectrum, std::size_t most,
                                       const std::function<void(double)>& on_progress) {
  std::vector<std::size_t> bins = candidates(spectrum.amplitude);
  bins.resize(std::min(bins.size(), 4 * most));  // of noise-free records, those beyond are round-off
  // A wave takes some three passes over the record at first, one in each round, and errors as long as ten.
  constexpr double passes_at_first = 3, passes_of_errors = 10;
  const double lines_expected = double(std::min(bins.size(), most));
  const double expected =
      lines_expected * (passes_at_first + rounds_before_decay + rounds_together + passes_of_errors);
  double passes = 0;
  const auto done = [&](double more) {
    passes += more;
    if (on_progress) on_progress(std::min(0.99, passes / expected));
  };
  done(0);
  Decomposition found(times, values, [&] { done(1); });
  for (const std::size_t k : bins)
    if (found.waves().size() < most) found.try_at(spectrum, k);
  // Before waves may decay, the drift is known well enough not to be taken for a decay.
  for (int round = 0; round < rounds_before_decay && found.refit_all(); ++round) {
  }
  found.let_decay_all();
  found.try_at_beginning(most);
  for (int round = 0; round < rounds_together && found.refit_all(); ++round) {
  }
  std::vector<FoundLine> lines;
  for (std::size_t n = 0; n < found.waves().size(); ++n) {
    try {
      if (const FoundLine line = found.line(n); stands_out(line)) lines.push_back(line);
    } catch (const Error&) {
      // The record is too short for this line, which then is not one to be told.
    }
    done(passes_of_errors);
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const FoundLine& a, const FoundLine& b) { return a.amplitude > b.amplitude; });
  return lines;
}

}  // namespace scree::signals
