#pragma once

#include "band/backend/shift_backend.hpp"

#include <Eigen/Core>

#include <scree/response/undamped_system.hpp>

namespace scree::response {

struct StaticSolution {
  Eigen::VectorXd displacement;  // q (m), (rad)
  double residual;               // |f − K q|/|f| in the coordinates √M q, with those parts
};

// Solves K q = f with the full K by GMRES, q and f without their parts along floppy modes, which move nothing else.
// `inverse`: factors of K_s − σM for a σ next to 0, below it; floppy: modes by columns, q normalised to qᵀ M q = 1.
StaticSolution solve_static(const UndampedSystem& system, const ShiftedFactors& inverse,
                            const Eigen::MatrixXd& floppy, const Eigen::VectorXd& force);

}  // namespace scree::response
