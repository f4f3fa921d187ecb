#include "equilibrium/stiffness_factors.hpp"

#include "matrices.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using scree::response::StiffnessFactors;
using scree::test::Sparse;

namespace {

// Not symmetric, with a few entries in each row; seed changes their values and not their places.
Sparse matrix_of(int size, double seed) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < size; ++k) {
    entries.emplace_back(k, k, 3 + std::sin(seed + k));
    for (const int next : {k + 1, k + 17})
      if (next < size) {
        entries.emplace_back(k, next, std::cos(seed + 2 * k));
        entries.emplace_back(next, k, std::sin(seed * 2 + k));
      }
  }
  Sparse a(size, size);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

}  // namespace

// Conditions of 1e3: round-off of 1e-13. Up to 100 rows factors are dense, above sparse; the second matrix
// has the entries of the first in the same places, the third has others.
TEST_CASE("factors of a stiffness with a diagonal solve as dense ones do", "[response]") {
  for (const int size : {1, 100, 101, 300}) {
    CAPTURE(size);
    StiffnessFactors factors;
    CHECK_FALSE(factors);
    for (const Sparse& stiffness :
         {matrix_of(size, 1), matrix_of(size, 2), Sparse(matrix_of(size, 3) * matrix_of(size, 4))}) {
      const Eigen::VectorXd diagonal = Eigen::VectorXd::LinSpaced(size, 0, 1),
                            load = Eigen::VectorXd::LinSpaced(size, 1, 2);
      REQUIRE(factors.factorise(stiffness, diagonal));
      CHECK(factors);
      Eigen::MatrixXd dense = stiffness;
      dense.diagonal() += diagonal;
      const Eigen::VectorXd exact = dense.partialPivLu().solve(load);
      CHECK((factors.solve(load) - exact).norm() < 1e-11 * exact.norm());
    }
    factors.discard();
    CHECK_FALSE(factors);
  }
}

TEST_CASE("a large matrix with an empty row is singular", "[response]") {
  Sparse stiffness = matrix_of(200, 1);
  stiffness.prune([](Eigen::Index row, Eigen::Index column, double) { return row != 7 && column != 7; });
  StiffnessFactors factors;
  CHECK_FALSE(factors.factorise(stiffness, Eigen::VectorXd::Zero(200)));
  CHECK(factors.factorise(stiffness, Eigen::VectorXd::Ones(200)));
}
