#include "mode_of_pole.hpp"

#include <algorithm>
#include <cmath>

namespace scree::signals {

namespace {

constexpr double least_share = 0.25;  // of the change by the other poles

// R, or |R| where phases are not known.
std::complex<double> strength_of(const Pole& pole, bool only_amplitudes) {
  return only_amplitudes ? std::sqrt(std::max(pole.strength.real(), 0.0)) : pole.strength;
}

// d/df of R / (f0^2 - f^2 + i f w).
std::complex<double> slope(const Pole& pole, double f, bool only_amplitudes) {
  const std::complex<double> divisor((pole.frequency - f) * (pole.frequency + f), f * pole.width);
  return strength_of(pole, only_amplitudes) * std::complex(2 * f, -pole.width) / (divisor * divisor);
}

}  // namespace

Mode mode_of(const ModeFit& fit, std::size_t number, const Response& response) {
  const bool only_amplitudes = response.only_amplitudes;
  const Pole& pole = fit.poles[number];
  const auto first = Eigen::Index(4 * number);
  const Eigen::Matrix4d covariance = fit.covariance.block<4, 4>(first, first);
  const auto error = [&](double f, double w, double re, double im) {
    const Eigen::Vector4d by(f, w, re, im);
    return std::sqrt(by.dot(covariance * by));
  };
  Mode mode;
  mode.frequency = pole.frequency, mode.frequency_error = error(1, 0, 0, 0);
  mode.width = pole.width, mode.width_error = error(0, 1, 0, 0);
  mode.quality = pole.frequency / pole.width;
  mode.quality_error = error(1 / pole.width, -mode.quality / pole.width, 0, 0);
  const std::complex<double> factor = response.factor(pole.frequency);
  const double area = pole.frequency * pole.width / std::abs(factor);
  const double size = std::abs(strength_of(pole, only_amplitudes));
  mode.amplitude = size / area;
  const std::complex<double> by_strength =
      only_amplitudes ? 0.5 / (size * area) : pole.strength / (size * area);
  mode.amplitude_error = error((response.derivative - 1) * mode.amplitude / pole.frequency,
                               -mode.amplitude / pole.width, by_strength.real(), by_strength.imag());
  mode.phase = only_amplitudes ? 0 : std::arg(pole.strength * factor);
  mode.together = fit.poles.size();
  mode.points = response.values.size();
  return mode;
}

bool stands_out(const ModeFit& fit, std::size_t number, bool only_amplitudes) {
  const Pole& pole = fit.poles[number];
  std::complex<double> others = 0;
  for (std::size_t k = 0; k < fit.poles.size(); ++k)
    if (k != number) others += slope(fit.poles[k], pole.frequency, only_amplitudes);
  const double height = std::abs(strength_of(pole, only_amplitudes)) / (pole.frequency * pole.width);
  return height >= least_share * pole.width * std::abs(others);
}

}  // namespace scree::signals
