#include "axis_scale.hpp"

#include <cmath>

namespace scree::charts {

AxisScale::AxisScale(double lower, double upper, bool logarithmic, double pad) : logarithmic_(logarithmic) {
  const AxisSpan range = padded(raw(lower), raw(upper), pad);
  lower_ = range.lower;
  upper_ = range.upper;
}

double AxisScale::raw(double value) const { return logarithmic_ ? std::log10(value) : value; }

double AxisScale::position(double value) const { return (raw(value) - lower_) / (upper_ - lower_); }

Ticks AxisScale::ticks(int target) const {
  Ticks ticks = logarithmic_ ? logarithmic_ticks(std::pow(10.0, lower_), std::pow(10.0, upper_), target)
                             : linear_ticks(lower_, upper_, target);
  for (std::string& label : ticks.labels) label = printed_number(label);
  return ticks;
}

std::vector<double> AxisScale::minor_ticks() const {
  constexpr double most_decades = 10;
  std::vector<double> values;
  if (!logarithmic_ || upper_ - lower_ > most_decades) return values;
  for (double decade = std::floor(lower_); decade < upper_; ++decade)
    for (int mantissa = 2; mantissa < 10; ++mantissa)
      if (const double at = decade + std::log10(mantissa); at > lower_ && at < upper_)
        values.push_back(std::pow(10.0, at));
  return values;
}

}  // namespace scree::charts
