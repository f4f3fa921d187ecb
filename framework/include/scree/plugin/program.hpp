#pragma once

#include <cmath>
#include <cstdint>

#include <scree/plugin/abi.h>

namespace scree {

// A function of time that a scenario gives for a parameter: a view of the doubles of a SCREE_PROGRAM value.
//   constant  {0, value}
//   sine      {1, mean, amplitude, frequency_hz, phase (rad)}
//   cycle     {2, from, to, period (s)}: from + (to − from)(1 − cos 2πt/period)/2
//   ramp      {3, from, to, duration (s)}: linear, then constant
//   table     {4, t0, v0, t1, v1, ...}: linear between the points, constant outside
// A default-constructed program is not given and must not be evaluated.
class Program {
 public:
  enum Kind { constant, sine, cycle, ramp, table };

  Program() = default;
  explicit Program(const scree_value& value) : value_(value) {}

  bool given() const { return value_.count > 0; }
  Kind kind() const { return Kind(int(value_.data[0])); }

  double operator()(double time) const {
    const double* p = value_.data + 1;
    switch (kind()) {
      case sine:
        return p[0] + p[1] * std::sin(two_pi * p[2] * time + p[3]);
      case cycle:
        return p[0] + (p[1] - p[0]) * 0.5 * (1 - std::cos(two_pi * time / p[2]));
      case ramp:
        return time >= p[2] ? p[1] : p[0] + (p[1] - p[0]) * (time > 0 ? time / p[2] : 0);
      case table:
        return interpolate(time);
      case constant:
        break;
    }
    return p[0];
  }

  // Time derivative; at corners the derivative from the right.
  double rate(double time) const {
    const double* p = value_.data + 1;
    switch (kind()) {
      case sine:
        return p[1] * two_pi * p[2] * std::cos(two_pi * p[2] * time + p[3]);
      case cycle:
        return (p[1] - p[0]) * 0.5 * two_pi / p[2] * std::sin(two_pi * time / p[2]);
      case ramp:
        return time < 0 || time >= p[2] ? 0 : (p[1] - p[0]) / p[2];
      case table:
        return slope(points_until(time));
      case constant:
        break;
    }
    return 0;
  }

 private:
  static constexpr double two_pi = 6.283185307179586476925;

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
