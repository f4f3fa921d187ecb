#pragma once

#include "band/backend/shift_backend.hpp"

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

// Neighbouring frequencies, the loads and what is found. Arrays of vectors are columns one behind another.
struct BandWindow {
  int count;
  const double* omega;               // (rad/s) (count) ascending
  const std::complex<double>* load;  // (size, count)
  double tolerance;
  bool single_precision;            // of the factorisation
  std::complex<double>* amplitude;  // (size, count)
  double* residual;                 // (count)
  double* error;                    // (count) NaN if the factorised matrix is singular
  const std::atomic<bool>* stop;    // null, or set by others to end early
};

// Solves a window (K + iωC − ω²M) q = f; `solve` may be called by several threads at once.
class BandBackend {
 public:
  virtual ~BandBackend() = default;
  // Returns the number of basis vectors. Nothing that it found is of use if it was stopped.
  virtual int solve(const BandWindow& window) const = 0;
};

constexpr int band_backend_version = 3;

// Made by the library, compiled for several instruction levels: dense products take nearly all of its time.
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
