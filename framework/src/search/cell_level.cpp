#include "search/cell_level.hpp"

#include "bodies/counting_sort.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

// Chooses at most about four cells per body. The number is divided evenly among the axes; axes that need
// fewer cells leave the remainder to the others.
void CellLevel::choose_cells(const Vec3& lower, const Vec3& upper, double reach, int dimension,
                             std::size_t bodies) {
  std::array<double, 3> needed = {1, 1, 1};
  for (int k = 0; k < dimension; ++k) needed[k] = std::max(1.0, std::floor((upper[k] - lower[k]) / reach));
  std::array<int, 3> axes = {0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](int a, int b) { return needed[a] < needed[b]; });
  double left = 4.0 * double(bodies);
  for (int n = 0; n < 3; ++n) {
    const int k = axes[n];
    const double share = std::max(3.0, std::ceil(std::pow(left, 1.0 / (3 - n))));
    wrapped_[k] = !periodic_[k] && needed[k] > share;
    cells_[k] = int(std::min(needed[k], share));
    left /= cells_[k];
    const double length = upper[k] - lower[k];
    // One cell needs no width; the width of a tiny cell would have no finite reciprocal.
    inverse_width_[k] = wrapped_[k] ? 1 / reach : cells_[k] > 1 ? cells_[k] / length : 0;
  }
}

void CellLevel::bin(std::span<const Sphere> bodies, int dimension, const Domain& domain, const Vec3& lower,
                    const Vec3& upper, double reach, const std::vector<std::uint32_t>& members) {
  lower_ = lower;
  periodic_ = domain.periodic;
  choose_cells(lower, upper, reach, dimension, members.size());
  const std::size_t total = std::size_t(cells_[0]) * std::size_t(cells_[1]) * std::size_t(cells_[2]);

  cell_.resize(members.size());
  for (std::size_t m = 0; m < members.size(); ++m) {
    const Vec3& x = bodies[members[m]].position;
    const int index[3] = {cell_of(0, x[0]), cell_of(1, x[1]), cell_of(2, x[2])};
    cell_[m] = std::uint32_t((std::size_t(index[2]) * cells_[1] + index[1]) * cells_[0] + index[0]);
  }
  binned_.resize(members.size());
  counting_sort(
      total, first_,
      [&](const auto& visit) {
        for (std::size_t m = 0; m < members.size(); ++m) visit(m);
      },
      [&](std::size_t m) { return cell_[m]; },
      [&](std::size_t m, std::size_t index) {
        binned_[index] = {bodies[members[m]], members[m]};
      });
}

CellLevel::Spans CellLevel::spans(int axis, int middle) const {
  const int n = cells_[axis];
  const int low = std::max(middle - 1, 0), high = std::min(middle + 1, n - 1);
  if (!(periodic_[axis] || wrapped_[axis]) || n <= 2) return {1, {low}, {high}};
  if (n == 3) return {1, {0}, {2}};
  if (middle == 0) return {2, {low, n - 1}, {high, n - 1}};
  if (middle == n - 1) return {2, {low, 0}, {high, 0}};
  return {1, {low}, {high}};
}

}  // namespace scree
