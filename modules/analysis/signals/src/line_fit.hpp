#pragma once

#include "scree/signals/amplitude_spectrum.hpp"

#include <functional>
#include <span>
#include <vector>

namespace scree::signals {

// A sine that may decay. Amplitude and phase hold at the reference time.
struct Wave {
  double frequency = 0;             // (Hz)
  double decay = 0;                 // (1/s) 0: steady
  double reference = 0;             // (s)
  double amplitude = 0, phase = 0;  // (unit of the record) (rad)
  double value(double time) const;
};

using PassDone = std::function<void()>;  // called after each pass over the record

// Fits a steady wave with its frequency, from a frequency within 1 / (2 length of the record) of it.
Wave fitted_wave(double frequency, std::span<const double> times, std::span<const double> values,
                 const PassDone& pass_done);

// Fits a wave again that is nearly right, with its decay if it has one.
void refit(Wave& wave, std::span<const double> times, std::span<const double> values,
           const PassDone& pass_done);

// Lets a wave decay from the beginning of the record, if that lowers the residual.
void let_decay(Wave& wave, std::span<const double> times, std::span<const double> values,
               const PassDone& pass_done);

// The line of a wave, with its errors. Throws Error as LockIn::result().
FoundLine line_of(const Wave& wave, std::span<const double> times, std::span<const double> values);

// Adds a wave to a record, or subtracts it (sign -1).
void add(const Wave& wave, double sign, std::span<const double> times, std::vector<double>& values);

}  // namespace scree::signals
