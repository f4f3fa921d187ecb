#include "motion.hpp"

#include "instruction_levels.hpp"

#include <algorithm>

namespace scree {

namespace {

constexpr std::size_t lanes = 8;

// Raises the largest square of each lane; counts the squares that are not finite.
SCREE_EVERY_LEVEL std::size_t raise(double (&largest)[lanes], const double* x, const double* y,
                                    const double* z, std::size_t begin, std::size_t end) {
  std::size_t unbounded = 0;
  std::size_t i = begin;
  const auto look = [&](std::size_t body, std::size_t lane) {
    const double square = x[body] * x[body] + (y ? y[body] * y[body] : 0.0) + (z ? z[body] * z[body] : 0.0);
    largest[lane] = square > largest[lane] ? square : largest[lane];
    unbounded += square < infinity ? 0 : 1;
  };
  for (; i + lanes <= end; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) look(i + lane, lane);
  for (; i < end; ++i) look(i, 0);
  return unbounded;
}

}  // namespace

double largest_square(const Column<double> (&v)[3], Particles::Axes axes, BodyRange bodies) {
  if (axes.first == axes.last) return 0;
  const auto column = [&](int k) { return k < axes.last ? v[k].data() : nullptr; };
  double largest[lanes] = {};
  if (raise(largest, v[axes.first].data(), column(axes.first + 1), column(axes.first + 2), bodies.begin,
            bodies.end) > 0)
    return infinity;
  return *std::max_element(largest, largest + lanes);
}

}  // namespace scree
