#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::spectrum {

// A column of a probe whose response to a drive is measured.
struct ObservedColumn {
  std::size_t probe = 0, column = 0;  // indices of the plan's probe and of its column
  std::string name, unit;             // "<probe>.<column>"
  bool relative = false;              // divided by its mean
  std::string place;                  // file:line:column, for messages
  bool of_shape = false;              // a layer of the shapes of peaks; has no peaks
};

// Number of columns that have peaks; the layers of shapes follow them.
inline std::size_t responding(const std::vector<ObservedColumn>& observed) {
  std::size_t count = 0;
  while (count < observed.size() && !observed[count].of_shape) ++count;
  return count;
}

// [spectrum.sweep]; the values here are the defaults of its keys.
struct SweepSettings {
  enum class Direction { up, down, both };
  enum class Detrending { period_average, polynomial };

  Direction direction = Direction::up;
  double periods = 100, analysed_periods = 60;  // at each frequency
  double samples_per_period = 50;
  double rise_periods = 5;  // of the first frequency
  Detrending detrending = Detrending::period_average;
  bool adaptive = false;
  double tolerance = 1e-3;  // relative change of a response that counts as steady
};

// [spectrum.pulse].
struct PulseSettings {
  enum class Form { gaussian, ricker, chirp, noise };
  // The frequencies of a chirp and of noise extend beyond the band by this share of from_hz on each side; a
  // chirp rises and falls there.
  static constexpr double band_margin = 0.5;

  Form form = Form::gaussian;
  double samples_per_period = 50;  // at to_hz
  double chirp_duration = 0;       // (s); default 10 / from_hz
  double decay = 1e-4;             // integral of |response| after the record over the integral in it
  double longest = 0;              // (s) of a record; default 30 / step_hz
  double noise_rms = 0;            // (m); required for noise
  double noise_duration = 0;       // (s); default 30 / step_hz

  double longest_record() const { return form == Form::noise ? noise_duration : longest; }  // (s)
};

// [spectrum.linear].
struct LinearSettings {
  bool adaptive = false;
  double tolerance = 1e-3;      // relative error of a response with many degrees of freedom
  int fewest_contacts = 0;      // of a body that is held; 0: 2 with friction, else one more than dimensions
  bool contacts_slide = false;  // at the limit of friction
  bool step_of_run = false;     // instead of the limit of short steps
};

// What [spectrum] says: how the response of a packing to a driven wall is measured over frequency.
struct SpectrumPlan {
  std::string boundary, key;  // of the displacement that takes the wave
  std::string drive_place;    // file:line:column, for messages
  double amplitude = 0;       // (m) largest displacement in a sweep or pulse
  std::vector<ObservedColumn> observed;
  double from_hz = 0, to_hz = 0, step_hz = 0;
  SweepSettings sweep;
  PulseSettings pulse;
  LinearSettings linear;
  std::vector<scenario::Expectation> expectations;  // of peaks

  // (m) of a pulse, or the rms of noise.
  double pulse_amplitude() const {
    return pulse.form == PulseSettings::Form::noise ? pulse.noise_rms : amplitude;
  }
  // from_hz, from_hz + step_hz, ... up to to_hz.
  std::vector<double> frequencies() const;
};

// Reads [spectrum] in the document of a plan whose scene and probes are known; nothing without it. Throws
// Error "file:line:column: what is wrong; what to do" at the wrong key.
std::optional<SpectrumPlan> read_spectrum(const scenario::Plan& plan);

// [spectrum] for scenario::read_plan.
scenario::StudyTable spectrum_table();

}  // namespace scree::spectrum
