#pragma once

#include <algorithm>
#include <limits>

#include <scree/body_range.hpp>
#include <scree/particles.hpp>

namespace scree {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Largest |v|² of the bodies; infinite if any component is not a number.
double largest_square(const Column<double> (&v)[3], Particles::Axes axes, BodyRange bodies);

// x += step × rate; bodies have no positions of rotation, for which x is null.
[[gnu::always_inline]] inline void move_positions(double* x, const double* rate, double step,
                                                  std::size_t begin, std::size_t end) {
  if (!x) return;
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) x[i] += step * rate[i];
}

// The columns of one axis, of translation or rotation.
struct Axis {
  double *position, *rate, *mid_rate;  // no positions of rotation: nullptr
  const double *load, *inverse_inertia;
  int number;  // 0 to 2 translation, 3 to 5 rotation
};

// Calls move(axis, begin, end) for every axis that the bodies carry, and returns the largest squared speed of
// the velocities told by `speeds`.
template <class Move>
double move_bodies(Particles& p, BodyRange bodies, const Column<double> (&speeds)[3], const Move& move) {
  for (int k = p.axes().first; k < p.axes().last; ++k)
    move(Axis{p.position[k].data(), p.velocity[k].data(), p.mid_velocity[k].data(), p.force[k].data(),
              p.inverse_mass.data(), k},
         bodies.begin, bodies.end);
  for (int k = p.spin_axes().first; k < p.spin_axes().last; ++k)
    move(Axis{nullptr, p.spin[k].data(), p.mid_spin[k].data(), p.torque[k].data(), p.inverse_inertia.data(),
              3 + k},
         bodies.begin, bodies.end);
  // Spins have no limit, but must be numbers.
  const bool spins_finite = largest_square(p.spin, p.spin_axes(), bodies) < infinity;
  return spins_finite ? largest_square(speeds, p.axes(), bodies) : infinity;
}

}  // namespace scree
