#pragma once

#include "bodies/body_range.hpp"
#include "machine/lanes.hpp"

#include <bit>
#include <cstdint>
#include <limits>

#include <scree/particles.hpp>

namespace scree {

inline constexpr double infinite_speed = std::numeric_limits<double>::infinity();

// Translation of a body (in 2D together with its rotation), or its rotation in 3D; four numbers each.
// Components that do not move have zero acceleration.
struct Motion {
  kernel::Four &velocity,
      &mid_velocity;          // (m/s), (rad/s); mid: displacement / time since the last evaluation
  kernel::Four& position;     // (x, y, z, R); unused for a rotation in 3D
  kernel::Four acceleration;  // of the last evaluation (m/s²), (rad/s²)
  std::size_t number;         // index of this motion
};

// Detects numbers that are not finite: the difference of any other number with itself has no bit set.
class Finiteness {
 public:
  SCREE_HOT void check(const kernel::Four& v) { found_ |= std::bit_cast<Bits>(v - v); }
  bool all_finite() const { return (found_[0] | found_[1] | found_[2] | found_[3]) == 0; }

 private:
  typedef std::int64_t Bits __attribute__((vector_size(32)));
  Bits found_ = {};
};

// The motions of all bodies: one each, or in 3D with spin two.
class Motions {
 public:
  explicit Motions(Particles& particles)
      : records_(particles.records()),
        loads_(particles.loads()),
        flat_(particles.dimension() == 2),
        spin_(particles.has_spin()) {}

  std::size_t per_body() const { return !flat_ && spin_ ? 2 : 1; }
  // 1 for the components of a position record that move, 0 for the others.
  kernel::Four axes() const { return kernel::Four{1, 1, flat_ ? 0.0 : 1.0, 0}; }

  // Calls move(Motion) for all motions of a range of bodies.
  template <class Move>
  SCREE_HOT void each(BodyRange bodies, const Move& move) const {
    if (flat_)
      each_of<2, true>(bodies, move);
    else if (spin_)
      each_of<3, true>(bodies, move);
    else
      each_of<3, false>(bodies, move);
  }

  // Largest |v|² of a range of bodies, at the end of the step or at mid-step (m²/s²); infinite if any is not
  // finite.
  double largest_square(BodyRange bodies, bool mid_step) const;

 private:
  std::size_t width() const { return record::width(flat_ ? 2 : 3, spin_); }
  const double* part(BodyRange bodies, std::size_t part) const {
    return records_ + bodies.begin * width() + part;
  }
  template <int D, bool spin, class Move>
  SCREE_HOT void each_of(BodyRange bodies, const Move& move) const {
    using namespace kernel;
    constexpr std::size_t motions = D == 3 && spin ? 2 : 1;
    Four unused = {};
    double* body = records_ + bodies.begin * record::width(D, spin);
    const double* load = loads_ + bodies.begin * record::load_width(D, spin);
    for (std::size_t i = bodies.begin; i < bodies.end; ++i) {
      const double by_mass = body[record::motion + 3], by_inertia = body[record::position + 2];
      const Four inverse = D == 2 ? Four{by_mass, by_mass, by_inertia, 0} : by_mass * Four{1, 1, 1, 1};
      move(Motion{four_at(body + record::motion), four_at(body + record::mid_motion),
                  four_at(body + record::position), load_four(load) * inverse, i * motions});
      if constexpr (motions == 2)
        move(Motion{four_at(body + record::spin), four_at(body + record::mid_spin), unused,
                    load_four(load + 4) * body[record::spin + 3], i * motions + 1});
      body += record::width(D, spin);
      load += record::load_width(D, spin);
    }
  }

  double* records_;
  const double* loads_;
  bool flat_, spin_;
};

}  // namespace scree
