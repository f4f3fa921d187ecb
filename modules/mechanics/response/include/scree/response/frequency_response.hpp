#pragma once

#include <atomic>
#include <vector>

#include <Eigen/Core>

#include <scree/response/linear_system.hpp>

namespace scree::response {

// What drives a packing, as complex amplitudes of e^(iωt); empty: nothing.
struct Drive {
  Eigen::VectorXcd force = {};  // on each degree of freedom (N), (N m)
  Eigen::VectorXcd walls = {};  // w of each wall along each axis (m), as in LinearSystem
};

// The steady motion Re(amplitude e^(iωt)) at one frequency.
struct HarmonicResponse {
  double frequency_hz;
  Eigen::VectorXcd amplitude;  // of each degree of freedom (m), (rad)
  // |r|/|f| of r = f − A q in mass-weighted coordinates √M q; 0 without a drive. Where a mass is 0, another
  // takes its place in √M with which its stiffness is as the others.
  double residual;
  double error;  // |A⁻¹ r|/|q| in the same coordinates, an estimate of the relative error of the amplitude
};

// Solves A q = f, A = K + iωC − ω²M, f = force − (K_w + iωC_w − ω²M_w) walls, by a factorisation at each
// frequency.
// Throws Error if the drive has another size, or if A is singular. Frequencies behind that at which `*stop` is true are left out.
std::vector<HarmonicResponse> solve(const LinearSystem& system, const Drive& drive,
                                    const std::vector<double>& frequencies_hz,
                                    const std::atomic<bool>* stop = nullptr);

}  // namespace scree::response
