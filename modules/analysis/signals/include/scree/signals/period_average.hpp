#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace scree::signals {

// Subtracts from each sample the mean of the signal over the period around it, as Lemrich et al. (2017) do with the strain of a
// driven packing. The mean is the integral of the samples connected by straight lines over [t - P/2, t + P/2], divided by P.
//
// What this does to a sine of frequency 1/P: the mean of a sine over its period is sinc(1) = 0, so its amplitude and
// phase are kept, as are those of the harmonics (sinc(2) = sinc(3) = 0). For samples at equal steps h the line through them
// holds also the images f + m/h with amplitudes sinc^2(f h + m), of which the mean keeps sinc(1 + m n), n = P/h:
//   n integer: exactly 0, so that amplitude and phase are exact; else the relative error is at most (f h)^3.
// For steps up to h it is at most (2 pi f h)^2 / 12: the error of the trapezoidal rule, h^2 x''/12.
// Other frequencies v are multiplied by 1 - sinc(v/f).
//
// What is left of a drift: of c t nothing; of c t^2 the constant -c P^2/12; of c t^3 the line -c P^2 t/4.
// Half a period at each end of the record is lost.
class PeriodAverage {
 public:
  using Emit = std::function<void(double time, double value)>;

  // Doubles that are kept, for any length of the record, if a period has at most so many samples.
  static std::size_t state_size(std::size_t samples_per_period);

  // period: (s). Goes on with what `state` holds; all zeros: no sample yet. The memory is the caller's and is the whole state.
  // Throws Error for a period that is not above 0, or a state for fewer than 2 samples per period or with other
  // counts than add() leaves.
  PeriodAverage(double period, std::span<double> state);

  // Adds a sample at a time (s) after the last, and emits those around which a whole period is known now. Throws Error if
  // a period has more samples than fit.
  void add(double time, double value, const Emit& emit);

 private:
  struct Sample;
  Sample sample(std::size_t number) const;
  void set(std::size_t number, const Sample& sample);
  std::size_t size_of_ring() const;
  void check_counts() const;
  void drop_old(std::size_t end);
  void rebase(std::size_t oldest, std::size_t end);
  double integral_to(double time) const;

  double period_;
  std::span<double> state_;
};

}  // namespace scree::signals
