#include "mode_shape.hpp"

#include <algorithm>
#include <cmath>

namespace scree::sound {

namespace {

constexpr double least_share = 0.1;  // of the largest displacement, below which the phase of a layer is noise
constexpr double antinode_share = 0.5;  // of it, above which an end is an antinode

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

}  // namespace

ModeShape mode_shape(const std::vector<std::complex<double>>& layers) {
  // sum Re(u e^(iθ))² is largest where the sum of (u e^(iθ))² is real.
  std::complex<double> squares = 0;
  for (const std::complex<double>& u : layers) squares += u * u;
  const std::complex<double> turn = std::polar(1.0, -0.5 * std::arg(squares));
  ModeShape shape;
  for (const std::complex<double>& u : layers) shape.displacement.push_back((u * turn).real());
  const auto largest = std::max_element(shape.displacement.begin(), shape.displacement.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  if (const double scale = *largest; scale != 0)
    for (double& u : shape.displacement) u /= scale;
  const double ends = std::max(std::abs(shape.displacement.front()), std::abs(shape.displacement.back()));
  const int nodes = nodes_of(shape.displacement);
  shape.wavelengths = ends > antinode_share ? 0.25 + 0.5 * nodes : 0.5 + 0.5 * nodes;
  return shape;
}

}  // namespace scree::sound
