#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace scree::cycles {

// When a load is cycled.
struct CycleTimes {
  double period = 0;         // (s) above 0
  double first_minimum = 0;  // (s) of the load; cycle n begins at first_minimum + n period
};

// One cycle of a load, from one of its minima to the next.
struct Loop {
  // ∮ q dγ; above 0 if the load does work, with q and γ positive in the same sense. NaN with fewer than three
  // samples within the cycle.
  double area = 0;
  double stiffness =
      0;  // (q_max − q_min)/(γ at q_max − γ at q_min); NaN if the strains are equal, or as above
  double load_range = 0;  // q_max − q_min
};

// The strain γ over the cycles.
struct CycleSeries {
  std::vector<double> strain;  // at minimum n
  std::vector<double> load;    // likewise; empty without a load
  std::vector<Loop> loops;     // from minimum n to n + 1, one fewer; empty without a load
  // Number of periods of the load in the last cycle, up to 100; above 1 the given period is a multiple of the
  // load's.
  std::size_t load_periods = 1;
};

// The strain at each minimum of the load, and the loops between minima if there is a load (q). times: (s)
// increasing. load: empty, or as many values. Both are interpolated linearly; a sample within 1e-6 periods of
// a minimum counts as it is. The area is that of the polygon of the samples, closed by a straight line: N
// equally spaced samples on an ellipse have its area times sin(2π/N)/(2π/N). Throws Error for fewer than two
// samples, times that do not increase, values that are not finite, a period shorter than the mean distance of
// the samples, a gap of more than half a period (about a minimum that has no sample, or in a cycle of a load
// with three samples or more), fewer than two minima, a load that does not change, and one that is not near
// its least values at the minima.
CycleSeries cycle_series(std::span<const double> times, std::span<const double> strain,
                         std::span<const double> load, const CycleTimes& cycles);

// γ = L_y/L_y0 − L_x/L_x0, with L_0 from sample `first` (McNamara et al. 2008, section IV B 1). Throws Error
// for lengths that are not finite and above 0.
std::vector<double> strain_of_lengths(std::span<const double> length_x, std::span<const double> length_y,
                                      std::size_t first);

}  // namespace scree::cycles
