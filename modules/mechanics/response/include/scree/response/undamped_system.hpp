#pragma once

#include <cstddef>
#include <memory>

#include <scree/response/linear_system.hpp>

namespace scree::response {

class MassWeighted;
class ShiftBackend;
class ShiftedFactors;

// K_s q = ω² M q, the motions of a system without damping, K_s: symmetric part of K. Prepared for factorisations of
// K_s − ω²M. There are as many modes as masses above 0; walls without mass follow the others at once.
class UndampedSystem {
 public:
  // The system must outlive this. Throws Error if the library of factorisations is missing.
  explicit UndampedSystem(const LinearSystem& system);
  ~UndampedSystem();
  UndampedSystem(const UndampedSystem&) = delete;
  UndampedSystem& operator=(const UndampedSystem&) = delete;

  std::size_t modes() const { return std::size_t(heavy_.size()); }
  // Modes with ω² below a value (1/s²), by the inertia of K_s − ω²M: exact but for modes as near to it as
  // round-off, 1e-14 of largest(). May be called by several threads at once.
  std::size_t count_below(double square_frequency) const;
  // Bound of all ω² (1/s²), by Gershgorin.
  double largest() const { return largest_; }
  // Modes with |ω²| below are floppy: 0 within round-off (1/s²).
  double rounding() const { return 1e-11 * largest_; }
  // |K − Kᵀ|/|K| in mass-weighted coordinates √M q.
  double asymmetry() const { return asymmetry_; }

  // For modes and static solutions; see mass_weighted.hpp.
  const LinearSystem& system() const { return system_; }
  const MassWeighted& weighted() const { return *weighted_; }
  const Eigen::SparseMatrix<double>& symmetric_stiffness() const { return symmetric_; }
  const std::vector<Eigen::Index>& heavy() const { return heavy_; }
  std::unique_ptr<ShiftedFactors> factorise(double square_frequency) const;
  std::size_t count_below(const ShiftedFactors& factors) const;  // below the ω² of a factorisation

 private:
  const LinearSystem& system_;
  std::unique_ptr<MassWeighted> weighted_;
  Eigen::SparseMatrix<double> symmetric_;
  std::vector<Eigen::Index> heavy_;  // numbers with a mass above 0
  std::size_t negative_massless_ = 0;
  double largest_ = 0, asymmetry_ = 0;
  std::unique_ptr<ShiftBackend> backend_;
};

}  // namespace scree::response
