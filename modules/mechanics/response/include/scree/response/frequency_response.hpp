#pragma once

#include <atomic>
#include <vector>

#include <Eigen/Core>

#include <scree/response/linear_system.hpp>

namespace scree::response {

// What drives a packing, as complex amplitudes of e^(iωt); empty vectors drive nothing.
struct Drive {
  Eigen::VectorXcd force = {};  // on each degree of freedom (N), (N m)
  Eigen::VectorXcd walls = {};  // w of each wall along each axis (m), as in LinearSystem
};

// The steady motion Re(amplitude e^(iωt)) at one frequency.
struct HarmonicResponse {
  double frequency_hz;
  Eigen::VectorXcd amplitude;  // of each degree of freedom (m), (rad)
  // |r|/|f|, r = f − A q, in mass-weighted coordinates √M q; 0 without a drive. A mass of 0 is replaced in √M
  // by one that scales its stiffness like the others.
  double residual;
  double error;  // |A⁻¹ r|/|q| in the same coordinates, an estimate of the relative error of the amplitude
};

// Solves A q = f, A = K + iωC − ω²M, f = force − (K_w + iωC_w − ω²M_w) walls, by a factorisation at each
// frequency. Throws Error if the drive has another size, or if A is singular. Once `*stop` is true the
// remaining frequencies are left out.
std::vector<HarmonicResponse> solve(const LinearSystem& system, const Drive& drive,
                                    const std::vector<double>& frequencies_hz,
                                    const std::atomic<bool>* stop = nullptr);

}  // namespace scree::response
