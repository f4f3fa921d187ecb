#include "verlet.hpp"

#include "instruction_levels.hpp"
#include "motion.hpp"

#include <array>
#include <cmath>

namespace scree {

using kernel::Four;

namespace {

// The two halves of velocity Verlet.
SCREE_EVERY_LEVEL void first_half(const Motions& motions, double step, BodyRange bodies) {
  const double half_step = 0.5 * step;
  const Four steps = step * motions.axes();
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    const Four kick = half_step * m.acceleration;
    m.mid_rate = m.rate + kick;
    m.rate = m.mid_rate + kick;
    m.place += steps * m.mid_rate;
  });
}

SCREE_EVERY_LEVEL bool second_half(const Motions& motions, double step, BodyRange bodies) {
  const double half_step = 0.5 * step;
  Finiteness finite;
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    m.rate = m.mid_rate + half_step * m.acceleration;
    finite.look_at(m.rate);
  });
  return finite.whole();
}

// The second half of a step and the first of the next.
SCREE_EVERY_LEVEL bool second_and_first_half(const Motions& motions, double step, double next,
                                             BodyRange bodies) {
  const double half_step = 0.5 * step, half_next = 0.5 * next;
  const Four nexts = next * motions.axes();
  Finiteness finite;
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    const Four rate = m.mid_rate + half_step * m.acceleration, kick = half_next * m.acceleration;
    finite.look_at(rate);
    m.mid_rate = rate + kick;
    m.rate = m.mid_rate + kick;
    m.place += nexts * m.mid_rate;
  });
  return finite.whole();
}

// The two halves of position Verlet.
SCREE_EVERY_LEVEL void first_way(const Motions& motions, double step, BodyRange bodies) {
  const double half_step = 0.5 * step;
  const Four half_steps = half_step * motions.axes();
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    m.mid_rate = m.rate;
    m.rate += half_step * m.acceleration;
    m.place += half_steps * m.mid_rate;
  });
}

SCREE_EVERY_LEVEL bool second_way(const Motions& motions, double step, BodyRange bodies) {
  const Four half_steps = 0.5 * step * motions.axes();
  Finiteness finite;
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    m.rate = m.mid_rate + step * m.acceleration;
    // The velocity at the evaluation, for the energy books.
    m.mid_rate = 0.5 * (m.mid_rate + m.rate);
    m.place += half_steps * m.rate;
    finite.look_at(m.rate);
  });
  return finite.whole();
}

}  // namespace

double VelocityVerlet::drift(Particles& particles, double step, BodyRange bodies) {
  const Motions motions(particles);
  first_half(motions, step, bodies);
  return motions.largest_square(bodies, true);
}

bool VelocityVerlet::kick(Particles& particles, double step, BodyRange bodies) {
  return second_half(Motions(particles), step, bodies);
}

Integrator::Moved VelocityVerlet::kick_and_drift(Particles& particles, double step, double next,
                                                 BodyRange bodies) {
  const Motions motions(particles);
  const bool finite = second_and_first_half(motions, step, next, bodies);
  return {finite, motions.largest_square(bodies, true)};
}

std::span<const double> FourthOrder::substeps() const {
  static const double p = 1 / (4 - std::cbrt(4.0));
  static const std::array<double, 5> shares = {p, p, 1 - 4 * p, p, p};
  return shares;
}

double PositionVerlet::drift(Particles& particles, double step, BodyRange bodies) {
  const Motions motions(particles);
  first_way(motions, step, bodies);
  return motions.largest_square(bodies, false);
}

bool PositionVerlet::kick(Particles& particles, double step, BodyRange bodies) {
  return second_way(Motions(particles), step, bodies);
}

}  // namespace scree
