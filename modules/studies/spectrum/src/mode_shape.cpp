#include "mode_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scree::spectrum {

namespace {

constexpr double least_share = 0.1;  // of the largest displacement, below which the phase of a layer is noise
constexpr double least_return =
    0.25;  // amplitude of the wave that comes back over that which goes, in a standing wave

int nodes_of(const std::vector<double>& displacement) {
  int nodes = 0;
  double before = 0;
  for (const double u : displacement) {
    if (std::abs(u) < least_share) continue;
    nodes += u * before < 0;
    before = u;
  }
  return nodes;
}

// Sum of squares that is left by the sine with so many wavelengths between the ends, of the best phase and amplitude.
double rest_of_sine(const std::vector<double>& displacement, double wavelengths) {
  double ss = 0, sc = 0, cc = 0, us = 0, uc = 0, uu = 0;
  for (std::size_t k = 0; k < displacement.size(); ++k) {
    const double turn =
        2 * std::numbers::pi * wavelengths * ((double(k) + 0.5) / double(displacement.size()) - 0.5);
    const double s = std::sin(turn), c = std::cos(turn), u = displacement[k];
    ss += s * s, sc += s * c, cc += c * c, us += u * s, uc += u * c, uu += u * u;
  }
  const double determinant = ss * cc - sc * sc;
  return uu - (us * us * cc - 2 * us * uc * sc + uc * uc * ss) / determinant;
}

// Of the sine that fits best, from an eighth below half a wavelength for each node to an eighth above one half more.
double wavelengths_of(const std::vector<double>& displacement) {
  constexpr double least = 0.05, beyond = 0.125, step = 1.0 / 256;
  const double nodes = nodes_of(displacement);
  // Beyond half a wavelength in a layer, sines are those of longer waves.
  const double most = std::min(0.5 * (nodes + 1) + beyond, 0.49 * double(displacement.size()));
  double best = least, lowest = std::numeric_limits<double>::infinity();
  for (double at = std::max(least, 0.5 * nodes - beyond); at <= most; at += step)
    if (const double rest = rest_of_sine(displacement, at); rest < lowest) lowest = rest, best = at;
  return best;
}

// Share of the motion that is in one phase: (1 + r)²/(2 (1 + r²)) for waves in both directions with amplitudes 1 and r.
constexpr double least_in_phase =
    (1 + least_return) * (1 + least_return) / (2 * (1 + least_return * least_return));

}  // namespace

ModeShape mode_shape(const std::vector<std::complex<double>>& layers) {
  // sum Re(u e^(iθ))² is largest where the sum of (u e^(iθ))² is real.
  std::complex<double> squares = 0;
  double whole = 0, in_phase = 0;
  for (const std::complex<double>& u : layers) squares += u * u, whole += std::norm(u);
  const std::complex<double> turn = std::polar(1.0, -0.5 * std::arg(squares));
  ModeShape shape;
  for (const std::complex<double>& u : layers) shape.displacement.push_back((u * turn).real());
  for (const double u : shape.displacement) in_phase += u * u;
  const auto largest = std::max_element(shape.displacement.begin(), shape.displacement.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  if (const double scale = *largest; scale != 0)
    for (double& u : shape.displacement) u /= scale;
  if (!(in_phase >= least_in_phase * whole) || whole == 0) return shape;
  constexpr double quarter = 0.25;
  shape.wavelengths = quarter * std::max(1.0, std::round(wavelengths_of(shape.displacement) / quarter));
  return shape;
}

}  // namespace scree::spectrum
