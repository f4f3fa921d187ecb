#include "mode_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scree/available_memory.hpp>
#include <scree/counted.hpp>
#include <scree/error.hpp>

namespace scree::modes {

namespace {

constexpr double largest_hz = 1e100;  // its square, of which matrices are shifted, is finite

double frequency_of(double square) { return std::sqrt(square) / (2 * std::numbers::pi); }

void check_memory(const response::UndampedSystem& system, unsigned modes) {
  // The basis of the iteration has twice as many vectors as are wanted and some blocks more; it is turned
  // into a copy, and modes are kept beside it.
  constexpr double vectors_per_mode = 2, other_vectors = 150, copies = 3;
  const auto rows = double(system.modes());
  const double bytes = 8 * rows * copies * std::min(rows, vectors_per_mode * modes + other_vectors);
  if (const double there = available_memory(); bytes > there)
    throw Error(fmt::format(
        "{} modes of {} degrees of freedom need about {:.3g} GB of memory, but this computer has {:.3g} GB; ask for "
        "fewer --modes, near to a frequency (--near)",
        modes, system.modes(), 1e-9 * bytes, 1e-9 * there));
}

std::string numbers_above(const Vibration& vibration, double residual_limit) {
  std::string numbers;
  for (const Mode& m : vibration.modes)
    if (m.kind == ModeKind::vibrating && m.residual > residual_limit)
      numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", m.number);
  return numbers;
}

}  // namespace

void check_density(const VibrationOptions& options) {
  if (!(options.density_to_hz <= largest_hz))
    throw Error(
        fmt::format("{:g} Hz is above {:g} Hz, up to which modes can be counted; give a lower --density-to",
                    options.density_to_hz, largest_hz));
}

void check_search(const response::UndampedSystem& system, const VibrationOptions& options) {
  const double highest = frequency_of(system.largest()), floppy = frequency_of(system.rounding());
  if (options.near_hz > highest)
    throw Error(fmt::format("all modes are below {:g} Hz; give a lower --near", highest));
  if (options.density > 0 && options.density_to_hz > 0 && options.density_to_hz <= floppy)
    throw Error(fmt::format("no mode below {:g} Hz can be told from a floppy one; give a higher --density-to",
                            floppy));
  check_memory(system, options.modes);
}

std::vector<std::string> mode_warnings(const Vibration& vibration, bool of_full_stiffness,
                                       double residual_limit) {
  std::vector<std::string> warnings;
  if (!of_full_stiffness)
    warnings.push_back(
        "unstable and floppy modes are those of the symmetric part of K, and with all of it some may be neither: its "
        "asymmetry, by sliding contacts, is large; let the packing come to rest with less sliding");
  if (vibration.unstable > 0)
    warnings.push_back(
        fmt::format("the packing is unstable: {} (modes.csv); let it come to rest, or hold what is loose",
                    counted(vibration.unstable, "mode grows", "modes grow")));
  if (vibration.floppy > 0)
    warnings.push_back(fmt::format(
        "K is singular at 0 Hz: {} floppy; see floppy.csv, or leave {} bodies out by --fewest-contacts",
        counted(vibration.floppy, "mode is", "modes are"), vibration.floppy == 1 ? "its" : "their"));
  if (const std::string numbers = numbers_above(vibration, residual_limit); !numbers.empty())
    warnings.push_back(fmt::format(
        "with the full, asymmetric K residuals are above {1:g}, those of: {0}; take these frequencies as approximate",
        numbers, residual_limit));
  if (!vibration.complete && !vibration.modes.empty())
    warnings.push_back(
        "the count of modes does not confirm that none is left out; ask for more with --modes");
  return warnings;
}

}  // namespace scree::modes
