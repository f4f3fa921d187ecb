#pragma once

#include <cmath>
#include <cstdint>

namespace scree {

// The waves with which walls are driven, for Program: functions of time with their derivatives. Each begins
// at t = 0 and is 0 before.
namespace waveform {

inline constexpr double pi = 3.14159265358979323846;

// A function of time and its derivative.
struct Value {
  double value = 0, rate = 0;
};
inline Value operator*(const Value& a, const Value& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate};
}

// Rises from 0 to 1 within a time (s), with continuous derivative; 1 from the start if the time is 0.
inline Value rise(double time, double within) {
  if (time < 0) return {0, 0};
  if (time >= within) return {1, 0};
  const double angle = 0.5 * pi * time / within;
  return {std::sin(angle) * std::sin(angle), pi / within * std::sin(angle) * std::cos(angle)};
}
// Rises after t = 0 and falls before `end` (s).
inline Value window(double time, double end, double within) {
  const Value fall = rise(end - time, within);
  return rise(time, within) * Value{fall.value, -fall.rate};
}

// sin(2π f t + φ).
inline Value sine(double time, double frequency_hz, double phase) {
  const double omega = 2 * pi * frequency_hz;
  return {std::sin(omega * time + phase), omega * std::cos(omega * time + phase)};
}

// Sine whose frequency goes from f₀ to f₁ in a time T (s): f = f₀ + (f₁ − f₀) t/T, or logarithmically
// f = f₀ (f₁/f₀)^(t/T).
inline Value chirp(double time, double from_hz, double to_hz, double duration, bool logarithmic) {
  const double share = time / duration;
  double cycles = 0, frequency_hz = 0;
  if (logarithmic && from_hz != to_hz) {
    const double growth = std::log(to_hz / from_hz);
    frequency_hz = from_hz * std::exp(growth * share);
    cycles = (frequency_hz - from_hz) * duration / growth;
  } else {
    frequency_hz = from_hz + (to_hz - from_hz) * share;
    cycles = 0.5 * (from_hz + frequency_hz) * time;
  }
  const double phase = 2 * pi * cycles;
  return {std::sin(phase), 2 * pi * frequency_hz * std::cos(phase)};
}

// exp(−(t − t₀)²/2w²), of width w (s).
inline Value gaussian(double time, double at, double width) {
  const double x = (time - at) / width, value = std::exp(-0.5 * x * x);
  return {value, -x / width * value};
}

// (1 − 2a²) exp(−a²), a = π f (t − t₀): its spectrum is largest at f.
inline Value ricker(double time, double at, double frequency_hz) {
  const double slope = pi * frequency_hz, a = slope * (time - at), square = a * a, bell = std::exp(-square);
  return {(1 - 2 * square) * bell, slope * a * (4 * square - 6) * bell};
}

// Σ sin(2π (f₀ + k Δf) t + φ_k) over phases φ.
inline Value sines(double time, double first_hz, double spacing_hz, const double* phases,
                   std::uint64_t count) {
  Value sum;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Value one = sine(time, first_hz + double(k) * spacing_hz, phases[k]);
    sum.value += one.value, sum.rate += one.rate;
  }
  return sum;
}

}  // namespace waveform

}  // namespace scree
