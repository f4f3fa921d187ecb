#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <scree/cycles/straight_line.hpp>

namespace scree::cycles {

// How a strain goes on over the cycles of a load; the first that holds, in this order.
enum class Class {
  constant,  // its range is within round-off
  ratcheting,  // the deviations from a straight line are smaller than its slope per cycle: StraightLine::ratchets()
  periodic,   // it repeats with a period of 2 to a third of the cycles
  outliers,   // some cycles, an eighth or fewer, stand off from those around them
  shakedown,  // the strain per cycle falls
  irregular   // none of these
};

inline constexpr std::size_t classes = 6;
std::string_view class_name(Class kind);

struct ClassOptions {
  static constexpr double lengths_round_off =
      1e-13;              // 450 units in the last place of 1, the roundings of some hundred bodies
  std::size_t drop = 29;  // cycles before the first that counts
  // Largest range of a constant, and least deviation of an outlier; 0: lengths_round_off times the largest |γ|, and at least times 1,
  // as of strains that are differences of ratios of lengths.
  double round_off = 0;
  double significance =
      0.005;  // (0, 1) share of series in random order that are called periodic, and again shakedown
  double outlier_factor = 10;  // (above 0) robust standard deviations
};

// A strain at the minima n = drop, drop + 1, ... of a load.
struct Classification {
  Class kind = Class::irregular;
  std::string reason;         // the number that decided and its threshold, in one line
  StraightLine line, robust;  // over n
  double range = 0;           // of γ
  double round_off = 0;       // that holds
  std::size_t period = 0;     // (cycles) of class periodic
  double period_probability = 1,
         settling_probability = 1;    // that such a repetition, such a fall is by chance
  std::vector<std::size_t> outliers;  // numbers n of the cycles, of any class
};

// Fewest minima behind `drop`: with fewer the probabilities are off by more than a factor of two.
inline constexpr std::size_t least_cycles = 16;

// strain: at minimum 0, 1, ... . Throws Error for fewer than drop + least_cycles, values that are not finite, options out of range.
Classification classify(std::span<const double> strain, const ClassOptions& options = {});

}  // namespace scree::cycles
