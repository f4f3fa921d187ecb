#include "modes/krylov.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree::response;

namespace {

// Diagonal: eigenvalues from 1 to 2 that lie close, so that the iteration restarts, and 4, which is found
// before it does.
constexpr Eigen::Index krylov_size = 400, wanted_modes = 6, block_width = 2;

Eigen::VectorXd eigenvalues() {
  Eigen::VectorXd all = Eigen::VectorXd::LinSpaced(krylov_size, 1, 2);
  all[0] = 4;
  return all;
}

Eigen::MatrixXd start() {
  return Eigen::MatrixXd::NullaryExpr(krylov_size, block_width, [](Eigen::Index r, Eigen::Index c) {
    return std::sin(1.3 * double(r + 1) * double(c + 1)) + 0.1;
  });
}

Eigen::MatrixXd apply(const Eigen::MatrixXd& x) { return eigenvalues().asDiagonal() * x; }

}  // namespace

TEST_CASE("eigenvectors of a Krylov iteration that is stopped at any step are eigenvectors", "[response]") {
  int steps = 0;
  const KrylovResult all =
      krylov(apply, start(), {.wanted = wanted_modes, .proceed = [&] { return ++steps > 0; }});
  REQUIRE(all.values.size() == wanted_modes);
  // There is room for this many columns until a restart.
  REQUIRE(steps * block_width > 2 * (2 * wanted_modes + 8 * block_width + 60));
  Eigen::Index most = 0;
  for (int last = 0; last < steps; ++last) {
    CAPTURE(last);
    int step = 0;
    const KrylovResult part =
        krylov(apply, start(), {.wanted = wanted_modes, .proceed = [&] { return step++ < last; }});
    most = std::max(most, part.values.size());
    const Eigen::MatrixXd residual = apply(part.vectors) - part.vectors * part.values.asDiagonal();
    // The tolerance of the iteration, 1e-11 of an eigenvalue up to 4, and round-off of as many products.
    for (Eigen::Index k = 0; k < part.values.size(); ++k) CHECK(residual.col(k).norm() < 5e-11);
    for (Eigen::Index k = 0; k < part.values.size(); ++k)
      CHECK(std::abs(part.vectors.col(k).norm() - 1) < 1e-12);
  }
  CHECK(most > 0);
}
