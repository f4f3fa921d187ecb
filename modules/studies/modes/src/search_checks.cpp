#include "search_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scree/available_memory.hpp>
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

}  // namespace scree::modes
