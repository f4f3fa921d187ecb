#pragma once

#include "sweep_point.hpp"
#include "tone_lock_in.hpp"

#include <vector>

#include <scree/scenario/spectrum_plan.hpp>

namespace scree::spectrum {

// Drive and observed columns of a sweep over some periods at one frequency.
class Tone {
 public:
  // averaged: columns are detrended by the mean over one period, else by a polynomial.
  Tone(const scenario::SpectrumPlan& plan, double frequency, double periods, bool averaged);

  // time: (s) since the start of the frequency; drive: (m).
  void add(double time, double drive, const std::vector<double>& values);

  // (m) of the drive.
  double amplitude() const { return std::abs(drive_.result().value); }
  // Response over drive of each column. Throws Error if there are too few samples.
  std::vector<SweepPoint::Column> columns() const;

 private:
  const scenario::SpectrumPlan& plan_;
  ToneLockIn drive_;
  std::vector<ToneLockIn> columns_;
};

}  // namespace scree::spectrum
