#pragma once

#include <atomic>
#include <complex>
#include <memory>

#include <Eigen/SparseCore>

namespace scree::response {

// A sparse matrix by columns, of equal numbers of rows and columns.
struct SparseView {
  int size;
  const int* outer;
  const int* inner;
  const double* values;
};

inline SparseView view_of(const Eigen::SparseMatrix<double>& a) {
  return {int(a.rows()), a.outerIndexPtr(), a.innerIndexPtr(), a.valuePtr()};
}
inline Eigen::SparseMatrix<double> copy_of(const SparseView& view) {
  return Eigen::Map<const Eigen::SparseMatrix<double>>(view.size, view.size, view.outer[view.size],
                                                       view.outer, view.inner, view.values);
}

// Neighbouring frequencies, their loads and the results. Arrays of vectors are stored column by column.
struct BandWindow {
  int count;
  const double* omega;               // (rad/s) (count) ascending
  const std::complex<double>* load;  // (size, count)
  double tolerance;
  bool single_precision;            // factorise in single precision
  std::complex<double>* amplitude;  // (size, count)
  double* residual;                 // (count)
  double* error;                    // (count) NaN if the factorised matrix is singular
  const std::atomic<bool>* stop;    // null, or set by others to end early
};

// Solves a window (K + iωC − ω²M) q = f; `solve` may be called by several threads at once.
class BandBackend {
 public:
  virtual ~BandBackend() = default;
  // Returns the number of basis vectors. The results are of no use after a stop.
  virtual int solve(const BandWindow& window) const = 0;
};

// A − σB = L D Lᵀ, A real and symmetric, B diagonal.
class ShiftedFactors {
 public:
  virtual ~ShiftedFactors() = default;
  // Replaces the columns of x (size, columns) by (A − σB)⁻¹ x.
  virtual void solve(double* x, int columns) const = 0;
  virtual double shift() const = 0;  // σ
  // Negative eigenvalues of A − σB, by Sylvester's law of inertia.
  virtual int negative() const = 0;
  // Estimate of the round-off of this number, as a difference from A − σB: eigenvalues nearer to 0 than this
  // may have either sign.
  virtual double margin() const = 0;
  // Whether a pivot is 0 within its round-off, so that an eigenvalue is likely to be that near to 0.
  virtual bool has_null_pivot() const = 0;
};

// Several threads may call it at once.
class ShiftBackend {
 public:
  virtual ~ShiftBackend() = default;
  virtual std::unique_ptr<ShiftedFactors> factorise(double shift) const = 0;
};

constexpr int band_backend_version = 4;

// Provided by the library, which is compiled for several instruction levels: dense products take most of its
// time.
class BandBackendFactory {
 public:
  virtual ~BandBackendFactory() = default;
  // The views must outlive the backend. mass: diagonal.
  virtual std::unique_ptr<BandBackend> create(const SparseView& stiffness, const SparseView& damping,
                                              const double* mass) const = 0;
  // stiffness: symmetric; mass: diagonal. Both are copied.
  virtual std::unique_ptr<ShiftBackend> create_shifts(const SparseView& stiffness,
                                                      const double* mass) const = 0;
};

}  // namespace scree::response
