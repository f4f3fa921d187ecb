#pragma once

#include "driven_walls.hpp"
#include "observer.hpp"
#include "start.hpp"

#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

namespace scree::spectrum {

// A run in which a wall makes one pulse, recorded at equal steps as deviations from a run without the pulse.
class PulseRecord {
 public:
  // undriven: that with amplitude 0, which is recorded as far as needed; null for itself.
  PulseRecord(const Start& start, const DrivenWalls& walls, double amplitude, PulseRecord* undriven);

  // Records until the response has decayed, at most for longest_record(). False if it was stopped.
  bool until_decay();
  // Records so many samples. False if it was stopped.
  bool until_samples(std::size_t samples);

  std::size_t samples() const { return drive_.size(); }
  std::uint64_t steps() const { return simulation_->steps() - first_; }
  double interval() const;                                          // (s) between samples
  double end_of_pulse() const;                                      // (s)
  double length() const { return double(samples()) * interval(); }  // (s)
  const std::vector<double>& drive() const { return drive_; }
  const std::vector<double>& column(std::size_t column) const { return columns_[column]; }
  // Integrals of drive and columns times e^(−iωt) over the record.
  std::complex<double> drive_at(double frequency) const { return integral(drive_, frequency); }
  std::complex<double> column_at(std::size_t column, double frequency) const {
    return integral(columns_[column], frequency);
  }
  // The value of a column at the start.
  double at_start(std::size_t column) const { return at_start_[column]; }
  // Largest deviation of a column: of the undriven run from the start, else from the undriven run.
  double largest(std::size_t column) const { return largest(column, 0, samples()); }
  // Estimate of the integral of |column| after the record if it goes on to decay as in the second half of the
  // record; infinite if it did not decay.
  double beyond(std::size_t column) const;
  // The same over the integral of |column| in the record.
  double tail(std::size_t column) const;

 private:
  Wave wave(double amplitude) const;
  Wave noise(double amplitude) const;
  bool sample_next();
  std::complex<double> integral(const std::vector<double>& values, double frequency) const;
  double largest(std::size_t column, std::size_t first, std::size_t last) const;
  std::size_t block() const;

  const Start& start_;
  const DrivenWalls& walls_;
  PulseRecord* undriven_;
  Observer observer_;
  std::unique_ptr<Simulation> simulation_;
  std::uint64_t first_ = 0, stride_ = 1;  // steps
  Wave wave_;
  std::vector<double> at_start_, drive_;
  std::vector<std::vector<double>> columns_;  // of the undriven run: deviations from the start
};

}  // namespace scree::spectrum
