#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::cycles {

// Times that differ by less than this share of a period are the same.
inline constexpr double same_time = 1e-6;

// Values at increasing times (s), interpolated linearly.
class Samples {
 public:
  Samples(std::span<const double> times, std::span<const double> values, double period)
      : times_(times), values_(values), slack_(same_time * period) {}

  // Index of the first sample that is later than the time by more than the slack.
  std::size_t after(double time) const {
    return std::size_t(std::upper_bound(times_.begin(), times_.end(), time + slack_) - times_.begin());
  }
  double at(double time) const {
    const std::size_t next = after(time);
    if (next == 0) return values_.front();
    if (next == times_.size() || times_[next - 1] >= time - slack_) return values_[next - 1];
    const double share = (time - times_[next - 1]) / (times_[next] - times_[next - 1]);
    return std::lerp(values_[next - 1], values_[next], share);
  }
  // Both throw Error for a longer gap (s): about a time without a sample nearby, and between two times.
  void check_gap_about(double time, double longest) const {
    const std::size_t next = after(time);
    if (next == 0 || next == times_.size()) return;
    const double nearest = std::min(std::abs(time - times_[next - 1]), std::abs(times_[next] - time));
    if (nearest > near_sample * longest) check_gap_before(next, longest);
  }
  void check_gaps_between(double begin, double end, double longest) const {
    for (std::size_t next = after(begin); next < times_.size() && times_[next - 1] < end - slack_; ++next)
      check_gap_before(next, longest);
  }
  double operator[](std::size_t sample) const { return values_[sample]; }
  double slack() const { return slack_; }

 private:
  // A sample within this share of the longest gap is nearby: the interpolated value is nearly its own.
  static constexpr double near_sample = 0.04;

  void check_gap_before(std::size_t sample, double longest) const {
    if (times_[sample] - times_[sample - 1] <= longest) return;
    throw Error(fmt::format(
        "there is no sample from {:.10g} s to {:.10g} s, more than half a period; give a series without gaps, or one "
        "with samples at the minima of the load",
        times_[sample - 1], times_[sample]));
  }

  std::span<const double> times_, values_;
  double slack_;
};

}  // namespace scree::cycles
