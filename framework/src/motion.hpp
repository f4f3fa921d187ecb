#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <scree/particles.hpp>
#include <scree/thread_pool.hpp>

namespace scree {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Largest |v|² of the bodies [begin, end); infinite if any component is not a number.
double largest_square(const Column<double> (&v)[3], Particles::Axes axes, std::size_t begin, std::size_t end);

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

// Calls move(axis, begin, end) for every axis that the bodies carry, in parts for each thread, and returns
// the largest squared speed of the velocities told by `speeds`; `largest` is room for one number per thread.
template <class Move>
double move_bodies(Particles& p, ThreadPool& threads, const Column<double> (&speeds)[3],
                   std::vector<double>& largest, const Move& move) {
  // A few bodies at a time, whose columns stay in the first-level cache.
  constexpr std::size_t few = 128;
  largest.assign(threads.size(), 0);
  threads.run([&](unsigned worker) {
    const auto part = threads.part(p.size(), worker);
    double fastest = 0;
    for (std::size_t begin = part.begin; begin < part.end; begin += few) {
      const std::size_t end = std::min(begin + few, part.end);
      for (int k = p.axes().first; k < p.axes().last; ++k)
        move(Axis{p.position[k].data(), p.velocity[k].data(), p.mid_velocity[k].data(), p.force[k].data(),
                  p.inverse_mass.data(), k},
             begin, end);
      for (int k = p.spin_axes().first; k < p.spin_axes().last; ++k)
        move(Axis{nullptr, p.spin[k].data(), p.mid_spin[k].data(), p.torque[k].data(),
                  p.inverse_inertia.data(), 3 + k},
             begin, end);
      // Spins have no limit, but must be numbers.
      const bool spins_finite = largest_square(p.spin, p.spin_axes(), begin, end) < infinity;
      fastest = std::max(fastest, spins_finite ? largest_square(speeds, p.axes(), begin, end) : infinity);
    }
    largest[worker] = fastest;
  });
  return *std::max_element(largest.begin(), largest.end());
}

}  // namespace scree
