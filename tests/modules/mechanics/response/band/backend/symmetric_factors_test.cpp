#include "band/band_library.hpp"
#include "ill_conditioned.hpp"
#include "matrices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>
#include <catch2/catch.hpp>

#include <scree/response/undamped_system.hpp>

#if SCREE_TEST_MUMPS
#include <dmumps_c.h>
#endif

using namespace scree;
using namespace scree::response;
using scree::test::Sparse;

namespace {

constexpr double round_off = std::numeric_limits<double>::epsilon();

// Counts and solutions by a factorisation are compared with those by all eigenvalues, whose round-off is
// below size × epsilon × |A| (backward stable).
struct Oracle {
  const Sparse& a;
  double norm;
  Eigen::VectorXd eigenvalues;

  explicit Oracle(const Sparse& matrix) : a(matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(matrix),
                                                                Eigen::EigenvaluesOnly);
    eigenvalues = solver.eigenvalues();
    norm = eigenvalues.cwiseAbs().maxCoeff();
  }

  double error() const { return double(a.rows()) * round_off * norm; }
  int below(double shift) const { return int((eigenvalues.array() < shift).count()); }
  // Distance to the nearest eigenvalue.
  double distance(double shift) const { return (eigenvalues.array() - shift).abs().minCoeff(); }
};

std::unique_ptr<ShiftBackend> shifts_of(const Sparse& a) {
  const Eigen::VectorXd mass = Eigen::VectorXd::Ones(a.rows());
  return band_library().create_shifts(view_of(a), mass.data());
}

// Values between and close beside eigenvalues.
std::vector<double> shifts_between(const Oracle& oracle, int count) {
  std::vector<double> shifts;
  const Eigen::Index size = oracle.eigenvalues.size();
  for (int k = 1; k < count; ++k) {
    const Eigen::Index i = (size - 1) * k / count;
    const double low = oracle.eigenvalues[i], gap = oracle.eigenvalues[i + 1] - low;
    for (const double share : {0.5, 1e-3, 1 - 1e-6}) shifts.push_back(low + share * gap);
  }
  return shifts;
}

#if SCREE_TEST_MUMPS
// Negative pivots of a general symmetric factorisation with MUMPS.
int negative_by_mumps(const Sparse& a, double shift) {
  std::vector<int> rows, columns;
  std::vector<double> values;
  for (int j = 0; j < a.cols(); ++j)
    for (Sparse::InnerIterator entry(a, j); entry; ++entry) {
      if (entry.row() < j) continue;
      rows.push_back(int(entry.row()) + 1), columns.push_back(j + 1);
      values.push_back(entry.value() - (entry.row() == j ? shift : 0));
    }
  DMUMPS_STRUC_C mumps = {};
  mumps.par = 1, mumps.sym = 2, mumps.comm_fortran = -987654;
  mumps.job = -1;
  dmumps_c(&mumps);
  for (const int quiet : {0, 1, 2, 3}) mumps.icntl[quiet] = 0;
  mumps.icntl[12] = 1;  // one process for the last front, for exact inertia
  mumps.n = int(a.rows()), mumps.nnz = std::int64_t(values.size());
  mumps.irn = rows.data(), mumps.jcn = columns.data(), mumps.a = values.data();
  mumps.job = 4;
  dmumps_c(&mumps);
  const int negative = mumps.infog[11], failure = mumps.infog[0];
  mumps.job = -2;
  dmumps_c(&mumps);
  REQUIRE(failure == 0);
  return negative;
}
#endif

// A count may differ from that of the eigenvalues by those that are nearer to the shift than the stated
// margin. The resolution of certain counts is that of UndampedSystem::count_below.
void check_counts(const Sparse& a, int count) {
  const Oracle oracle(a);
  const auto backend = shifts_of(a);
  std::size_t certain = 0, all = 0;
  for (const double shift : shifts_between(oracle, count)) {
    const auto factors = backend->factorise(shift);
    const double doubt = factors->margin() + oracle.error();
    CAPTURE(shift, factors->margin() / oracle.norm, oracle.distance(shift) / oracle.norm);
    CHECK(factors->negative() >= oracle.below(shift - doubt));
    CHECK(factors->negative() <= oracle.below(shift + doubt));
    const double resolution = std::max(1e-11 * oracle.norm, 1e-8 * std::abs(shift));
    if (oracle.distance(shift) < 2 * resolution) continue;
    ++all;
    if (factors->has_null_pivot() || factors->margin() > resolution) continue;
    ++certain;
    CHECK(factors->negative() == oracle.below(shift));
#if SCREE_TEST_MUMPS
    CHECK(factors->negative() == negative_by_mumps(a, shift));
#endif
  }
  // Nearly all counts are certain, or nothing would be said of them.
  CHECK(all > std::size_t(count));
  CHECK(10 * certain >= 9 * all);
}

}  // namespace

TEST_CASE("modes of ill-conditioned packings are counted as by all eigenvalues and by MUMPS", "[response]") {
  const auto check = [](const LinearSystem& system) {
    CAPTURE(system.freedom.size());
    check_counts(UndampedSystem(system).symmetric_stiffness(), 40);
  };
  SECTION("nearly floppy") { check(test::nearly_floppy(12)); }
  SECTION("sizes 1:30") { check(test::large_and_small(4)); }
  SECTION("stiffnesses 1:1e6") { check(test::stiff_and_soft(12)); }
}

// Twenty dense blocks of 20 are coupled to a last one alone. Each has an eigenvalue next to 0: eliminated by
// itself, it leaves numbers that are larger than those of the matrix by its reciprocal, whose round-off is
// then as much larger.
TEST_CASE("counts say how far round-off of grown pivots moves them", "[response]") {
  constexpr int width = 20, blocks = 20;
  for (const double least : {1e-2, 1e-6, 1e-10, 1e-14}) {
    std::mt19937 engine(5);
    const auto random = [&engine] { return double(engine()) / 4294967295.0 - 0.5; };
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int row, int column, double value) {
      entries.emplace_back(row, column, value);
      if (row != column) entries.emplace_back(column, row, value);
    };
    const int last = width * blocks;
    for (int block = 0; block <= blocks; ++block) {
      Eigen::MatrixXd basis = Eigen::MatrixXd::NullaryExpr(width, width, random);
      basis = Eigen::MatrixXd(Eigen::HouseholderQR<Eigen::MatrixXd>(basis).householderQ());
      Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(width, random);
      values.array() += values.array().sign() * 0.1;
      if (block < blocks) values[0] = least * (block % 2 == 0 ? 1 : -1);
      const Eigen::MatrixXd dense = basis * values.asDiagonal() * basis.transpose();
      for (int i = 0; i < width; ++i) {
        for (int k = 0; k <= i; ++k) add(width * block + i, width * block + k, dense(i, k));
        for (int k = 0; k < width && block < blocks; ++k) add(last + k, width * block + i, random());
      }
    }
    Sparse a(last + width, last + width);
    a.setFromTriplets(entries.begin(), entries.end());
    const Oracle oracle(a);
    const auto factors = shifts_of(a)->factorise(0);
    const double doubt = factors->margin() + oracle.error();
    CAPTURE(least, factors->margin());
    CHECK(factors->negative() >= oracle.below(-doubt));
    CHECK(factors->negative() <= oracle.below(doubt));
    // Numbers of about 1/least are added, some of them hundred times smaller or larger.
    CHECK(factors->margin() > 0.01 * round_off / least);
    CHECK(factors->margin() < 100 * round_off * std::max(1.0, 1 / least));
  }
}
