#include "motion/verlet.hpp"

#include "machine/instruction_levels.hpp"
#include "motion/motion.hpp"

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
    m.mid_velocity = m.velocity + kick;
    m.velocity = m.mid_velocity + kick;
    m.position += steps * m.mid_velocity;
  });
}

SCREE_EVERY_LEVEL bool second_half(const Motions& motions, double step, BodyRange bodies) {
  const double half_step = 0.5 * step;
  Finiteness finite;
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    m.velocity = m.mid_velocity + half_step * m.acceleration;
    finite.check(m.velocity);
  });
  return finite.all_finite();
}

// The second half of a step and the first of the next.
SCREE_EVERY_LEVEL bool second_and_first_half(const Motions& motions, double step, double next,
                                             BodyRange bodies) {
  const double half_step = 0.5 * step, half_next = 0.5 * next;
  const Four nexts = next * motions.axes();
  Finiteness finite;
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    const Four velocity = m.mid_velocity + half_step * m.acceleration, kick = half_next * m.acceleration;
    finite.check(velocity);
    m.mid_velocity = velocity + kick;
    m.velocity = m.mid_velocity + kick;
    m.position += nexts * m.mid_velocity;
  });
  return finite.all_finite();
}

// The two halves of position Verlet.
SCREE_EVERY_LEVEL void position_first_half(const Motions& motions, double step, BodyRange bodies) {
  const double half_step = 0.5 * step;
  const Four half_steps = half_step * motions.axes();
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    m.mid_velocity = m.velocity;
    m.velocity += half_step * m.acceleration;
    m.position += half_steps * m.mid_velocity;
  });
}

SCREE_EVERY_LEVEL bool position_second_half(const Motions& motions, double step, BodyRange bodies) {
  const Four half_steps = 0.5 * step * motions.axes();
  Finiteness finite;
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    m.velocity = m.mid_velocity + step * m.acceleration;
    // The velocity at the time of evaluation, for the energy audit.
    m.mid_velocity = 0.5 * (m.mid_velocity + m.velocity);
    m.position += half_steps * m.velocity;
    finite.check(m.velocity);
  });
  return finite.all_finite();
}

}  // namespace

double VelocityVerlet::begin_step(Particles& particles, double step, BodyRange bodies) {
  const Motions motions(particles);
  first_half(motions, step, bodies);
  return motions.largest_square(bodies, true);
}

bool VelocityVerlet::finish_step(Particles& particles, double step, BodyRange bodies) {
  return second_half(Motions(particles), step, bodies);
}

Integrator::Moved VelocityVerlet::finish_and_begin_step(Particles& particles, double step, double next,
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

double PositionVerlet::begin_step(Particles& particles, double step, BodyRange bodies) {
  const Motions motions(particles);
  position_first_half(motions, step, bodies);
  return motions.largest_square(bodies, false);
}

bool PositionVerlet::finish_step(Particles& particles, double step, BodyRange bodies) {
  return position_second_half(Motions(particles), step, bodies);
}

}  // namespace scree
