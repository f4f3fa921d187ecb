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

// Triweight: (1 − q²)³. Lucy: (1 + 3q) (1 − q)³; L. B. Lucy, Astron. J. 82, 1013 (1977). q = r/w.
enum class KernelShape { triweight, lucy };
inline constexpr const char* kernel_names[] = {"triweight", "lucy"};  // in the order of the enumeration

// The weight that a mass at distance r has in the mean at a point (Goldhirsch, Granul. Matter 12, 239 (2010),
// leaves φ free), with two continuous derivatives and ∫φ = 1:
//   triweight: φ(r) = C (1 − r²/w²)³ for r < w, else 0;   C = 315/(64π w³) in 3D, 4/(π w²) in 2D.
//   lucy: φ(r) = C (1 + 3r/w) (1 − r/w)³;                 C = 105/(16π w³) in 3D, 5/(π w²) in 2D.
// Along a line triweight is a polynomial of degree 6, and line·∇φ one of degree 5: four nodes of Gauss and
// Legendre, exact up to degree 7, integrate both without error. Lucy has odd powers of r, and is integrated
// in closed form; that of line·∇φ is the difference at the ends itself.
class AveragingKernel {
 public:
  // dimension: 2 or 3; width: w (m), above 0.
  AveragingKernel(int dimension, double width, KernelShape shape = KernelShape::triweight)
      : shape_(shape),
        width_(width),
        inverse_square_(1 / (width * width)),
        top_(factor(dimension, shape) / (std::numbers::pi * std::pow(width, dimension))) {}

  double width() const { return width_; }
  KernelShape shape() const { return shape_; }

  // (1/m^D) at a square distance (m²).
  double operator()(double square_distance) const {
    const double square = square_distance * inverse_square_;
    if (shape_ == KernelShape::lucy) {
      const double q = std::sqrt(square), below = std::max(0.0, 1 - q);
      return top_ * (1 + 3 * q) * below * below * below;
    }
    const double rest = std::max(0.0, 1 - square);
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
    if (shape_ == KernelShape::triweight) return quadrature(offset, line, from, to);
    const double length = std::sqrt(square), d = norm(away) / width_;
    const auto at = [&](double s) { return lucy_integral((s - nearest) * length / width_, d); };
    const Vec3 end = offset - line;
    const double mean = square > 0 ? (at(to) - at(from)) * width_ / length * top_ : (*this)(dot(away, away));
    return {mean, (*this)(dot(offset, offset)) - (*this)(dot(end, end))};
  }

 private:
  static constexpr double factor(int dimension, KernelShape shape) {
    if (shape == KernelShape::lucy) return dimension == 2 ? 5.0 : 105.0 / 16;
    return dimension == 2 ? 4.0 : 315.0 / 64;
  }

  // ∫₀ᵘ 1 − 6q² + 8q³ − 3q⁴ du with q² = u² + d², all over w.
  static double lucy_integral(double u, double d) {
    const double uu = u * u, dd = d * d, q = std::sqrt(uu + dd);
    const double cube = u * q * (2 * uu + 5 * dd) + (d > 0 ? 3 * dd * dd * std::asinh(u / d) : 0);  // of 8 q³
    return u * (1 - 6 * (dd + uu / 3) - 3 * (dd * dd + uu * (2 * dd / 3 + uu / 5))) + cube;
  }

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

  KernelShape shape_;
  double width_, inverse_square_, top_;
};

}  // namespace scree::fields
