#pragma once

#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include <scree/spectrum/peak_quantity.hpp>
#include <scree/spectrum/spectrum_plan.hpp>
#include <scree/state_transfer.hpp>

namespace scree::spectrum {

// How the response of a packing to a driven wall is measured; the places of the names in method_names.
enum class Method { linear, pulse, sweep };

// What a method found: response over drive at each frequency.
struct MethodSpectrum {
  struct Column {
    // (unit of the column / m); e^(iωt), so that the phase is that by which the response precedes the drive.
    std::vector<std::complex<double>> response;
    std::vector<double> error;  // (the same) of |response|, as the method estimates it
    std::vector<double>
        linearity;  // (the same) change at half the amplitude, of a pulse; of `linear`: see linear.hpp
  };

  std::string method;               // "linear", "pulse", "sweep", "sweep_down"
  std::vector<double> frequencies;  // (Hz) increasing
  std::vector<Column> columns;      // as SpectrumPlan::observed
  std::uint64_t steps = 0;
  double wall_time = 0;            // (s)
  std::vector<std::string> notes;  // "<what>; <cure>"

  // Place of the frequency next to this one (Hz). There is at least one.
  std::size_t nearest(double frequency) const;

  // Adds a note for each column of `observed` that is 0 at all frequencies.
  void note_silent(const std::vector<ObservedColumn>& observed);

  // observed: number of columns of a method that is restored, unless it has no frequencies.
  void transfer(const StateTransfer& state, std::size_t observed);
};

}  // namespace scree::spectrum
