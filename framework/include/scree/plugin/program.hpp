#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <scree/plugin/abi.h>
#include <scree/plugin/waveform.hpp>

namespace scree {

// A function of time that a scenario gives for a parameter: a view of the doubles of a SCREE_PROGRAM value.
//   constant  {0, value}
//   sine      {1, mean, amplitude, frequency_hz, phase (rad)}
//   cycle     {2, from, to, period (s)}: from + (to − from)(1 − cos 2πt/period)/2
//   ramp      {3, from, to, duration (s)}: linear, then constant
//   table     {4, t0, v0, t1, v1, ...}: linear between the points, constant outside
// Drives: mean + amplitude w(t), with the waves w of waveform.hpp; they rise smoothly within a time, and
// waves that end fall likewise.
//   drive     {5, mean, amplitude, rise (s), frequency_hz, phase (rad)}: a sine
//   chirp     {6, mean, amplitude, rise (s), from_hz, to_hz, duration (s), logarithmic (0 or 1)}
//   gaussian  {7, mean, amplitude, at (s), width (s)}
//   ricker    {8, mean, amplitude, at (s), frequency_hz}
//   noise     {9, mean, amplitude, rise (s), first_hz, spacing_hz, φ0, φ1, ...}: a sine for each phase (rad)
//   sweep     {10, mean, amplitude, rise (s), end (s), f0, t0, f1, t1, ...}: sin(2π f (t − t_k)) from t_k (s) on
// The host gives one that goes on while others start again as
//   ahead     {11, by (s), kind, ...}: the function of that kind at t + by
// A default-constructed program is not given and must not be evaluated.
class Program {
 public:
  enum Kind { constant, sine, cycle, ramp, table, drive, chirp, gaussian, ricker, noise, sweep, ahead };

  Program() = default;
  explicit Program(const scree_value& value) : value_(value) {}

  bool given() const { return value_.count > 0; }
  Kind kind() const { return Kind(int(value_.data[0])); }

  // (s) of a sine or cycle that varies; 0 of the others.
  double period() const {
    const double* p = value_.data + 1;
    if (kind() == ahead) return inner().period();
    if (kind() == sine) return p[1] != 0 ? 1 / p[2] : 0;
    return kind() == cycle && p[0] != p[1] ? p[2] : 0;
  }

  double operator()(double time) const {
    const double* p = value_.data + 1;
    switch (kind()) {
      case ahead:
        return inner()(time + p[0]);
      case sine:
        return p[0] + p[1] * std::sin(two_pi * p[2] * time + p[3]);
      case cycle:
        return p[0] + (p[1] - p[0]) * 0.5 * (1 - std::cos(two_pi * time / p[2]));
      case ramp:
        return time >= p[2] ? p[1] : p[0] + (p[1] - p[0]) * (time > 0 ? time / p[2] : 0);
      case table:
        return interpolate(time);
      case constant:
        return p[0];
      default:
        return p[0] + p[1] * wave(time).value;
    }
  }

  // Time derivative; at corners the derivative from the right.
  double rate(double time) const {
    const double* p = value_.data + 1;
    switch (kind()) {
      case ahead:
        return inner().rate(time + p[0]);
      case sine:
        return p[1] * two_pi * p[2] * std::cos(two_pi * p[2] * time + p[3]);
      case cycle:
        return (p[1] - p[0]) * 0.5 * two_pi / p[2] * std::sin(two_pi * time / p[2]);
      case ramp:
        return time < 0 || time >= p[2] ? 0 : (p[1] - p[0]) / p[2];
      case table:
        return slope(points_until(time));
      case constant:
        return 0;
      default:
        return p[1] * wave(time).rate;
    }
  }

  // Values between which it stays.
  std::pair<double, double> extremes() const {
    const double* p = value_.data + 1;
    switch (kind()) {
      case ahead:
        return inner().extremes();
      case constant:
        return {p[0], p[0]};
      case cycle:
      case ramp:
        return std::minmax(p[0], p[1]);
      case table: {
        std::pair<double, double> all = {value_of(0), value_of(0)};
        for (std::uint64_t k = 1; k < points(); ++k)
          all = {std::min(all.first, value_of(k)), std::max(all.second, value_of(k))};
        return all;
      }
      default: {
        const double reach = (kind() == noise ? double(value_.count - 6) : 1) * std::abs(p[1]);
        return {p[0] - reach, p[0] + reach};
      }
    }
  }

 private:
  static constexpr double two_pi = 6.283185307179586476925;

  Program inner() const { return Program({value_.data + 2, value_.count - 2}); }

  // w and w' of a drive.
  waveform::Value wave(double time) const {
    const double* p = value_.data + 3;  // behind mean and amplitude
    switch (kind()) {
      case drive:
        return waveform::rise(time, p[0]) * waveform::sine(time, p[1], p[2]);
      case chirp:
        return waveform::window(time, p[3], p[0]) * waveform::chirp(time, p[1], p[2], p[3], p[4] != 0);
      case gaussian:
        return waveform::gaussian(time, p[0], p[1]);
      case ricker:
        return waveform::ricker(time, p[0], p[1]);
      case noise:
        return waveform::rise(time, p[0]) * waveform::sines(time, p[1], p[2], p + 3, value_.count - 6);
      default:
        return waveform::window(time, p[1], p[0]) * step_of_sweep(time);
    }
  }
  waveform::Value step_of_sweep(double time) const {
    const double* const first = value_.data + 5;  // (frequency, start) of each step
    std::uint64_t low = 0;
    for (std::uint64_t high = (value_.count - 5) / 2; high - low > 1;) {
      const std::uint64_t middle = (low + high) / 2;
      (first[2 * middle + 1] <= time ? low : high) = middle;
    }
    return waveform::sine(time - first[2 * low + 1], first[2 * low], 0);
  }

  std::uint64_t points() const { return (value_.count - 1) / 2; }
  double time_of(std::uint64_t k) const { return value_.data[1 + 2 * k]; }
  double value_of(std::uint64_t k) const { return value_.data[2 + 2 * k]; }

  std::uint64_t points_until(double time) const {
    std::uint64_t low = 0;
    for (std::uint64_t high = points(); low < high;) {
      const std::uint64_t middle = (low + high) / 2;
      (time_of(middle) <= time ? low : high) = time_of(middle) <= time ? middle + 1 : middle;
    }
    return low;
  }
  double slope(std::uint64_t k) const {
    return k == 0 || k == points() ? 0 : (value_of(k) - value_of(k - 1)) / (time_of(k) - time_of(k - 1));
  }
  double interpolate(double time) const {
    const std::uint64_t k = points_until(time);
    return k == 0 ? value_of(0) : value_of(k - 1) + slope(k) * (time - time_of(k - 1));
  }

  scree_value value_ = {};
};

}  // namespace scree
