#include "scree/cycles/classification.hpp"

#include "outliers.hpp"
#include "repetition.hpp"
#include "settling.hpp"
#include "slowing.hpp"

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
                        options.outlier_factor > 0 && options.preference >= 0;
  if (!in_range)
    throw Error(
        fmt::format("round-off {}, significance {}, factor {} and preference {}; give 0 or more, 0 to 1, "
                    "above 0, and 0 or more",
                    options.round_off, options.significance, options.outlier_factor, options.preference));
}

// What decides the class.
struct Statistics {
  std::span<const double> kept;
  Classification& c;
  const ClassOptions& options;
  Repetition repetition;
  Outliers outliers;
  Settling settling;
  std::optional<SlowingDown> slowing_down = {};

  bool goes_on_straight() const { return slowing_down && slowing_down->straight; }
  bool falls() const { return settling.probability < options.significance; }

  Class kind() const {
    if (c.range <= c.round_off) return Class::constant;
    if (c.line.ratchets()) return Class::ratcheting;
    if (goes_on_straight() && c.after_settling.ratchets()) return Class::late_ratcheting;
    if (repetition.probability < options.significance) return Class::periodic;
    if (!outliers.places.empty()) return Class::outliers;
    if (!falls()) return Class::irregular;
    const double preference = slowing_down->preference;  // for a limit
    if (std::abs(preference) <= options.preference || goes_on_straight()) return Class::settling;
    if (preference > 0) return Class::shakedown;
    return kept.size() < least_for_law ? Class::settling : Class::creep;
  }
};

StraightLine second_half(std::span<const double> kept) { return fit_line(kept.subspan(kept.size() / 2)); }

std::string irregular_reason(const Statistics& s) {
  const StraightLine line = second_half(s.kept);
  std::string reason = fmt::format(
      "deviations of {:.2e} (rms) from a straight line, slope {:.3e} per cycle; chance of such a repetition {:.2g}, "
      "of increments that fall so {:.2g}, both above {}; {} cycles stand off",
      s.c.line.rms, s.c.line.slope, s.repetition.probability, s.settling.probability, s.options.significance,
      s.outliers.places.size());
  if (line.ratchets())
    reason += fmt::format("; the last {} alone ratchet by {:.3e} per cycle (rms {:.2e})",
                          s.kept.size() - s.kept.size() / 2, line.slope, line.rms);
  return reason;
}

// Names the laws that were compared.
std::string laws_text(const SlowingDown& d, Class kind, const ClassOptions& options) {
  if (kind == Class::settling && d.straight)
    return "behind a settling part it goes on along a straight line whose slope is below the deviations";
  const std::string limit = law_text(d.with_limit), none = law_text(d.without_limit);
  if (kind == Class::settling && std::abs(d.preference) > options.preference)
    return fmt::format(
        "{} fits better than {}, but of fewer than {} minima a law that ends may have its shape", none, limit,
        least_for_law);
  if (kind == Class::settling)
    return fmt::format("{} and {} fit alike: criteria differ by {:.2g}, at most {}", limit, none,
                       std::abs(d.preference), options.preference);
  return fmt::format("{}, criterion of Akaike lower by {:.3g} than of {}",
                     kind == Class::creep ? none : limit, std::abs(d.preference),
                     kind == Class::creep ? limit : none);
}

std::string slowing_reason(const Statistics& s, Class kind) {
  return fmt::format(
      "{}; the strain per cycle falls: rank correlation {:.3f} of {} |increments| over blocks of {} with their place, chance "
      "{:.2g} over {} lengths of blocks, below {}",
      laws_text(*s.slowing_down, kind, s.options), s.settling.correlation, s.settling.increments,
      s.settling.block, s.settling.probability, s.settling.lengths, s.options.significance);
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
    case Class::late_ratcheting:
      return fmt::format(
          "settles until cycle {}; from there deviations of {:.2e} (rms) from a straight line, below its slope of {:.3e} per cycle",
          s.options.drop + s.slowing_down->straight_from, s.c.after_settling.rms, s.c.after_settling.slope);
    case Class::shakedown:
    case Class::creep:
    case Class::settling:
      return slowing_reason(s, kind);
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

// Fits the laws, if the strain per cycle may fall.
void find_slowing(Statistics& s) {
  Classification& c = s.c;
  if (c.range <= c.round_off || c.line.ratchets() || !(s.falls() || second_half(s.kept).ratchets())) return;
  s.slowing_down = slowing_down(s.kept, c.round_off, s.options.preference);
  if (!s.slowing_down->straight) return;
  const std::size_t from = s.slowing_down->straight_from;
  c.after_settling = fit_line(s.kept.subspan(from), double(s.options.drop + from));
}

std::optional<Slowing> slowing_of(const Statistics& s, Class kind) {
  switch (kind) {
    case Class::late_ratcheting:
      return s.slowing_down->with_line;
    case Class::shakedown:
      return s.slowing_down->with_limit;
    case Class::creep:
      return s.slowing_down->without_limit;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::string_view class_name(Class kind) {
  static constexpr std::array<std::string_view, classes> names = {"constant", "ratcheting", "late ratcheting",
                                                                  "periodic", "outliers",   "shakedown",
                                                                  "creep",    "settling",   "irregular"};
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
  Statistics s{kept,
               c,
               options,
               best_repetition(deviations(kept, c.robust, first)),
               find_outliers(kept, options.outlier_factor, c.round_off),
               settling_of(kept)};
  find_slowing(s);
  c.kind = s.kind();
  c.slowing = slowing_of(s, c.kind);
  if (c.kind == Class::late_ratcheting) c.ratchets_from = options.drop + s.slowing_down->straight_from;
  c.reason = reason_of(s, c.kind);
  c.period = c.kind == Class::periodic ? s.repetition.period : 0;
  c.period_probability = s.repetition.probability;
  c.settling_probability = s.settling.probability;
  for (const std::size_t place : s.outliers.places) c.outliers.push_back(options.drop + place);
  return c;
}

}  // namespace scree::cycles
