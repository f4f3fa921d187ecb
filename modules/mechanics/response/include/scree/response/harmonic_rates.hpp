#pragma once

#include <cmath>
#include <complex>

namespace scree::response {

// Ratios of velocities (1/s) and accelerations (1/s²) of a motion e^(iωt) to its displacement, in continuous
// time or as velocity Verlet with the step h makes them: x_(n+1) − 2 x_n + x_(n−1) = h² a_n.
struct HarmonicRates {
  std::complex<double> exact;      // iω, for prescribed motions
  std::complex<double> predicted;  // v_n + h a_n, which dashpots see at n + 1
  std::complex<double> central;    // v_n, at the end of a step
  std::complex<double> backward;   // (x_n − x_(n−1))/h, for walls without mass
  double square;                   // −a/x: ω²

  // time_step: (s), 0 for continuous time.
  HarmonicRates(double time_step, double omega)
      : exact(0, omega), predicted(exact), central(exact), backward(exact), square(omega * omega) {
    if (time_step == 0) return;
    const double turn = omega * time_step, half = std::sin(0.5 * turn), sine = std::sin(turn),
                 versine = 2 * half * half;  // 1 − cos
    predicted = {versine * versine / time_step, sine * (1 + versine) / time_step};
    central = {0, sine / time_step};
    backward = {versine / time_step, sine / time_step};
    square = 2 * versine / (time_step * time_step);
  }
};

}  // namespace scree::response
