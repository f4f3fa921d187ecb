#pragma once

#include "sweep_points.hpp"

#include <vector>

namespace scree::spectrum {

// The limit of the responses of successive blocks of periods. The transient of one mode is multiplied by the
// same complex number from block to block, so that the limit follows from three blocks (Aitken's Δ² process);
// the change of the limit from one block to the next is its error.
class SteadyState {
 public:
  // tolerance: of the error, over the larger of the limit and its scale, for each column that has a scale.
  SteadyState(double tolerance, std::vector<double> scales)
      : tolerance_(tolerance), scales_(std::move(scales)) {}

  void add(std::vector<SweepPoint::Column> block) { blocks_.push_back(std::move(block)); }
  bool is_reached() const;
  // Limits with their errors; with fewer than four blocks the last one as it is.
  std::vector<SweepPoint::Column> limits() const;

 private:
  std::complex<double> limit(std::size_t column, std::size_t last) const;

  double tolerance_;
  std::vector<double> scales_;
  std::vector<std::vector<SweepPoint::Column>> blocks_;
};

}  // namespace scree::spectrum
