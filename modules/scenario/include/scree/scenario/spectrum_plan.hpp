#pragma once

#include <optional>
#include <string>
#include <vector>

namespace scree::scenario {

// A column of a probe whose response to a drive is measured.
struct ObservedColumn {
  std::size_t probe = 0, column = 0;  // indices of the plan's probe and of its column
  std::string name, unit;             // "<probe>.<column>"
  bool relative = false;              // divided by its mean
  std::string place;                  // file:line:column, for messages
  bool of_shape = false;              // a layer of the shapes of peaks, which has no peaks of its own
};

// Number of columns that have peaks, which stand before the layers of shapes.
inline std::size_t responding(const std::vector<ObservedColumn>& observed) {
  std::size_t count = 0;
  while (count < observed.size() && !observed[count].of_shape) ++count;
  return count;
}

// The response of a packing to a driven wall over frequency, as [spectrum] describes it.
struct SpectrumPlan {
  enum class Direction { up, down, both };
  enum class Detrending { period_average, polynomial };
  enum class Pulse { gaussian, ricker, chirp, noise };
  // The frequencies of a chirp and of noise begin and end beside the band by this share of from_hz; a chirp rises and falls there.
  static constexpr double band_margin = 0.5;

  std::string boundary, key;  // of the displacement that takes the wave
  std::string drive_place;    // file:line:column, for messages
  double amplitude = 0;       // (m)
  std::vector<ObservedColumn> observed;
  double from_hz = 0, to_hz = 0, step_hz = 0;
  Direction direction = Direction::up;
  double periods = 0, analysed_periods = 0, samples_per_period = 0, rise_periods = 0;
  Detrending detrending = Detrending::period_average;
  bool adaptive = false;
  double tolerance = 0;  // relative error of an adaptive sweep
  Pulse pulse = Pulse::gaussian;
  double chirp_duration = 0;    // (s)
  double decay = 0;             // integral of |response| behind the record of a pulse over that before
  double longest_pulse = 0;     // (s)
  int fewest_contacts = 0;      // see response::AssemblyOptions
  bool contacts_slide = false;  // those at the limit of friction, in the linear response
  bool step_of_run = false;     // in the linear response, instead of the limit of short steps

  // from_hz, from_hz + step_hz, ... up to to_hz.
  std::vector<double> frequencies() const;
};

// What is wrong with a highest frequency (Hz) and a time step (s); nothing if a sample per step determines its sine.
std::optional<std::string> sampling_problem(double to_hz, double step);

}  // namespace scree::scenario
