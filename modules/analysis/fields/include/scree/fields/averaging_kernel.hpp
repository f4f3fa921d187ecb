#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scree/plugin/vec.hpp>

namespace scree::fields {

// Over a straight line from `start` to start + line, of a kernel at x: integrals over s from 0 to 1.
struct AlongLine {
  double weight;  // (1/m^D) of φ(x − start − s line) ds
  double drop;    // (1/m^D) of line·∇φ ds, which is φ(x − start) − φ(x − start − line)
};

// The weight that a mass at distance r has in the mean at a point:
//   φ(r) = C (1 − r²/w²)³ for r < w, else 0;   C = 315/(64π w³) in 3D, 4/(π w²) in 2D, so that ∫φ = 1.
// It has two continuous derivatives (Goldhirsch, Granul. Matter 12, 239 (2010), leaves φ free). Along a line
// it is a polynomial of degree 6, and line·∇φ one of degree 5: four nodes of Gauss and Legendre, exact up to
// degree 7, integrate both without error.
class AveragingKernel {
 public:
  // dimension: 2 or 3; width: w (m), above 0.
  AveragingKernel(int dimension, double width)
      : width_(width),
        inverse_square_(1 / (width * width)),
        top_(dimension == 2 ? 4 / (std::numbers::pi * width * width)
                            : 315 / (64 * std::numbers::pi * width * width * width)) {}

  double width() const { return width_; }

  // (1/m^D) at a square distance (m²).
  double operator()(double square_distance) const {
    const double rest = std::max(0.0, 1 - square_distance * inverse_square_);
    return top_ * rest * rest * rest;
  }

  // offset: x − start (m).
  AlongLine along(const Vec3& offset, const Vec3& line) const {
    const double square = dot(line, line);
    const double nearest = square > 0 ? dot(offset, line) / square : 0;
    const Vec3 away = offset - nearest * line;
    const double room = width_ * width_ - dot(away, away);
    if (!(room > 0)) return {0, 0};
    const double half_chord = square > 0 ? std::sqrt(room / square) : 1;
    const double from = std::max(0.0, nearest - half_chord), to = std::min(1.0, nearest + half_chord);
    if (!(from < to)) return {0, 0};
    return quadrature(offset, line, from, to);
  }

 private:
  AlongLine quadrature(const Vec3& offset, const Vec3& line, double from, double to) const {
    // Abramowitz and Stegun, table 25.4.
    static constexpr double nodes[] = {-0.861136311594052575, -0.339981043584856265, 0.339981043584856265,
                                       0.861136311594052575};
    static constexpr double weights[] = {0.347854845137453857, 0.652145154862546143, 0.652145154862546143,
                                         0.347854845137453857};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    AlongLine sum = {0, 0};
    for (int node = 0; node < 4; ++node) {
      const Vec3 r = offset - (middle + half * nodes[node]) * line;
      const double rest = std::max(0.0, 1 - dot(r, r) * inverse_square_), part = weights[node] * half;
      sum.weight += part * top_ * rest * rest * rest;
      // ∇φ = −6 C/w² (1 − r²/w²)² r
      sum.drop -= part * 6 * top_ * inverse_square_ * rest * rest * dot(line, r);
    }
    return sum;
  }

  double width_, inverse_square_, top_;
};

}  // namespace scree::fields
