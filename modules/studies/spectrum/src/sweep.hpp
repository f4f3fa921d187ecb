#pragma once

#include "driven_walls.hpp"
#include "observer.hpp"
#include "start.hpp"
#include "sweep_points.hpp"
#include "tone.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <scree/spectrum/method_spectrum.hpp>

namespace scree::spectrum {

// One simulation through all frequencies, driven at each for some periods by a sine that continues the last
// one in displacement; its velocity changes by the ratio of the frequencies. The response in the last periods
// is analysed. An adaptive sweep stays until the response is steady, for at most `longest` times as many
// periods.
class Sweep {
 public:
  static constexpr double longest = 4;

  explicit Sweep(const Start& start);
  // Continues from a state that save() wrote.
  Sweep(const Start& start, const State& state);

  // Measures until all frequencies are done or `Start::stop` is true; calls `measured` after each frequency,
  // when the simulation can be saved. An incomplete frequency is dropped.
  void run(const std::function<void()>& measured);
  // The simulation and the points so far. Only after a frequency.
  State save();
  const std::vector<SweepPoint>& points() const { return points_; }
  // The drive of the current frequency, with which the scene of a saved sweep is made again. Only after a
  // frequency.
  Wave wave() const { return wave_at(points_.back().frequency); }
  // A spectrum for each direction.
  std::vector<MethodSpectrum> spectra() const;

 private:
  void transfer(const StateTransfer& state);
  // Throws Error unless the frequencies of a state are those of the plan, and its points are at them.
  void check_restored(const StateTransfer& state) const;
  Wave wave_at(double frequency) const;
  // Nothing if it was stopped.
  std::optional<SweepPoint> measure(double frequency);
  bool measure_last_periods(SweepPoint& point);
  bool measure_until_steady(SweepPoint& point);
  // Called with time (s) since the start of the frequency, drive (m), and values of the columns.
  using AddSample = std::function<void(double, double, const std::vector<double>&)>;
  // Samples the steps from one to another of the present tone.
  bool record(const AddSample& add, double frequency, std::uint64_t first, std::uint64_t last);
  bool advance_to(std::uint64_t step);
  double drive_at(double frequency, double time) const;
  std::vector<double> scales() const;
  void report_progress();
  std::uint64_t steps_at(double frequency, double periods) const;
  MethodSpectrum spectrum_of(const char* name, std::size_t first, std::size_t last) const;

  const Start& start_;
  std::vector<double> frequencies_;  // in the order of the sweep, as far as it is known
  DrivenWalls walls_;
  Observer observer_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<SweepPoint> points_;
  double phase_ = 0;                        // (rad) of the drive, now
  double began_phase_ = 0;                  // (rad) of the drive when the present tone began
  std::uint64_t tone_first_ = 0;            // step at which the present tone began
  double wall_time_ = 0, last_report_ = 0;  // (s)
};

}  // namespace scree::spectrum
