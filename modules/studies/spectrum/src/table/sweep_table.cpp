#include "table/method_tables.hpp"

#include <fmt/format.h>

#include <scree/scenario/table_keys.hpp>

namespace scree::spectrum {

namespace {

using scenario::Range;

const SweepSettings sweep_defaults;

struct SweepKeys : scenario::TableKeys {
  SweepKeys()
      : TableKeys("spectrum.sweep", "[spectrum.sweep]",
                  "the drive stays at each frequency for some periods") {}
  scenario::ChoiceKey direction =
      choice_or_first("direction", {"up", "down", "both"}, "order of frequencies");
  scenario::NumberKey periods =
      number("periods", Range::at_least(3), sweep_defaults.periods, "at each frequency");
  scenario::NumberKey analysed_periods =
      number("analysed_periods", Range::at_least(2), sweep_defaults.analysed_periods,
             "of these, the last ones, from which amplitudes follow");
  scenario::NumberKey samples_per_period =
      number("samples_per_period", Range::between(4, 1e4), sweep_defaults.samples_per_period,
             "of the observed columns");
  scenario::NumberKey rise_periods =
      number("rise_periods", Range::non_negative(), sweep_defaults.rise_periods,
             "of the first frequency, in which the drive rises smoothly");
  scenario::ChoiceKey detrend =
      choice_or_first("detrend", {"period_average", "polynomial"}, "what is done against drift");
  scenario::BooleanKey adaptive = boolean(
      "adaptive", sweep_defaults.adaptive,
      "stay at each frequency until the response is steady, and take all frequencies only where it varies");
  scenario::NumberKey tolerance = number("tolerance", Range::between(1e-9, 0.1), sweep_defaults.tolerance,
                                         "relative change of the response below which it is steady");
};

const SweepKeys sweep_keys;

// Throws Error unless the periods at each frequency can be run, and are enough for what is taken from them.
void check_sweep(const document::Table& spectrum, const document::Table& t, const SpectrumPlan& plan,
                 double step, const SweepSettings& sweep) {
  if (const double steps = sweep.periods / (plan.from_hz * step); !(steps <= scenario::most_steps))
    throw spectrum.error(
        "from_hz",
        fmt::format("{:g} periods of {:g} Hz take {:.3g} time steps", sweep.periods, plan.from_hz, steps),
        fmt::format("give a higher from_hz, or fewer sweep.periods, for at most {:g} steps",
                    scenario::most_steps));
  if (sweep.analysed_periods > sweep.periods)
    throw t.error(t.has(sweep_keys.analysed_periods) ? sweep_keys.analysed_periods : sweep_keys.periods,
                  fmt::format("{:g} analysed periods are more than the {:g} at each frequency",
                              sweep.analysed_periods, sweep.periods),
                  "give fewer analysed_periods, or more periods");
  if (sweep.rise_periods > sweep.periods - sweep.analysed_periods)
    throw t.error(sweep_keys.rise_periods,
                  fmt::format("a rise of {:g} periods reaches into the analysed ones, which begin after {:g}",
                              sweep.rise_periods, sweep.periods - sweep.analysed_periods),
                  "give fewer rise_periods or analysed_periods, or more periods");
  if (sweep.adaptive && sweep.direction == SweepSettings::Direction::both)
    throw t.error(sweep_keys.adaptive, "an adaptive sweep takes each frequency once",
                  "give direction = \"up\" or \"down\"");
}

}  // namespace

SweepSettings read_sweep(const document::Table& spectrum, const SpectrumPlan& plan, double step) {
  const document::Table t = spectrum.table_or_empty("sweep");
  SweepSettings sweep;
  const std::string direction = read(t, sweep_keys.direction);
  sweep.direction = direction == "up"     ? SweepSettings::Direction::up
                    : direction == "down" ? SweepSettings::Direction::down
                                          : SweepSettings::Direction::both;
  sweep.periods = read(t, sweep_keys.periods);
  sweep.analysed_periods = read(t, sweep_keys.analysed_periods);
  sweep.samples_per_period = read(t, sweep_keys.samples_per_period);
  sweep.rise_periods = read(t, sweep_keys.rise_periods);
  sweep.detrending = read(t, sweep_keys.detrend) == "polynomial" ? SweepSettings::Detrending::polynomial
                                                                 : SweepSettings::Detrending::period_average;
  sweep.adaptive = read(t, sweep_keys.adaptive);
  sweep.tolerance = read(t, sweep_keys.tolerance);
  check_sweep(spectrum, t, plan, step, sweep);
  return sweep;
}

const scenario::TableDescription& describe_sweep() { return sweep_keys.description(); }

}  // namespace scree::spectrum
