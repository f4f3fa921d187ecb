#pragma once

#include <complex>
#include <optional>
#include <vector>

#include <scree/scenario/spectrum_plan.hpp>
#include <scree/plugin/lock_in.hpp>
#include <scree/plugin/period_average.hpp>

namespace scree::spectrum {

// Amplitude and phase of one signal at the frequency of a tone, sample by sample.
class ToneLockIn {
 public:
  // length: (s) of the record. averaged: a mean over one period is subtracted first.
  ToneLockIn(double frequency, double length, std::size_t samples_per_period, bool averaged,
             int drift_degree);
  ToneLockIn(ToneLockIn&&) = default;

  // time: (s) since the start of the tone.
  void add(double time, double value);

  // A e^(iφ) of A sin(2π f t + φ).
  struct Amplitude {
    std::complex<double> value;
    double error = 0;  // standard error of |value|
    double mean = 0;   // of the samples
  };
  // Throws Error if the samples do not determine the tone.
  Amplitude result() const;

 private:
  LockInOptions options_;
  std::vector<double> fit_state_, average_state_;
  LockIn fit_;
  std::optional<PeriodAverage> average_;
  double sum_ = 0, origin_ = 0;
  std::size_t samples_ = 0;
};

}  // namespace scree::spectrum
