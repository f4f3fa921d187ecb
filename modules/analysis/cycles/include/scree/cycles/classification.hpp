#pragma once

#include <cstddef>
#include <optional>
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
  late_ratcheting,  // the same of the cycles behind a settling part
  periodic,         // it repeats with a period of 2 to a third of the cycles
  outliers,         // some cycles, an eighth or fewer, stand off from those around them
  shakedown,        // the strain per cycle falls, and the strain goes to a limit
  creep,            // the strain per cycle falls, but the strain goes on without a limit
  settling,         // the strain per cycle falls; whether there is a limit cannot be told from these cycles
  irregular         // none of these
};

inline constexpr std::size_t classes = 9;
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
  // (0 or more) by which criteria of laws differ where one is preferred, see Slowing::criterion; 3: 4.5 times as likely
  double preference = 3;
};

// How a strain slows down, fitted to the cycles that count, k = 0, 1, ... since the first of them.
struct Slowing {
  enum class Law {
    exponential,           // constant + amplitude exp(−k/scale): to a limit, the constant
    power_to_limit,        // constant + amplitude (1 + k/scale)^exponent, exponent below 0: likewise
    logarithm,             // constant + amplitude log(1 + k/scale): without an end
    power,                 // constant + amplitude (1 + k/scale)^exponent, exponent from 0 to 1: likewise
    exponential_and_line,  // exponential, + slope k
    power_and_line         // power_to_limit, + slope k
  };
  Law law = Law::exponential;
  double scale = 1;                               // (cycles)
  double exponent = 0;                            // of the powers
  double constant = 0, amplitude = 0, slope = 0;  // slope: per cycle
  double criterion =
      0;  // of Akaike, corrected for few values: one that is lower by x is exp(x/2) times as likely
};

double value_of(const Slowing& slowing, double k);
// As a formula with its numbers.
std::string law_text(const Slowing& slowing);

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
  // How the strain slows down, of the classes late_ratcheting, shakedown and creep.
  std::optional<Slowing> slowing;
  std::size_t ratchets_from =
      0;  // (n) of class late_ratcheting, the first cycle that the line after_settling counts
  StraightLine after_settling;  // likewise, over n
};

// Fewest minima behind `drop`: with fewer the probabilities are off by more than a factor of two.
inline constexpr std::size_t least_cycles = 16;
// Fewest minima of a creep, and of the line of late ratcheting: fewer have the shape of a law that ends as well.
inline constexpr std::size_t least_for_law = 32;

// strain: at minimum 0, 1, ... . Throws Error for fewer than drop + least_cycles, values that are not finite, options out of range.
Classification classify(std::span<const double> strain, const ClassOptions& options = {});

}  // namespace scree::cycles
