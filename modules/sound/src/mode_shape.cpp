#include "mode_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::sound {

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

// Whether an end is an antinode, from the layer at it and the next one. With θ the phase of the wave over half a layer, sin θ and
// sin 3θ have the ratio 3 − 4 sin² θ at a node, cos θ and cos 3θ 1 − 4 sin² θ at an antinode; this takes the nearer one.
bool is_antinode(double at_end, double next, double half_layer) {
  const double sine = std::sin(half_layer);
  return std::copysign(next, next * at_end) < (2 - 4 * sine * sine) * std::abs(at_end);
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
  const std::vector<double>& u = shape.displacement;
  const double nodes = nodes_of(u), with_antinode = 0.25 + 0.5 * nodes, without = 0.5 + 0.5 * nodes;
  const double half_layer = std::numbers::pi * 0.5 * (with_antinode + without) / double(u.size());
  shape.wavelengths =
      is_antinode(u.front(), u[1], half_layer) || is_antinode(u.back(), u[u.size() - 2], half_layer)
          ? with_antinode
          : without;
  return shape;
}

}  // namespace scree::sound
