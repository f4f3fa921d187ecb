#pragma once

#include "band/backend/band_backend.hpp"

#include <Eigen/Core>

#include <scree/response/undamped_system.hpp>

namespace scree::response {

struct StaticSolution {
  Eigen::VectorXd displacement;  // q (m), (rad)
  double residual;  // |f − K q|/|f| in the coordinates √M q, parts along floppy modes included
};

// Solves K q = f with the full K by GMRES, q and f without their parts along floppy modes, which move nothing
// else. inverse: factors of K_s − σM for a σ just below 0. floppy: modes q by columns, normalised to qᵀ M q =
// 1.
StaticSolution solve_static(const UndampedSystem& system, const ShiftedFactors& inverse,
                            const Eigen::MatrixXd& floppy, const Eigen::VectorXd& force);

}  // namespace scree::response
