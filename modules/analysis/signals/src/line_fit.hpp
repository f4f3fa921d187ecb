#pragma once

#include "scree/signals/amplitude_spectrum.hpp"

#include <functional>
#include <span>
#include <vector>

namespace scree::signals {

// A sine in a record: amplitude and phase (rad) at a time of reference, frequency, and the rate of its decay.
struct Wave {
  double frequency = 0, decay = 0;  // (Hz) (1/s)
  double reference = 0;             // (s)
  double amplitude = 0, phase = 0;
  double value(double time) const;
};

using PassDone = std::function<void()>;  // after each pass over the record

// A steady one that is fitted, also its frequency, from one nearer than 1 / (2 length of the record).
Wave fitted_wave(double frequency, std::span<const double> times, std::span<const double> values,
                 const PassDone& pass_done);

// The same, from one that is nearly right, with its decay if it has one.
void refit(Wave& wave, std::span<const double> times, std::span<const double> values,
           const PassDone& pass_done);

// Lets a wave decay from the beginning of the record, where that leaves less of it.
void let_decay(Wave& wave, std::span<const double> times, std::span<const double> values,
               const PassDone& pass_done);

// The line of a wave, with its errors. Throws Error as a lock-in does.
FoundLine line_of(const Wave& wave, std::span<const double> times, std::span<const double> values);

// Adds a wave to a record, or takes it out (sign -1).
void add(const Wave& wave, double sign, std::span<const double> times, std::vector<double>& values);

}  // namespace scree::signals
