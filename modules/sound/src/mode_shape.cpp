#include "mode_shape.hpp"

#include <algorithm>
#include <cmath>

namespace scree::sound {

namespace {

constexpr double least_share = 0.1;  // of the largest displacement, below which the phase of a layer is noise
constexpr double antinode_share = 0.5;  // of it, above which an end is an antinode
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
  const double ends = std::max(std::abs(shape.displacement.front()), std::abs(shape.displacement.back()));
  const int nodes = nodes_of(shape.displacement);
  shape.wavelengths = ends > antinode_share ? 0.25 + 0.5 * nodes : 0.5 + 0.5 * nodes;
  return shape;
}

}  // namespace scree::sound
