#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include <scree/response/linear_system.hpp>

namespace scree::response {

class MassWeighted;
class ShiftBackend;
class ShiftedFactors;

// A number of modes below a value of ω², by the inertia of a factorisation, whose round-off moves ω². The
// number is certain if it is moved by less than UndampedSystem::rounding() or 1e-8 ω², so that only modes
// that near to the value may be on the wrong side. It is not certain if pivots have grown until their
// round-off is larger, or if a pivot is 0 within its round-off, as at the ω² of a mode.
struct ModeCount {
  std::size_t modes = 0;
  bool certain = true;
};
// "<what>; <cure>" of counts that are not certain.
std::string uncertain_warning(const std::string& which);

// The undamped system K_s q = ω² M q, K_s: symmetric part of K, prepared for factorisations of K_s − ω²M.
// There are as many modes as masses above 0; walls without mass follow the bodies at once.
class UndampedSystem {
 public:
  // The system must outlive this. Throws Error if the library of factorisations is missing.
  explicit UndampedSystem(const LinearSystem& system);
  ~UndampedSystem();
  UndampedSystem(const UndampedSystem&) = delete;
  UndampedSystem& operator=(const UndampedSystem&) = delete;

  std::size_t modes() const { return std::size_t(heavy_.size()); }
  // Number of modes with ω² below a value (1/s²), by the inertia of K_s − ω²M. Several threads may call it at
  // once.
  ModeCount count_below(double square_frequency) const;
  // Upper bound of all ω² (1/s²), by Gershgorin.
  double largest() const { return largest_; }
  // Modes with |ω²| below this (1/s²) are floppy: 0 within round-off.
  double rounding() const { return 1e-11 * largest_; }
  // |K − Kᵀ|/|K| in mass-weighted coordinates √M q.
  double asymmetry() const { return asymmetry_; }

  // For the search for modes and static_solution.cpp.
  const LinearSystem& system() const { return system_; }
  const MassWeighted& weighted() const { return *weighted_; }
  const Eigen::SparseMatrix<double>& symmetric_stiffness() const { return symmetric_; }
  const std::vector<Eigen::Index>& heavy() const { return heavy_; }
  std::unique_ptr<ShiftedFactors> factorise(double square_frequency) const;
  ModeCount count_below(const ShiftedFactors& factors) const;  // below the ω² of a factorisation

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
