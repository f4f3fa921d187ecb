#pragma once

#include <memory>

namespace scree::response {

// A − σB = L D Lᵀ, A real and symmetric, B diagonal.
class ShiftedFactors {
 public:
  virtual ~ShiftedFactors() = default;
  // Replaces the columns of x (size, columns) by (A − σB)⁻¹ x.
  virtual void solve(double* x, int columns) const = 0;
  // Negative eigenvalues of A − σB, by Sylvester's law of inertia.
  virtual int negative() const = 0;
};

// May be called by several threads at once.
class ShiftBackend {
 public:
  virtual ~ShiftBackend() = default;
  virtual std::unique_ptr<ShiftedFactors> factorise(double shift) const = 0;
};

}  // namespace scree::response
