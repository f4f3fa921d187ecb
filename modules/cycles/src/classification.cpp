#include "scree/cycles/classification.hpp"

#include "outliers.hpp"
#include "repetition.hpp"
#include "settling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::cycles {

namespace {

void check(std::span<const double> strain, const ClassOptions& options) {
  const std::size_t cycles = strain.empty() ? 0 : strain.size() - 1;
  if (strain.size() < options.drop + least_cycles)
    throw Error(fmt::format(
        "{} cycle{}, the first {} of which are dropped: too few for a verdict; give {} cycles or more, or drop fewer",
        cycles, cycles == 1 ? "" : "s", options.drop, options.drop + least_cycles - 1));
  for (std::size_t n = 0; n < strain.size(); ++n)
    if (!std::isfinite(strain[n]))
      throw Error(fmt::format("the strain of cycle {} is not finite; leave it out", n));
  const bool in_range = options.round_off >= 0 && options.significance > 0 && options.significance < 1 &&
                        options.outlier_factor > 0;
  if (!in_range)
    throw Error(
        fmt::format("round-off {}, significance {} and factor {}; give 0 or more, 0 to 1, and above 0",
                    options.round_off, options.significance, options.outlier_factor));
}

// What the classes are decided by.
struct Statistics {
  std::span<const double> kept;
  Classification& c;
  const ClassOptions& options;
  Repetition repetition;
  Outliers outliers;
  Settling settling;

  Class kind() const {
    if (c.range <= c.round_off) return Class::constant;
    if (c.line.ratchets()) return Class::ratcheting;
    if (repetition.probability < options.significance) return Class::periodic;
    if (!outliers.places.empty()) return Class::outliers;
    if (settling.probability < options.significance) return Class::shakedown;
    return Class::irregular;
  }
};

std::string irregular_reason(const Statistics& s) {
  const std::span<const double> half = s.kept.subspan(s.kept.size() / 2);
  const StraightLine line = fit_line(half);
  std::string reason = fmt::format(
      "deviations of {:.2e} (rms) from a straight line, slope {:.3e} per cycle; chance of such a repetition {:.2g}, "
      "of increments that fall so {:.2g}, both above {}; {} cycles stand off",
      s.c.line.rms, s.c.line.slope, s.repetition.probability, s.settling.probability, s.options.significance,
      s.outliers.places.size());
  if (line.ratchets())
    reason += fmt::format("; the last {} alone ratchet by {:.3e} per cycle (rms {:.2e})", half.size(),
                          line.slope, line.rms);
  return reason;
}

std::string reason_of(const Statistics& s, Class kind) {
  switch (kind) {
    case Class::constant:
      return fmt::format("the strain stays within {:.2e}, at most the round-off {:.2e}", s.c.range,
                         s.c.round_off);
    case Class::ratcheting:
      return fmt::format(
          "deviations of {:.2e} (rms) from a straight line, below its slope of {:.3e} per cycle",
          s.c.line.rms, s.c.line.slope);
    case Class::periodic:
      return fmt::format(
          "repeats every {} cycles: F = {:.3g} of ranks between phases, chance {:.2g} over {} periods, below {}",
          s.repetition.period, s.repetition.f, s.repetition.probability, s.repetition.periods,
          s.options.significance);
    case Class::outliers:
      return fmt::format(
          "{} of {} cycles stand off by more than {:.2e} (up to {:.2e}), {} robust standard deviations or the round-off; "
          "the others follow {:.3e} per cycle",
          s.outliers.places.size(), s.kept.size(), s.outliers.threshold, s.outliers.largest,
          s.options.outlier_factor, s.c.robust.slope);
    case Class::shakedown:
      return fmt::format(
          "the strain per cycle falls: rank correlation {:.3f} of {} |increments| over blocks of {} with their place, chance "
          "{:.2g} over {} lengths of blocks, below {}",
          s.settling.correlation, s.settling.increments, s.settling.block, s.settling.probability,
          s.settling.lengths, s.options.significance);
    case Class::irregular:
      break;
  }
  return irregular_reason(s);
}

std::vector<double> deviations(std::span<const double> values, const StraightLine& line, double first) {
  std::vector<double> rest;
  for (std::size_t k = 0; k < values.size(); ++k)
    rest.push_back(values[k] - (line.intercept + line.slope * (first + double(k))));
  return rest;
}

}  // namespace

std::string_view class_name(Class kind) {
  static constexpr std::array<std::string_view, classes> names = {"constant", "ratcheting", "periodic",
                                                                  "outliers", "shakedown",  "irregular"};
  return names[std::size_t(kind)];
}

Classification classify(std::span<const double> strain, const ClassOptions& options) {
  check(strain, options);
  const std::span<const double> kept = strain.subspan(options.drop);
  const double first = double(options.drop);
  Classification c;
  const auto [low, high] = std::minmax_element(kept.begin(), kept.end());
  c.range = *high - *low;
  c.round_off = options.round_off > 0
                    ? options.round_off
                    : ClassOptions::lengths_round_off * std::max({1.0, std::abs(*low), std::abs(*high)});
  c.line = fit_line(kept, first);
  c.robust = robust_line(kept, first);
  const Statistics s{kept,
                     c,
                     options,
                     best_repetition(deviations(kept, c.robust, first)),
                     find_outliers(kept, options.outlier_factor, c.round_off),
                     settling_of(kept)};
  c.kind = s.kind();
  c.reason = reason_of(s, c.kind);
  c.period = c.kind == Class::periodic ? s.repetition.period : 0;
  c.period_probability = s.repetition.probability;
  c.settling_probability = s.settling.probability;
  for (const std::size_t place : s.outliers.places) c.outliers.push_back(options.drop + place);
  return c;
}

}  // namespace scree::cycles
