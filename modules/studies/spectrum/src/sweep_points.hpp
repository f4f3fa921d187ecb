#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include <scree/spectrum/spectrum_plan.hpp>
#include <scree/state_transfer.hpp>

namespace scree::spectrum {

// What a sweep found at one frequency.
struct SweepPoint {
  struct Column {
    std::complex<double> response;  // over drive (unit of the column / m)
    double error = 0;               // standard error of |response|
    double mean = 0;                // (unit of the column)
  };

  double frequency = 0;     // (Hz)
  double start = 0;         // (s) simulated
  std::uint64_t steps = 0;  // at this frequency
  double drive = 0;         // (m) amplitude of the wall
  double periods = 0;       // that it took
  bool is_steady = true;  // false if an adaptive sweep gave up before it was, or halves of a fixed one differ
  std::vector<Column> columns;

  // observed: number of columns of a point that is restored.
  void transfer(const StateTransfer& state, std::size_t observed);
};

// The frequencies with which a sweep begins, in its order: all, or those of a coarse grid if it is adaptive.
std::vector<double> first_frequencies(const SpectrumPlan& plan);

// Frequencies of the grid between points where the response varies: its phase by more than 0.4, its logarithm
// by more than 0.3, or at a maximum; in the order of the sweep. Empty if the response follows from the
// points. Two peaks, or one and an antiresonance, between neighbours of the coarse grid can be
// overlooked.
std::vector<double> further_frequencies(const SpectrumPlan& plan, std::vector<SweepPoint> points);

}  // namespace scree::spectrum
