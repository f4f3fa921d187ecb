#include "verlet.hpp"

#include "instruction_levels.hpp"
#include "motion.hpp"

#include <array>
#include <cmath>

namespace scree {

namespace {

// The two halves of velocity Verlet for one axis of the bodies [begin, end).
SCREE_EVERY_LEVEL void first_half(Axis axis, double step, std::size_t begin, std::size_t end) {
  const double half_step = 0.5 * step;
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    const double kick = half_step * axis.load[i] * axis.inverse_inertia[i];
    axis.mid_rate[i] = axis.rate[i] + kick;
    axis.rate[i] = axis.mid_rate[i] + kick;
  }
  move_positions(axis.position, axis.mid_rate, step, begin, end);
}

SCREE_EVERY_LEVEL void second_half(Axis axis, double step, std::size_t begin, std::size_t end) {
  const double half_step = 0.5 * step;
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i)
    axis.rate[i] = axis.mid_rate[i] + half_step * axis.load[i] * axis.inverse_inertia[i];
}

}  // namespace

double VelocityVerlet::drift(Particles& p, double step, BodyRange bodies) {
  return move_bodies(p, bodies, p.mid_velocity, [step](const Axis& axis, std::size_t begin, std::size_t end) {
    first_half(axis, step, begin, end);
  });
}

double VelocityVerlet::kick(Particles& p, double step, BodyRange bodies) {
  return move_bodies(p, bodies, p.velocity, [step](const Axis& axis, std::size_t begin, std::size_t end) {
    second_half(axis, step, begin, end);
  });
}

std::span<const double> FourthOrder::substeps() const {
  static const double p = 1 / (4 - std::cbrt(4.0));
  static const std::array<double, 5> shares = {p, p, 1 - 4 * p, p, p};
  return shares;
}

double PositionVerlet::drift(Particles& p, double step, BodyRange bodies) {
  return move_bodies(p, bodies, p.velocity, [step](const Axis& axis, std::size_t begin, std::size_t end) {
    double *now = axis.rate, *mid = axis.mid_rate, *x = axis.position;
    const double half_step = 0.5 * step;
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      mid[i] = now[i];
      now[i] += half_step * axis.load[i] * axis.inverse_inertia[i];
    }
    move_positions(x, mid, half_step, begin, end);
  });
}

double PositionVerlet::kick(Particles& p, double step, BodyRange bodies) {
  return move_bodies(p, bodies, p.velocity, [step](const Axis& axis, std::size_t begin, std::size_t end) {
    double *now = axis.rate, *mid = axis.mid_rate, *x = axis.position;
    const double half_step = 0.5 * step;
    // mid becomes the velocity at the evaluation, for the energy books.
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      now[i] = mid[i] + step * axis.load[i] * axis.inverse_inertia[i];
      mid[i] = 0.5 * (mid[i] + now[i]);
    }
    move_positions(x, now, half_step, begin, end);
  });
}

}  // namespace scree
