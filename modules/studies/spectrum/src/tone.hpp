#pragma once

#include "sweep_points.hpp"

#include <complex>
#include <optional>
#include <vector>

#include <scree/plugin/lock_in.hpp>
#include <scree/plugin/period_average.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

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

// Drive and observed columns of a sweep over some periods at one frequency.
class Tone {
 public:
  // averaged: columns are detrended by the mean over one period, else by a polynomial.
  Tone(const SpectrumPlan& plan, double frequency, double periods, bool averaged);

  // time: (s) since the start of the frequency; drive: (m).
  void add(double time, double drive, const std::vector<double>& values);

  // (m) of the drive.
  double amplitude() const { return std::abs(drive_.result().value); }
  // Response over drive of each column. Throws Error if there are too few samples.
  std::vector<SweepPoint::Column> columns() const;

 private:
  const SpectrumPlan& plan_;
  ToneLockIn drive_;
  std::vector<ToneLockIn> columns_;
};

// The halves of the analysed periods of a tone: where their responses differ, the motion is not steady.
class ToneHalves {
 public:
  // middle: (s) since the start of the frequency. Records that are too short have no halves.
  ToneHalves(const SpectrumPlan& plan, double frequency, double middle);

  // As Tone::add.
  void add(double time, double drive, const std::vector<double>& values);
  // True if one of the first columns differs between the halves by more than sweep.tolerance, relative to the
  // larger of response and scale, and by more than five standard errors.
  bool differ(const std::vector<double>& scales) const;

 private:
  const SpectrumPlan& plan_;
  double middle_;
  std::optional<Tone> first_, second_;
};

}  // namespace scree::spectrum
