#pragma once

#include <vector>

#include <Eigen/Core>

#include <scree/response/found_modes.hpp>

namespace scree::response {

// Modes that are computed beyond those that are wanted, for gaps between them.
inline constexpr Eigen::Index spare_modes = 2;

// Modes of the symmetric part of K that are found so far, in the coordinates √M q of all degrees of freedom.
class ModeSpan {
 public:
  using Matrix = Eigen::MatrixXd;
  using Index = Eigen::Index;

  // Both must outlive this.
  ModeSpan(const UndampedSystem& system, const ModeSearch& search);

  // Adds `wanted` further modes next to the shift, or above it.
  void find(const ShiftedFactors& factors, Index wanted, bool both_sides);

  Index size() const { return modes_.cols(); }
  const Matrix& modes() const { return modes_; }                   // one column each
  const std::vector<double>& squares() const { return squares_; }  // ω² of each (1/s²)
  // Rows of degrees of freedom that have a mass.
  Matrix heavy_part(const Matrix& all) const;
  // Columns without their parts along the modes.
  Matrix across(const Matrix& all) const;

 private:
  // Adds the modes in the span of vectors that satisfy the equations of massless walls.
  void add(Matrix vectors);
  // The inverse, for components with mass and across the modes that are found already.
  Matrix invert(const ShiftedFactors& factors, const Matrix& heavy) const;
  Matrix solved(const ShiftedFactors& factors, const Matrix& heavy) const;
  Matrix without_found(const Matrix& heavy) const;
  Matrix random(Index columns) const;

  const UndampedSystem& system_;
  const ModeSearch& search_;
  Matrix modes_;
  std::vector<double> squares_;
};

}  // namespace scree::response
