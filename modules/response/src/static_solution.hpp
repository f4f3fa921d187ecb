#pragma once

#include "band/shift_backend.hpp"

#include <Eigen/Core>

#include <scree/response/undamped_system.hpp>

namespace scree::response {

struct StaticSolution {
  Eigen::VectorXd displacement;  // q (m), (rad)
  double residual;               // |f − K q|/|f| in the coordinates √M q
};

// Solves K q = f with the full K by GMRES; `inverse`: factors of K_s − σM for a σ next to 0, below it.
StaticSolution solve_static(const UndampedSystem& system, const ShiftedFactors& inverse,
                            const Eigen::VectorXd& force);

}  // namespace scree::response
