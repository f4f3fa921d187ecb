#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::spectrum {

// Methods that have peaks, as spectrum.json names them.
inline constexpr std::array<const char*, 4> method_names = {"linear", "pulse", "sweep", "sweep_down"};
// Numbers of a peak in spectrum.json: frequency (Hz), quality, amplitude, with their errors.
inline constexpr std::array<const char*, 7> peak_numbers = {
    "frequency", "frequency_error", "quality",    "quality_error",
    "amplitude", "amplitude_error", "wavelengths"};

// A number of a peak, "peaks.<method>.<probe>.<column>.<peak>.<number>".
struct PeakQuantity {
  std::size_t method, column;  // in method_names, and in SpectrumPlan::observed
  std::string peak;            // "peak_3", the third by frequency; or the name that its shape gives, "3λ/4"
  std::size_t number;          // in peak_numbers
};

// Whether a quantity is meant as one of a peak.
bool names_peak(std::string_view quantity);
// The parts of a quantity; nothing if it names no number of a peak. "3lambda/4" is read as "3λ/4"; such names
// need layers in `observed`.
std::optional<PeakQuantity> peak_quantity(std::string_view name, const std::vector<ObservedColumn>& observed);
// Names of the numbers of the first peaks, to find one that is spelt similarly.
std::vector<std::string> peak_quantity_names(const std::vector<ObservedColumn>& observed);
// Returns "no quantity '<name>'; <cure>" unless peak_quantity() finds it.
std::optional<std::string> peak_quantity_problem(const std::string& name,
                                                 const std::vector<ObservedColumn>& observed);

}  // namespace scree::spectrum
