#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <scree/cycles/straight_line.hpp>

namespace scree::cycles {

// How a strain continues over the cycles of a load; the first that holds, in this order.
enum class Class {
  constant,    // its range is within round-off
  ratcheting,  // deviations from a straight line are smaller than its slope per cycle: StraightLine::ratchets()
  late_ratcheting,  // the same for the cycles after a settling part
  periodic,         // it repeats with a period of 2 to a third of the cycles
  outliers,         // some cycles, an eighth or fewer, stand off from those around them
  shakedown,        // the strain per cycle falls, and the strain tends to a limit
  creep,            // the strain per cycle falls, but the strain has no limit
  settling,         // the strain per cycle falls; more cycles are needed to tell whether there is a limit
  irregular         // none of these
};

inline constexpr std::size_t classes = 9;
std::string_view class_name(Class kind);

struct ClassOptions {
  // 450 units in the last place of 1: the roundings of some hundred bodies.
  static constexpr double lengths_round_off = 1e-13;
  std::size_t drop = 29;  // cycles before the first that counts
  // Largest range of a constant, and least deviation of an outlier. 0: lengths_round_off times the largest
  // |γ|, or times 1 if that is larger, as strains are differences of ratios of lengths.
  double round_off = 0;
  // (0, 1) share of series in random order that are called periodic, and the same share that are called
  // falling.
  double significance = 0.005;
  double outlier_factor = 10;  // (above 0) robust standard deviations
  // (0 or more) difference of criteria (Slowing::criterion) from which a law is preferred; 3: 4.5 times as
  // likely.
  double preference = 3;
};

// A law by which a strain slows down, fitted to the cycles that count: k = 0, 1, ... from the first of them.
struct Slowing {
  enum class Law {
    exponential,           // constant + amplitude exp(−k/scale): tends to the constant
    power_to_limit,        // constant + amplitude (1 + k/scale)^exponent, exponent below 0: the same
    logarithm,             // constant + amplitude log(1 + k/scale): no limit
    power,                 // constant + amplitude (1 + k/scale)^exponent, exponent from 0 to 1: no limit
    exponential_and_line,  // exponential + slope k
    power_and_line         // power_to_limit + slope k
  };
  Law law = Law::exponential;
  double scale = 1;                               // (cycles)
  double exponent = 0;                            // of the powers
  double constant = 0, amplitude = 0, slope = 0;  // slope: per cycle
  // Akaike's, corrected for few values: a law whose criterion is lower by x is exp(x/2) times as likely.
  double criterion = 0;
};

double value_of(const Slowing& slowing, double k);
// The formula with its numbers.
std::string law_text(const Slowing& slowing);

// The class of a strain at the minima n = drop, drop + 1, ... of a load, and what decided it.
struct Classification {
  Class kind = Class::irregular;
  std::string reason;         // the number that decided and its threshold, in one line
  StraightLine line, robust;  // over n
  double range = 0;           // of γ
  double round_off = 0;       // that was used
  std::size_t period = 0;     // (cycles) of class periodic
  // That chance makes such a repetition, and such a fall.
  double period_probability = 1, settling_probability = 1;
  std::vector<std::size_t> outliers;  // numbers n of the cycles, for any class
  // The law of the classes late_ratcheting, shakedown and creep.
  std::optional<Slowing> slowing;
  // Of class late_ratcheting: the first cycle n of the line after the settling part, and this line over n.
  std::size_t ratchets_from = 0;
  StraightLine after_settling;
};

// Fewest minima after `drop`: with fewer the probabilities are wrong by more than a factor of two.
inline constexpr std::size_t least_cycles = 16;
// Fewest minima of a creep, and of the line of late ratcheting: a law with a limit can have the shape of
// fewer.
inline constexpr std::size_t least_for_law = 32;

// strain: at minimum 0, 1, ... . Throws Error for fewer than drop + least_cycles, values that are not finite,
// and options out of range.
Classification classify(std::span<const double> strain, const ClassOptions& options = {});

}  // namespace scree::cycles
