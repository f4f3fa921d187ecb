#include "lock_in_columns.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::signals {

namespace {

using Complex = std::complex<double>;

constexpr int farthest_offset = 6;
// Harmonics have fewer offsets than f, which keeps the state small.
constexpr std::array<int, 5> near_frequency = {2, 3, 4, 5, 6};
constexpr std::array<int, 2> near_harmonics = {2, 4};

// Of the nominal number of turns, only the fraction matters.
Complex turned(double turns) {
  const double angle = 2 * std::numbers::pi * (turns - std::floor(turns));
  return {std::cos(angle), std::sin(angle)};
}

double* add_wave(const Complex& wave, double* column) {
  *column++ = wave.imag();
  *column++ = wave.real();
  return column;
}

double* add_drift(int degree, double u, double* column) {
  const std::array legendre = {1.0, u, 1.5 * u * u - 0.5, (2.5 * u * u - 1.5) * u};
  for (int k = 0; k <= degree; ++k) *column++ = legendre[std::size_t(k)];
  return column;
}

std::span<const int> all_offsets(int harmonic) {
  return harmonic == 1 ? std::span<const int>(near_frequency) : std::span<const int>(near_harmonics);
}

// An offset of 0.4 f stays clear of the neighbouring harmonics and of drift.
bool is_used(const LockInOptions& options, int offset) {
  return offset <= 0.4 * options.frequency * options.duration;
}

}  // namespace

std::vector<int> noise_offsets(const LockInOptions& options, int harmonic) {
  std::vector<int> offsets;
  for (const int offset : all_offsets(harmonic))
    if (is_used(options, offset)) offsets.push_back(offset);
  return offsets;
}

std::size_t model_columns(const LockInOptions& options) {
  return std::size_t(options.drift_degree + 1 + 2 * options.harmonics);
}

std::size_t all_columns(const LockInOptions& options) {
  std::size_t count = model_columns(options);
  for (int h = 1; h <= options.harmonics; ++h) count += 4 * noise_offsets(options, h).size();
  return count;
}

void fill_columns(const LockInOptions& options, double since_start, double* column) {
  const double share = since_start / options.duration;
  column = add_drift(options.drift_degree, 2 * share - 1, column);
  const Complex first = turned(options.frequency * since_start), beat = turned(share);
  std::array<Complex, 4> harmonic = {1, first, first * first, first * first * first};
  std::array<Complex, farthest_offset + 1> offset = {1};
  for (std::size_t k = 1; k < offset.size(); ++k) offset[k] = offset[k - 1] * beat;
  for (int h = 1; h <= options.harmonics; ++h) column = add_wave(harmonic[std::size_t(h)], column);
  for (int h = 1; h <= options.harmonics; ++h)
    for (const int k : all_offsets(h)) {
      if (!is_used(options, k)) break;
      column = add_wave(harmonic[std::size_t(h)] * offset[std::size_t(k)], column);
      column = add_wave(harmonic[std::size_t(h)] * std::conj(offset[std::size_t(k)]), column);
    }
}

void check(const LockInOptions& options) {
  const auto refuse = [](const char* what, double value, const char* cure) {
    throw Error(fmt::format("lock-in: {} {}; {}", what, value, cure));
  };
  if (!(options.frequency > 0 && std::isfinite(options.frequency)))
    refuse("frequency", options.frequency, "give a frequency above 0 in Hz");
  if (!(options.duration > 0 && std::isfinite(options.duration)))
    refuse("duration", options.duration, "give the length of the record in s, above 0");
  if (options.harmonics < 1 || options.harmonics > 3) refuse("harmonics", options.harmonics, "give 1 to 3");
  if (options.drift_degree < 0 || options.drift_degree > 3)
    refuse("drift degree", options.drift_degree, "give 0 to 3");
  if (!std::isfinite(options.origin)) refuse("origin", options.origin, "give a time in s");
}

}  // namespace scree::signals
