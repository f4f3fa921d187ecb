#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace scree::cycles {

// The times of the cycles of a load.
struct CycleTimes {
  double period = 0;         // (s) above 0
  double first_minimum = 0;  // (s) of the load; cycle n begins at first_minimum + n period
};

// One cycle of a load, from one of its minima to the next.
struct Loop {
  double area =
      0;  // ∮ q dγ; > 0 if the load does work, where both are positive in one sense; NaN with fewer than three samples within the cycle
  double stiffness =
      0;  // (q_max − q_min)/(γ at q_max − γ at q_min); NaN if the strains are equal, or as above
  double load_range = 0;  // q_max − q_min
};

// Strain (γ) at the minima of the load.
struct CycleSeries {
  std::vector<double> strain;  // of minimum n
  std::vector<double> load;    // likewise; empty without a load
  std::vector<Loop> loops;     // from minimum n to n + 1, one fewer; empty without a load
  std::size_t load_periods =
      1;  // that the load has in the last cycle, up to 100: with more than 1 the period is a multiple of its own
};

// Strain at each minimum of the load, and the loop between two if there is a load (q). times: (s) increasing. Between samples both are
// taken as straight; a sample within 1e-6 of a period of a minimum is taken as it is. load: empty, or as many values.
// The area is that of the polygon of the samples, closed by a straight line: N equally spaced ones on an ellipse have its area
// times sin(2π/N)/(2π/N). Throws Error for fewer than two samples, times that do not increase, values that are not finite, a period shorter than the mean
// distance of the samples, a gap of more than half a period about a minimum that has no sample, or in a cycle of a load with three samples or more, fewer
// than two minima, a load that does not change, and one that is not near its least values at these times.
CycleSeries cycle_series(std::span<const double> times, std::span<const double> strain,
                         std::span<const double> load, const CycleTimes& cycles);

// γ = L_y/L_y0 − L_x/L_x0 with the lengths at sample `first` for L_0 (McNamara et al. 2008, section IV B 1). Throws Error for
// lengths that are not finite and above 0.
std::vector<double> strain_of_lengths(std::span<const double> length_x, std::span<const double> length_y,
                                      std::size_t first);

}  // namespace scree::cycles
