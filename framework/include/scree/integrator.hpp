#pragma once

#include <scree/particles.hpp>
#include <scree/thread_pool.hpp>

namespace scree {

// Velocity Verlet in two halves around the force evaluation, for translation and rotation:
//   v(t + h/2) = v(t) + h/2 F(t)/m,  x(t + h) = x(t) + h v(t + h/2)                               drift
//   v(t + h) = v(t + h/2) + h/2 F(t + h)/m                                                         kick
// Forces that depend on velocity see the prediction v(t) + h F(t)/m, so that damping keeps the second order;
// tangential springs move by the mid-step velocity, so that elastic motion stays time-reversible.
class VelocityVerlet {
 public:
  // Largest squared speed met (m²/s²); infinite if any velocity or position is not a number.
  double drift(Particles& particles, double step, ThreadPool& threads);
  double kick(Particles& particles, double step, ThreadPool& threads);

 private:
  std::vector<double> largest_;
};

}  // namespace scree
