#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include <scree/error.hpp>
#include <scree/plugin/formatted.hpp>

namespace scree {

// What a lock-in fits to a record; lock_in.hpp has the equations.
struct LockInOptions {
  double frequency = 0;  // f (Hz) above 0
  double duration = 0;   // (s) above 0: expected length of the record; scales the drift and the offsets k/T
  int harmonics = 3;     // 1 to 3
  int drift_degree = 1;  // 0 to 3
  double origin = 0;     // (s) time to which phases refer
};

// The columns of the least squares of a lock-in: drift, harmonics, and waves beside each harmonic for the
// noise.
namespace lock_in_columns {

using Complex = std::complex<double>;

// 4 of drift, 6 of harmonics, and 20 + 8 + 8 beside them.
inline constexpr std::size_t most = 46;

inline constexpr int farthest_offset = 6;
// Harmonics have fewer offsets than f, which keeps the state small.
inline constexpr std::array<int, 5> near_frequency = {2, 3, 4, 5, 6};
inline constexpr std::array<int, 2> near_harmonics = {2, 4};

// Throws Error unless the options are in range.
inline void check(const LockInOptions& options) {
  const auto refuse = [](const char* what, double value, const char* cure) {
    throw Error(formatted("lock-in: %s %.10g; %s", what, value, cure));
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

inline std::span<const int> all_offsets(int harmonic) {
  return harmonic == 1 ? std::span<const int>(near_frequency) : std::span<const int>(near_harmonics);
}

// An offset of at most 0.4 f stays clear of the neighbouring harmonics and of drift.
inline bool is_used(const LockInOptions& options, int offset) {
  return offset <= 0.4 * options.frequency * options.duration;
}

// Offsets (1/duration) beside a harmonic at which noise is measured, each on both sides. A short record has
// fewer.
inline std::vector<int> noise_offsets(const LockInOptions& options, int harmonic) {
  std::vector<int> offsets;
  for (const int offset : all_offsets(harmonic))
    if (is_used(options, offset)) offsets.push_back(offset);
  return offsets;
}

// Number of columns of drift and of sines and cosines of the harmonics.
inline std::size_t of_model(const LockInOptions& options) {
  return std::size_t(options.drift_degree + 1 + 2 * options.harmonics);
}

// The same with the waves beside the harmonics.
inline std::size_t of_all(const LockInOptions& options) {
  std::size_t count = of_model(options);
  for (int h = 1; h <= options.harmonics; ++h) count += 4 * noise_offsets(options, h).size();
  return count;
}

// Only the fraction of the number of turns matters.
inline Complex turned(double turns) {
  const double angle = 2 * std::numbers::pi * (turns - std::floor(turns));
  return {std::cos(angle), std::sin(angle)};
}

inline double* add_wave(const Complex& wave, double* column) {
  *column++ = wave.imag();
  *column++ = wave.real();
  return column;
}

inline double* add_drift(int degree, double u, double* column) {
  const std::array legendre = {1.0, u, 1.5 * u * u - 0.5, (2.5 * u * u - 1.5) * u};
  for (int k = 0; k <= degree; ++k) *column++ = legendre[std::size_t(k)];
  return column;
}

// Values of all columns at a time (s) after the start.
inline void fill(const LockInOptions& options, double since_start, double* column) {
  const double share = since_start / options.duration;
  column = add_drift(options.drift_degree, 2 * share - 1, column);
  const Complex first = turned(options.frequency * since_start), beat = turned(share);
  const std::array<Complex, 4> harmonic = {1, first, first * first, first * first * first};
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

}  // namespace lock_in_columns

}  // namespace scree
