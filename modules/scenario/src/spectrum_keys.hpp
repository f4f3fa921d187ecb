#pragma once

#include "table_keys.hpp"

namespace scree::scenario {

struct SpectrumKeys : TableKeys {
  SpectrumKeys()
      : TableKeys(
            "spectrum", "[spectrum]",
            "the response to a driven wall over frequency, for scree spectrum; stages, if any, run first") {}
  StringKey drive =
      string("drive", "boundary and its displacement, as \"top.displacement\", that takes the wave");
  NumberKey amplitude = number("amplitude", Range::at_least(1e-100, "m"), "of the wave");
  Key observe = other("observe", "[\"probe.column\", ...]", Range::any(), "required", "columns that respond");
  Key relative_to_mean =
      other("relative_to_mean", "[\"probe.column\", ...]", Range::any(), "default none",
            "columns that are divided by their means, such as the distance of two layers for a strain");
  StringKey shape_from =
      string("shape_from",
             "probe whose columns displacement_1, ... give the shapes and names of peaks, such as a profile",
             "default none, also \"\" and []");
  NumberKey from_hz = number("from_hz", Range::positive("Hz"), "lowest frequency");
  NumberKey to_hz = number("to_hz", Range::positive("Hz"), "highest frequency");
  NumberKey step_hz = number("step_hz", Range::positive("Hz"), "distance of frequencies");
  ChoiceKey direction = choice_or_first("direction", {"up", "down", "both"}, "of a sweep");
  NumberKey periods = number("periods", Range::at_least(3), 100, "of a sweep at each frequency");
  NumberKey analysed_periods = number("analysed_periods", Range::at_least(2), 60,
                                      "of these, the last ones, from which amplitudes follow");
  NumberKey samples_per_period =
      number("samples_per_period", Range::between(4, 1e4), 50, "of a sweep and, at to_hz, of a pulse");
  NumberKey rise_periods = number("rise_periods", Range::non_negative(), 5,
                                  "of the first frequency, in which a sweep rises smoothly");
  ChoiceKey detrend =
      choice_or_first("detrend", {"period_average", "polynomial"}, "what is done against drift in a sweep");
  BooleanKey adaptive = boolean(
      "adaptive", false,
      "a sweep stays at each frequency until the response is steady, and takes the grid in full only where it varies; the linear road adds frequencies about maxima narrower than six steps of the grid");
  NumberKey tolerance = number(
      "tolerance", Range::between(1e-9, 0.1), 1e-3,
      "relative error of the linear response of more than 300 degrees of freedom, and of the response that an adaptive sweep takes to be steady");
  ChoiceKey pulse = choice_or_first(
      "pulse", {"gaussian", "ricker", "chirp", "noise"},
      "wave of a pulse, as wide as to_hz needs; a chirp goes from from_hz to to_hz, with more of the drive at each "
      "frequency for its amplitude; noise has the amplitude as its rms, seed of the scene, and lasts for longest_pulse, which is averaged over segments of 2 / step_hz");
  NumberKey chirp_duration = number("chirp_duration", Range::positive("s"),
                                    "of a chirp, in which its frequency rises", "default 10 / from_hz");
  NumberKey decay =
      number("decay", Range::between(1e-12, 0.5), 1e-4,
             "integral of the response to a pulse behind its record, over that before: below it the "
             "response has decayed");
  NumberKey longest_pulse = number("longest_pulse", Range::positive("s"),
                                   "after which the record of a pulse ends anyway", "default 30 / step_hz");
  IntegerKey fewest_contacts =
      integer("fewest_contacts", Range::between(1, 100), "that hold a body in the linear response",
              "default 2, and one more than dimensions without tangential forces");
  ChoiceKey sliding_contacts = choice_or_first(
      "sliding_contacts", {"stick", "slide"},
      "what contacts at the limit of friction do in the linear response: stick, as small oscillations make them, or slide on, one way");
  ChoiceKey linear_step = choice_or_first(
      "linear_step", {"limit", "run"},
      "time step of the linear response: the limit of short steps, or that of the run, with which it is the response that velocity_verlet has, "
      "step by step, to compare with a sweep; takes more factorisations");
};

inline const SpectrumKeys spectrum_keys;

}  // namespace scree::scenario
