#include "assembly/mass_weighted.hpp"
#include "band/singular.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/KLUSupport>
#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/response/frequency_response.hpp>

namespace scree::response {

namespace {

double ratio(double numerator, double denominator) { return denominator > 0 ? numerator / denominator : 0; }

}  // namespace

Error singular_at(double frequency_hz) {
  return Error(
      frequency_hz == 0
          ? std::string(
                "the response at 0 Hz is infinite: no contact resists some motion, such as that of bodies "
                "with too few contacts; compress the packing, give a larger fewest_contacts, or take a "
                "frequency above 0")
          : fmt::format(
                "the response at {:g} Hz is infinite: an undamped mode has this frequency, or bodies with too "
                "few contacts move freely; add damping, give a larger fewest_contacts, or take another "
                "frequency",
                frequency_hz));
}

std::vector<HarmonicResponse> solve(const LinearSystem& system, const Drive& drive,
                                    const std::vector<double>& frequencies_hz,
                                    const std::atomic<bool>* stop) {
  const MassWeighted weighted(system);
  Eigen::KLU<ComplexMatrix> factors;
  bool analysed = false;
  std::vector<HarmonicResponse> responses;
  for (const double frequency : frequencies_hz) {
    if (stop && *stop) break;
    const double omega = 2 * std::numbers::pi * frequency;
    const ComplexMatrix matrix = weighted.dynamic_stiffness(omega);
    const Eigen::VectorXcd load = weighted.load(drive, omega);
    if (!analysed) factors.analyzePattern(matrix);
    analysed = true;
    factors.factorize(matrix);
    if (factors.info() != Eigen::Success) throw singular_at(frequency);
    Eigen::VectorXcd q = factors.solve(load);
    if (!(q.norm() * matrix.norm() <= largest_amplification * load.norm())) throw singular_at(frequency);
    // One refinement, whose result is as exact as round-off of the matrix permits.
    q += factors.solve(load - matrix * q);
    const Eigen::VectorXcd residual = load - matrix * q, correction = factors.solve(residual);
    responses.push_back({frequency, weighted.amplitude(q), ratio(residual.norm(), load.norm()),
                         ratio(correction.norm(), q.norm())});
  }
  return responses;
}

}  // namespace scree::response
