#include "steady_state.hpp"

#include <algorithm>

namespace scree::spectrum {

namespace {

constexpr std::size_t fewest_blocks = 4;

}  // namespace

std::complex<double> SteadyState::limit(std::size_t column, std::size_t last) const {
  const std::complex<double> a = blocks_[last - 2][column].response, b = blocks_[last - 1][column].response,
                             c = blocks_[last][column].response;
  const std::complex<double> curvature = (c - b) - (b - a);
  // From differences that are all round-off or noise no transient follows.
  if (std::abs(c - b) > std::abs(b - a) || std::abs(curvature) == 0) return c;
  return c - (c - b) * (c - b) / curvature;
}

std::vector<SweepPoint::Column> SteadyState::limits() const {
  std::vector<SweepPoint::Column> found = blocks_.back();
  if (blocks_.size() < fewest_blocks) return found;
  const std::size_t last = blocks_.size() - 1;
  for (std::size_t c = 0; c < found.size(); ++c) {
    found[c].response = limit(c, last);
    found[c].error = std::abs(found[c].response - limit(c, last - 1));
  }
  return found;
}

bool SteadyState::is_reached() const {
  if (blocks_.size() < fewest_blocks) return false;
  const std::vector<SweepPoint::Column> found = limits();
  for (std::size_t c = 0; c < scales_.size(); ++c)
    if (!(found[c].error <= tolerance_ * std::max(std::abs(found[c].response), scales_[c]))) return false;
  return true;
}

}  // namespace scree::spectrum
